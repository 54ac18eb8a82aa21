#include "base/version.hpp"

#include "riffle_build.hpp"
#include "riffle_revision.hpp"

namespace riffle::inline base {

std::string version() { return build::version; }

std::string build_description() {
    return std::string(build::compiler) + ", " + build::type + ", revision " + build::revision;
}

}  // namespace riffle::inline base

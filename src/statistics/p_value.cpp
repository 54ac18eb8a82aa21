#include "statistics/p_value.hpp"

#include <fmt/format.h>

namespace riffle::inline statistics {

std::string p_value_text(double p) {
    return p < least_p_value ? fmt::format("< {:.0e}", least_p_value) : fmt::format("= {:.2g}", p);
}

}  // namespace riffle::inline statistics

#include "cli/positive_number.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace riffle::inline cli {

CLI::Validator positive_number() {
    return {[](const std::string& text) {
                double value = 0.0;
                const bool is_number = CLI::detail::lexical_cast(text, value) && std::isfinite(value);
                return is_number && value > 0.0
                           ? std::string{}
                           : fmt::format("must be a number greater than 0, but is {}", text);
            },
            "", "positive number"};
}

}  // namespace riffle::inline cli

#include "cli/printed_number.hpp"

#include <fmt/format.h>

namespace riffle::inline cli {

std::string printed_number(double value) { return fmt::format("{:.4g}", value); }

nlohmann::ordered_json optional_number(const std::optional<double>& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

}  // namespace riffle::inline cli

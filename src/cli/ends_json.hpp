#pragma once

#include <nlohmann/json.hpp>

#include "solver/forecast.hpp"

namespace riffle::inline cli {

/// What a case asks for at its open ends, SI units; each quantity as [least, largest] during the run, null
/// where it is not known. Null for a case without open ends.
[[nodiscard]] nlohmann::ordered_json ends_json(const Forecast& f);

}  // namespace riffle::inline cli

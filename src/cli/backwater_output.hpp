#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "cli/backwater_figure.hpp"

namespace riffle::inline cli {

/// Everything that the outputs of `riffle backwater` tell.
struct Backwater {
    std::string friction;  ///< "column twin" ...
    double discharge = 0.0;
    double length = 0.0;
    double width = 0.0;  ///< of the channel, m
    SteadyChannel channel;
    VariedFlow flow;
    std::vector<std::string> notes;
};

/// Places along the whole channel, and both sides of a jump: even ones, or for a figure dense at the ends of
/// each curve, where the surface may stand upright.
enum class Places { even, dense_at_ends };

[[nodiscard]] std::vector<BackwaterStation> backwater_stations(const Backwater& b, int count,
                                                               Places places = Places::even);

/// Print what was found and the table of stations to the terminal.
void print_backwater(const Case& c, const Backwater& b, const std::vector<BackwaterStation>& stations);

/// The table of stations, a column each with its unit.
[[nodiscard]] std::string backwater_csv(const std::vector<BackwaterStation>& stations);

/// Everything, in SI units.
[[nodiscard]] nlohmann::ordered_json backwater_json(const Case& c, const Backwater& b,
                                                    const std::vector<BackwaterStation>& stations);

}  // namespace riffle::inline cli

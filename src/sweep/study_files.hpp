#pragma once

#include <filesystem>
#include <string>

#include "analysis/figure.hpp"
#include "sweep/study.hpp"

namespace riffle::inline sweep {

/// The table of a sweep as CSV: a line for each run with its values and outcomes, SI.
[[nodiscard]] std::string sweep_csv(const SweepStudy& sweep);

/// The sweep for machines: JSON, SI units, described in docs/sweep.md.
[[nodiscard]] std::string sweep_json(const SweepStudy& sweep);

/// The figures of a sweep: each outcome against the first key that refines the solution, else the first that
/// is a number, else the first, with the twin and Richardson's limit; departures also on logarithmic axes
/// with their fitted order.
[[nodiscard]] Analysis sweep_figures(const SweepStudy& sweep);

/// Names of the values along the x axis of the figures; empty where it is a scale of numbers.
[[nodiscard]] std::vector<std::string> figure_categories(const SweepStudy& sweep);

/// The page of a sweep: HTML that needs nothing beside itself.
[[nodiscard]] std::string sweep_page(const SweepStudy& sweep);

/// The tables of a sweep as text for a terminal.
[[nodiscard]] std::string sweep_text(const SweepStudy& sweep);

/// Files of a sweep in its folder.
struct SweepFiles {
    std::filesystem::path folder;
    [[nodiscard]] std::filesystem::path csv() const { return folder / "sweep.csv"; }
    [[nodiscard]] std::filesystem::path json() const { return folder / "sweep.json"; }
    [[nodiscard]] std::filesystem::path page() const { return folder / "sweep.html"; }
};

/// Write them all. Throws FileError.
void write_sweep(const SweepStudy& sweep, const SweepFiles& files);

}  // namespace riffle::inline sweep

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/figure.hpp"
#include "case/case.hpp"
#include "record/run_results.hpp"
#include "report/field_data.hpp"
#include "report/surface_frames.hpp"

namespace riffle::inline report {

/// What the report shows beside the figures and findings of the analysis, collected from one results file.
/// What the file lacks is empty.
struct ReportData {
    std::filesystem::path source;
    std::string title, riffle_version, build, created;
    bool complete = false;
    std::string failure;  ///< what the run failed with; empty where it did not
    Case flow;            ///< the case, from its text in the file
    Numbers summary;
    Numbers column;   ///< of the column twin
    Numbers section;  ///< of the section twin, between side walls
    SeriesTable series;
    double window_start = 0, window_end = 0;  ///< averaging window, s; both 0 before there is one
    double profile_samples = 0;
    std::optional<FieldPicture> field;
    std::optional<SurfaceFrames> surface_frames;
};

/// Collect the report's data, with a picture of the flow field of these frames; with all frames, the moving
/// surface as well. Throws FileError if the file's case is missing or cannot be read.
[[nodiscard]] ReportData collect_report_data(const RunResults& results,
                                             FieldFrames frames = FieldFrames::all);
[[nodiscard]] ReportData collect_report_data(const std::filesystem::path& results,
                                             FieldFrames frames = FieldFrames::all);

/// The same beside an analysis of the file: in the window that the analysis was asked for, and with the run's
/// summary over it, so that a page has one window.
[[nodiscard]] ReportData collect_report_data(const std::filesystem::path& results, const Analysis& analysis,
                                             FieldFrames frames = FieldFrames::all);

/// Simulated time that the series reach, s; 0 without series.
[[nodiscard]] double recorded_time(const ReportData& data);

}  // namespace riffle::inline report

#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "analysis/figure.hpp"
#include "report/diagnostics.hpp"
#include "report/report_data.hpp"

namespace riffle::inline report {

/// Mark of a size that should not exceed `bar`.
[[nodiscard]] Health mark_of(double size, double bar);
/// The same of a size that is known within `half_width`: not bad where its interval reaches down to the bar.
[[nodiscard]] Health mark_of(double size, double bar, double half_width);

/// A share in percent, with a minus sign that is one; the other with its sign in front.
[[nodiscard]] std::string percent(double share, int digits = 2);
[[nodiscard]] std::string signed_percent(double share);

/// The rows of the diagnostics table that flows of several kinds have, each a function that adds its row if
/// the file has what it needs. What only some kinds have derives from it.
class DiagnosticRows {
  public:
    DiagnosticRows(const ReportData& data, const Analysis& analysis) : data_(data), analysis_(analysis) {}

    /// Range of the density: over the averaging window of a channel, else over the whole run.
    void density();
    void order();
    void fluctuation();
    /// Particles that the run had to take out of the water.
    void particles_lost();

    [[nodiscard]] std::vector<Diagnostic> take() { return std::move(rows_); }

  protected:
    [[nodiscard]] std::optional<double> value(const Field& field) const {
        return find_value(data_.summary, field);
    }
    /// The finding of the analysis with this key; null if there is none.
    [[nodiscard]] const Finding* finding(const std::string& key) const;
    /// The part of a series inside the averaging window of a channel; all of it before there is a window, and
    /// of a flow that nothing drives.
    [[nodiscard]] std::span<const double> in_window(const Field& field) const;
    /// By how much the fastest water compresses itself where it hits a wall: its speed over that of sound.
    [[nodiscard]] double impact_compression() const;
    void add(Diagnostic row) { rows_.push_back(std::move(row)); }

    const ReportData& data_;
    const Analysis& analysis_;
    std::vector<Diagnostic> rows_;
};

// The rows of each kind of flow.
[[nodiscard]] std::vector<Diagnostic> diagnose_channel(const ReportData& data, const Analysis& analysis);
[[nodiscard]] std::vector<Diagnostic> diagnose_course(const ReportData& data, const Analysis& analysis);

}  // namespace riffle::inline report

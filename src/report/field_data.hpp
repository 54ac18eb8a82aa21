#pragma once

#include <optional>

#include "report/report_data.hpp"

namespace riffle {

/// The last stretch of the surface record: about five times the time in which the flow crosses the channel's
/// length, thinned to what a figure can show. Nothing if the record is missing or has fewer than two rows.
[[nodiscard]] std::optional<SurfaceRecord> read_surface(const ResultsReader& reader, const ReportData& data);

/// The last snapshot; of a long channel the first stretch that holds 20 000 particles. Nothing without
/// snapshots. In three dimensions the particles of a slice one spacing thick along the centreline.
[[nodiscard]] std::optional<Snapshot> read_snapshot(const ResultsReader& reader, const Case& c);

}  // namespace riffle

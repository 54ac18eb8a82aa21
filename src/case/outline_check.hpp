#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "case/case_check.hpp"
#include "case/outline.hpp"

namespace riffle::inline case_file {

/// What makes corners no outline; each is looked for where those before it are not found.
enum class OutlineFault {
    uneven,    ///< not as many values of x as of z
    few,       ///< fewer than three corners
    crossing,  ///< edges that cross or touch
};

/// Whether an outline has a fault; `name` stands before what is said of it, `second_axis` is that of its
/// second list.
[[nodiscard]] Findings outline_findings(const Outline& outline, OutlineFault fault,
                                        std::string_view name = "", std::string_view second_axis = "z");

/// The row of a check for a fault of an outline.
[[nodiscard]] CaseCheck outline_row(OutlineFault fault, std::vector<std::string> keys, std::string_view what,
                                    CheckCondition condition);

/// Whether an outline has no fault.
[[nodiscard]] bool is_simple(const Outline& outline);

/// A corner for messages: "(80 mm, 20 mm)".
[[nodiscard]] std::string corner_text(const Outline& outline, std::size_t i);

/// Most corners of all outlines together: each edge is compared with each other one.
inline constexpr std::size_t most_corners = 20000;

/// Corners of the outlines of the solids and of the water.
[[nodiscard]] std::size_t corners_of_outlines(const Case& c);

/// Whether all solids have their shapes: else another check has said what is missing.
[[nodiscard]] bool have_shapes(const Case& c);

/// Least and largest of some values.
struct Extent {
    double low = 0.0;
    double high = 0.0;

    explicit Extent(const std::vector<double>& values);
    [[nodiscard]] double size() const { return high - low; }
};

/// What a solid takes up along axis x, y or z at the start; nothing where its shape is not known.
[[nodiscard]] std::optional<Extent> extent_of(const Case& c, const Solid& solid, std::size_t axis);

/// The highest point of the solids that are part of the bed, m; none without them, or where their surfaces
/// were not read with the case.
[[nodiscard]] std::optional<double> highest_of_solid_bed(const Case& c);

}  // namespace riffle::inline case_file

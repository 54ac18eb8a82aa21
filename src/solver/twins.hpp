#pragma once

#include <cmath>
#include <optional>

#include "case/case.hpp"
#include "case/end_levels.hpp"
#include "column/column.hpp"
#include "column/section.hpp"
#include "column/section_start.hpp"
#include "ends/relaxation_between_ends.hpp"
#include "solver/start.hpp"

namespace riffle::inline solver {

/// The solutions of the mean flow that a run starts from and is compared with, as far as its case has them.
struct Twins {
    std::optional<ColumnResult> column;    ///< over the depth; in three dimensions of the wide channel
    std::optional<SectionResult> section;  ///< over the cross-section of a channel with side walls
    /// Section that the run starts from where it has none of its own (section_start_substitute()).
    std::optional<SectionResult> start_section;

    [[nodiscard]] const ColumnResult* column_or_null() const { return column ? &*column : nullptr; }
    [[nodiscard]] const SectionResult* section_or_null() const { return section ? &*section : nullptr; }

    /// Relaxation time of the flow, s; none where it is unknown.
    [[nodiscard]] std::optional<double> relaxation_time() const {
        const double time = section ? section->relaxation_time : column ? column->relaxation_time : 0.0;
        return std::isfinite(time) && time > 0.0 ? std::optional(time) : std::nullopt;
    }
    /// Velocity of the section for the start; empty without one.
    [[nodiscard]] SectionVelocity section_velocity() const {
        const SectionResult* const start = section ? &*section : start_section ? &*start_section : nullptr;
        return start != nullptr
                   ? SectionVelocity([start](double y, double z) { return start->velocity_at(y, z); })
                   : SectionVelocity();
    }
};

/// Relaxation time by which the flow of a run is tested for convergence, s: that of its twins, or of what
/// passes between open ends; none where it is not tested.
[[nodiscard]] inline std::optional<double> tested_relaxation_time(const Case& c, const Twins& twins) {
    return converges_between_ends(c) ? std::optional(relaxation_time_between_ends(c))
                                     : twins.relaxation_time();
}

/// Solve the twins that the case has.
[[nodiscard]] inline Twins solve_twins(const Case& c) {
    Twins twins;
    if (has_column(c)) twins.column = solve_column(c);
    if (has_section(c)) {
        twins.section = solve_section(c);
    } else if (const auto substitute = section_start_substitute(c)) {
        twins.start_section = solve_section(*substitute);
    }
    return twins;
}

}  // namespace riffle::inline solver

#pragma once

#include <span>
#include <string>

#include "analysis/figure.hpp"
#include "analysis/flow_record.hpp"
#include "case/flow_kind.hpp"

namespace riffle::inline analysis {

// The chapters of an analysis. Each adds its findings and figures to the analysis. A figure that a run should
// have but whose data the record lacks is added with the reason in `missing`; of a laboratory record, which
// never has everything, it is left out. Keys: docs/analysis.md.

void analyse_statistics(const FlowRecord& record, Analysis& analysis);
void analyse_profiles(const FlowRecord& record, Analysis& analysis);
void analyse_fits(const FlowRecord& record, Analysis& analysis);
void analyse_surface(const FlowRecord& record, Analysis& analysis);
void analyse_subsurface(const FlowRecord& record, Analysis& analysis);
void analyse_forces(const FlowRecord& record, Analysis& analysis);
/// What drives the water, what takes its energy, and what the scheme itself adds or takes.
void analyse_energy(const FlowRecord& record, Analysis& analysis);

/// Of flows that nothing drives steadily: levels, fronts, modes, energy and volume in time.
void analyse_course(const FlowRecord& record, Analysis& analysis);
/// Of channels with bodies: bed, bodies, level and energy line along the channel.
void analyse_along(const FlowRecord& record, Analysis& analysis);
/// Signs of health of the particles over time.
void analyse_particles(const FlowRecord& record, Analysis& analysis);

// Of runs in three dimensions, from their mean field in cells; of other records they add nothing.
void analyse_section(const FlowRecord& record, Analysis& analysis);
void analyse_secondary(const FlowRecord& record, Analysis& analysis);
void analyse_bed(const FlowRecord& record, Analysis& analysis);

/// The part of the chapter on the cross-section that is profiles: at the centreline, at the thesis'
/// distances from the wall, and across the channel.
void add_section_profiles(const FlowRecord& record, Analysis& analysis);

/// The part of the chapter on the cross-section that is profiles at distances from the side wall, of a run or
/// of points that a laboratory measured: velocity, stress, their departure from what was measured, and
/// profiles across the channel. Nothing without side walls.
void add_section_stations(const FlowRecord& record, Analysis& analysis);

/// The part of the chapter on the surface from plan maps: mean level and standard deviation over the plan.
/// Nothing without them.
void add_surface_plan(const FlowRecord& record, Analysis& analysis);

/// Maps of the time means of velocity, pressure and stress in the x-z plane, of a grid or around the
/// centreline of the mean field in three dimensions.
void add_plane_maps(const FlowRecord& record, Analysis& analysis);

/// The part of the fits that follows from the mean velocity: friction factors, Manning's n, Chezy's C,
/// Reynolds and Froude number (thesis 2.6-2.9). Nothing where no velocity is known.
void add_channel_numbers(const FlowRecord& record, Analysis& analysis);

/// A chapter of the analysis; its name is that of its findings and figures.
struct Chapter {
    std::string name;
    std::string title;
    void (*analyse)(const FlowRecord& record, Analysis& analysis);
    /// Whether it has something to say of runs of this kind; null: of all.
    bool (*applies)(FlowKind kind) = nullptr;
};

/// All chapters in the order of the analysis.
[[nodiscard]] std::span<const Chapter> analysis_chapters();

/// Whether a chapter has something to say of a record: of a run by its kind of flow, of a laboratory record
/// always.
[[nodiscard]] bool applies(const Chapter& chapter, const FlowRecord& record);

/// Analyse a record: all chapters that its kind of flow has, or the one named, with a warning where it is
/// made for other kinds. Throws InputError for an unknown chapter (naming those that there are) and what
/// reading the record throws.
[[nodiscard]] Analysis analyse(const FlowRecord& record, const std::string& chapter = {});

}  // namespace riffle::inline analysis

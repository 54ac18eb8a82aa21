#pragma once

#include <string>
#include <vector>

#include "analysis/figure.hpp"
#include "analysis/flow_record.hpp"

namespace riffle::inline analysis {

/// What a section across an open channel recorded while what its ends give changes, in running means over
/// passing_stretch().
struct PassingSection {
    double x = 0.0;                 ///< m
    int end = 0;                    ///< 1: at the inflow, 2: at the outflow
    std::vector<double> time;       ///< s
    std::vector<double> discharge;  ///< m2/s in two dimensions, m3/s of the whole width in three
    std::vector<double> depth;      ///< m, over what the water stands on; empty where it was not recorded
};

/// The sections of the instruments in their order downstream, each place once.
[[nodiscard]] std::vector<PassingSection> passing_sections(const FlowRecord& record);

/// The one at the inflow (1) or at the outflow (2); null where there is none.
[[nodiscard]] const PassingSection* section_at_end(const std::vector<PassingSection>& sections, int end);

/// Stretch of time of the running means, s: surface waves pass a section in less.
[[nodiscard]] double passing_stretch(const Case& c);

/// The name of a section's place: `inflow`, `outflow`, or x after `along`.
[[nodiscard]] std::string place_of(const PassingSection& section, const char* inflow, const char* outflow,
                                   const char* along);

/// Keys, titles and first sentences of the captions of the figures of a passage.
struct PassageFigures {
    const char* discharges_key;
    const char* discharges_title;
    const char* discharges_caption;
    const char* depths_key;
    const char* depths_title;
    const char* loop_key;
    const char* loop_title;
    const char* loop_caption;
};

/// Discharge and depth at the sections over time, and one over the other.
void add_passage_figures(const FlowRecord& record, const std::vector<PassingSection>& sections,
                         const PassageFigures& words, Analysis& analysis);

}  // namespace riffle::inline analysis

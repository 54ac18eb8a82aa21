#pragma once

#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "report/comparison.hpp"

namespace riffle::inline report {

/// What a page of the thesis' figures holds: its chapters with simulations, and the paper of 2016.
enum class ThesisPart { two_dimensions = 4, three_dimensions = 5, both = 6, paper = 0 };

/// "4", "5", "6" or "paper"; nothing for other words.
[[nodiscard]] std::optional<ThesisPart> thesis_part(std::string_view word);

/// The figures of the thesis from finished runs. Chapter 4: the seven flow conditions in two dimensions side
/// by side, the closure against the original SPS model, the spacings; the paper: its case, with both
/// closures; chapter 5: conditions 1, 2, 5 and 8 in three dimensions between side walls, spacings and heights
/// of the roughness; chapter 6: two against three dimensions. Runs are known by their case, not by their
/// folder's name. Without `parts`: those of which a run is there (of no run: chapter 4), and the other runs;
/// with them: these alone, and no run that they do not show. What they lack is listed in `missing` with the
/// command that makes it. Throws as compare does, InputError where none of the runs is of the parts.
[[nodiscard]] Comparison thesis_figures(const std::vector<ReportSubject>& subjects,
                                        const std::set<ThesisPart>& parts = {});

}  // namespace riffle::inline report

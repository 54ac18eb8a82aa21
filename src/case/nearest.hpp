#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace riffle::inline case_file {

/// Edit distance with transpositions (optimal string alignment): the number of letters to insert, delete,
/// change or swap with a neighbour to make one text of the other.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// The known name that was probably meant: the nearest by edit distance, or one that contains the text (or is
/// contained in it); no value when none is near.
[[nodiscard]] std::optional<std::string> nearest_name(std::string_view text,
                                                      std::span<const std::string> known);

}  // namespace riffle::inline case_file

#pragma once

#include <map>
#include <string>
#include <string_view>

namespace riffle::inline report {

/// JSON for a script block: each < written as \u003c, so that no text in it can end the block.
[[nodiscard]] std::string escape_json_for_script(std::string_view json);

/// Put the parts where the page says {{name}}, in one pass: what a part contains is never read as a place.
/// Throws std::logic_error on a place without a part.
[[nodiscard]] std::string fill_page(std::string_view page,
                                    const std::map<std::string, std::string, std::less<>>& parts);

}  // namespace riffle::inline report

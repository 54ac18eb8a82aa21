#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "case/case.hpp"
#include "case/problems.hpp"

namespace riffle {

/// A combination of the method's options that makes no sense. The message of a case that has it and the
/// reference of the case file are made from the same row.
struct SchemeRule {
    std::vector<std::string> keys;  ///< whose values clash; the first one given is where the message points
    std::string_view combination;   ///< the values that clash, in words
    std::string_view reason;        ///< why, and what to do
    bool (*broken)(const Case&);    ///< whether a case has the combination
};

/// All of them.
[[nodiscard]] const std::vector<SchemeRule>& scheme_rules();

/// Adds the rules that a case breaks, with the values of their keys.
void validate_scheme(const Case& c, const Places& places, Problems& problems);

}  // namespace riffle

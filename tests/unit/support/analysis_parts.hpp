#pragma once

#include <gtest/gtest.h>

#include <string>

#include "analysis/figure_tools.hpp"

namespace riffle::testing {

/// The finding of an analysis with that key; fails the test without one.
inline const Finding& finding(const Analysis& analysis, const std::string& key) {
    const Finding* const found = find_finding(analysis, key);
    static const Finding none;
    if (found == nullptr) ADD_FAILURE() << "no finding " << key;
    return found == nullptr ? none : *found;
}

/// The figure with that key; fails the test without one.
inline const Figure& figure(const Analysis& analysis, const std::string& key) {
    static const Figure none;
    for (const Figure& each : analysis.figures) {
        if (each.key == key) return each;
    }
    ADD_FAILURE() << "no figure " << key;
    return none;
}

}  // namespace riffle::testing

#pragma once

#include <array>
#include <string>
#include <vector>

namespace riffle::inline particles {

/// Letters of the axes of a set in D dimensions.
template <int D>
constexpr auto axis_names = [] {
    if constexpr (D == 2) {
        return std::array<const char*, 2>{"x", "z"};
    } else {
        return std::array<const char*, 3>{"x", "y", "z"};
    }
}();

/// What the values of a field of a set of particles are: name in files, unit, meaning.
struct FieldInfo {
    std::string name;
    std::string unit;
    std::string long_name;
};

/// A field that a method or a component adds to a set: state like the others, sorted, saved and restored with
/// them. Without values until it is first resized; then it has one for each particle.
struct FurtherField {
    FieldInfo info;
    std::vector<double> values;
};

}  // namespace riffle::inline particles

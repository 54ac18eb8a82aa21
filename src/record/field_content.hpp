#pragma once

#include <string>
#include <utility>
#include <vector>

#include "output/dataset.hpp"
#include "record/field.hpp"

namespace riffle::inline record {

/// A dataset of results with the path, unit and long name of its field. `rows`: they are added to those in
/// the file, otherwise the dataset replaces.
[[nodiscard]] inline Dataset dataset_of(const Field& field, int dimensions, std::vector<std::size_t> shape,
                                        Dataset::Values values, bool rows = false) {
    return {.path = field.path(),
            .shape = std::move(shape),
            .values = std::move(values),
            .unit = field.unit.in(dimensions),
            .long_name = field.meaning.in(dimensions),
            .append = rows};
}

/// Add a one-dimensional array.
inline void add_field(Content& content, const Field& field, int dimensions, std::vector<double> values) {
    const std::size_t n = values.size();
    content.datasets.push_back(dataset_of(field, dimensions, {n}, std::move(values)));
}

/// Add an attribute of the field's group.
inline void add_field(Content& content, const Field& field, AttributeValue value) {
    content.attributes.push_back({.path = field.group->path, .name = field.name, .value = std::move(value)});
}

}  // namespace riffle::inline record

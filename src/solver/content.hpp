#pragma once

#include <string>
#include <utility>
#include <vector>

#include "output/dataset.hpp"

namespace riffle::inline solver {

/// Add a one-dimensional array to a file's content; it replaces one of the same path.
inline void add_array(Content& content, std::string path, std::vector<double> values, std::string unit,
                      std::string long_name) {
    const std::size_t n = values.size();
    content.datasets.push_back({.path = std::move(path),
                                .shape = {n},
                                .values = std::move(values),
                                .unit = std::move(unit),
                                .long_name = std::move(long_name)});
}

/// Add an attribute of the group or dataset `path` ("/": of the file).
inline void add_attribute(Content& content, std::string path, std::string name, AttributeValue value) {
    content.attributes.push_back(
        {.path = std::move(path), .name = std::move(name), .value = std::move(value)});
}

}  // namespace riffle::inline solver

#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace riffle::inline output {

/// Values that are made while they are written, block by block, so that a large array needs no copy.
template <class T>
struct StreamedValues {
    std::size_t count = 0;
    /// Fill a block with the values from the one numbered `first` on.
    std::function<void(std::size_t first, std::span<T> block)> fill;

    /// Unknown until they are made.
    bool operator==(const StreamedValues& /*other*/) const { return false; }
};

/// A named array on its way to or from a file.
struct Dataset {
    using Values = std::variant<std::vector<double>, std::vector<float>, std::vector<std::int64_t>,
                                std::vector<std::int32_t>, std::vector<std::uint8_t>, std::string,
                                StreamedValues<double>, StreamedValues<float>, StreamedValues<std::int64_t>,
                                StreamedValues<std::int32_t>>;
    std::string path;                ///< absolute path in the file, e.g. "/time_series/time"
    std::vector<std::size_t> shape;  ///< row-major; empty: scalar; ignored for a string
    Values values;
    std::string unit;  ///< SI, "1" for dimensionless
    std::string long_name;
    /// Rows along the first axis are added behind those already in the file; otherwise the dataset replaces.
    bool append = false;
};

/// Attribute of a group or dataset.
using AttributeValue = std::variant<double, std::int64_t, std::string>;
struct Attribute {
    std::string path;  ///< of the group or dataset it belongs to; "/" for the file
    std::string name;
    AttributeValue value;
};

/// Content to be put into a file in one atomic step.
struct Content {
    std::vector<Dataset> datasets;
    std::vector<Attribute> attributes;
    int compression = 4;  ///< deflate level of new large arrays and series in a results file; 0: none
};

}  // namespace riffle::inline output

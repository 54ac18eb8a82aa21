#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "record/field.hpp"

namespace riffle::inline record {

/// Numbers by field, SI: the attributes of a group such as `/summary`, in the order in which they were set.
class Numbers {
  public:
    [[nodiscard]] std::optional<double> find(const Field& field) const;
    [[nodiscard]] double value(const Field& field) const { return value(std::string(field.name)); }
    [[nodiscard]] double value(const std::string& name) const;  ///< NaN where there is none
    void set(const Field& field, double value) { set(std::string(field.name), value); }
    void set(const std::string& name, double value);

    /// By name.
    [[nodiscard]] const std::vector<std::pair<std::string, double>>& all() const { return all_; }

  private:
    std::vector<std::pair<std::string, double>> all_;
};

/// The number of a field; nothing where it is missing or not finite.
[[nodiscard]] std::optional<double> find_value(const Numbers& numbers, const Field& field);

}  // namespace riffle::inline record

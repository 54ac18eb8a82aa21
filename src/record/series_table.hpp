#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "record/field.hpp"

namespace riffle::inline record {

/// Time series by field, of equal length, SI.
class SeriesTable {
  public:
    /// The values of a field; empty where the record has none.
    [[nodiscard]] const std::vector<double>& operator[](const Field& field) const {
        static const std::vector<double> none;
        const auto found = columns_.find(field.name);
        return found == columns_.end() ? none : found->second;
    }
    [[nodiscard]] bool has(const Field& field) const { return !(*this)[field].empty(); }
    [[nodiscard]] bool empty() const { return columns_.empty(); }
    void set(const Field& field, std::vector<double> values) { columns_[field.name] = std::move(values); }

    /// Keep these rows alone, in this order.
    void keep_rows(const std::vector<std::size_t>& rows) {
        for (auto& [name, values] : columns_) {
            std::vector<double> kept;
            for (const std::size_t row : rows) {
                if (row < values.size()) kept.push_back(values[row]);
            }
            values = std::move(kept);
        }
    }

  private:
    std::map<std::string, std::vector<double>, std::less<>> columns_;
};

}  // namespace riffle::inline record

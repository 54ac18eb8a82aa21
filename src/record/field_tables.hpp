#pragma once

#include <string>
#include <vector>

#include "record/field.hpp"

namespace riffle::inline record {

/// All fields of the results, by the groups that a reader of the documentation looks for.
struct FieldTable {
    const Group* group;
    std::vector<Field> fields;
};
[[nodiscard]] const std::vector<FieldTable>& field_tables();

/// The page docs/results-fields.md.
[[nodiscard]] std::string results_fields_markdown();

/// The same for programs: `riffle schema --results`. The Python package has a copy.
[[nodiscard]] std::string results_fields_json();

}  // namespace riffle::inline record

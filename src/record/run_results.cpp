#include "record/run_results.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <variant>

#include "base/error.hpp"
#include "record/flow_fields.hpp"
#include "record/run_fields.hpp"

namespace riffle::inline record {

namespace {

std::optional<double> number_in(const std::optional<AttributeValue>& value) {
    if (!value) return std::nullopt;
    if (const auto* real = std::get_if<double>(&*value)) return *real;
    if (const auto* integer = std::get_if<std::int64_t>(&*value)) return static_cast<double>(*integer);
    return std::nullopt;
}

std::string text_in(const std::optional<AttributeValue>& value) {
    const auto* words = value ? std::get_if<std::string>(&*value) : nullptr;
    return words != nullptr ? *words : std::string();
}

Case read_stored_case(const ResultsReader& reader) {
    const std::string file = reader.path().string();
    const std::string stored = fields::stored_case.text.path();
    if (!reader.has(stored)) {
        throw FileError(file +
                        ": the results file holds no case (/case/text), without which its records cannot be "
                        "analysed or shown");
    }
    const std::string text = reader.read_string(stored);
    try {
        Case c = parse_case(text, file + ":" + stored);
        c.text = text;
        return c;
    } catch (const InputError& error) {
        throw FileError(file + ": the case in the results file cannot be read by this version of Riffle:\n" +
                        error.what());
    }
}

}  // namespace

RunResults::RunResults(const std::filesystem::path& results) : reader_(results) {}

const Case& RunResults::flow() const {
    if (!flow_) flow_ = read_stored_case(reader_);
    return *flow_;
}

std::vector<std::size_t> RunResults::shape(const FieldPlace& field) const {
    return reader_.shape(field.path());
}

std::vector<double> RunResults::values(const FieldPlace& field) const {
    const std::string path = field.path();
    return reader_.has(path) ? reader_.read_doubles(path) : std::vector<double>();
}

std::vector<double> RunResults::rows(const FieldPlace& field, std::size_t first, std::size_t count) const {
    return reader_.read_rows(field.path(), first, count);
}

std::string RunResults::stored_text(const FieldPlace& field) const {
    return reader_.read_string(field.path());
}

std::optional<double> RunResults::number(const FieldPlace& field) const {
    return number_in(reader_.attribute(field.group, field.name));
}

std::string RunResults::text(const FieldPlace& field) const {
    return text_in(reader_.attribute(field.group, field.name));
}

std::string RunResults::unit(const FieldPlace& field) const {
    return text_in(reader_.attribute(field.path(), "units"));
}

std::string RunResults::long_name(const FieldPlace& field) const {
    return text_in(reader_.attribute(field.path(), "long_name"));
}

Numbers RunResults::numbers(const Group& group) const {
    Numbers numbers;
    if (!has(group)) return numbers;
    for (const std::string& name : reader_.attribute_names(group.path)) {
        if (const auto value = number_in(reader_.attribute(group.path, name))) numbers.set(name, *value);
    }
    return numbers;
}

SeriesTable RunResults::series() const {
    SeriesTable series;
    if (!has(fields::time_series.time)) return series;
    std::size_t rows = SIZE_MAX;
    std::vector<std::pair<Field, std::vector<double>>> columns;
    for (const Field& field : fields_of(fields::time_series)) {
        if (!has(field)) continue;
        columns.emplace_back(field, values(field));
        rows = std::min(rows, columns.back().second.size());
    }
    for (auto& [field, column] : columns) {
        column.resize(rows);
        series.set(field, std::move(column));
    }
    return series;
}

std::optional<std::pair<double, double>> RunResults::averaging_window() const {
    const auto& profiles = fields::profile_window;
    const auto& summary = fields::summary;
    for (const auto& [start, end] :
         {std::pair{profiles.start, profiles.end}, std::pair{summary.window_start, summary.window_end}}) {
        const auto from = number(start);
        const auto to = number(end);
        if (from && to && *to > *from) return std::pair{*from, *to};
    }
    return std::nullopt;
}

std::vector<std::string> RunResults::children(const std::string& group) const {
    return reader_.has(group) ? reader_.children(group) : std::vector<std::string>();
}

}  // namespace riffle::inline record

#include "laboratory/profile_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "laboratory/record_repair.hpp"

namespace riffle {

namespace {

struct Known {
    ProfileQuantity quantity;
    std::string_view name;
    std::string_view unit;
    std::vector<std::string_view> spellings;  ///< lower case, without blanks, underscores and carets
};

const std::vector<Known>& known_quantities() {
    using Q = ProfileQuantity;
    static const std::vector<Known> table{
        {Q::velocity, "u", "m/s", {"u", "umean", "meanu", "velocity", "streamwisevelocity"}},
        {Q::spanwise_velocity, "v", "m/s", {"v", "vmean", "meanv", "spanwisevelocity"}},
        {Q::vertical_velocity, "w", "m/s", {"w", "wmean", "meanw", "verticalvelocity"}},
        {Q::streamwise_rms, "u_rms", "m/s", {"urms", "u'", "sigmau", "stdu", "streamwiserms"}},
        {Q::spanwise_rms, "v_rms", "m/s", {"vrms", "v'", "sigmav", "stdv", "spanwiserms"}},
        {Q::vertical_rms, "w_rms", "m/s", {"wrms", "w'", "sigmaw", "stdw", "verticalrms"}},
        {Q::reynolds_stress, "-u'w'", "m2/s2", {"-u'w'", "-uw", "reynoldsstress"}},
        {Q::velocity_gradient, "du/dz", "1/s", {"du/dz", "dudz", "velocitygradient"}},
    };
    return table;
}

const Known& known(ProfileQuantity quantity) {
    const auto& table = known_quantities();
    return *std::find_if(table.begin(), table.end(), [=](const Known& k) { return k.quantity == quantity; });
}

std::string plain_name(std::string_view name) {
    std::string result;
    for (const char c : name) {
        if (c == ' ' || c == '_' || c == '^') continue;
        result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return result;
}

/// What a column holds.
struct Role {
    enum class Kind { other, height, value, uncertainty } kind = Kind::other;
    ProfileQuantity quantity = ProfileQuantity::velocity;
    double sign = 1.0;
};

std::optional<ProfileQuantity> quantity_of(std::string_view plain) {
    for (const Known& k : known_quantities()) {
        if (std::find(k.spellings.begin(), k.spellings.end(), plain) != k.spellings.end()) return k.quantity;
    }
    return std::nullopt;
}

Role role_of(std::string_view name) {
    const std::string plain = plain_name(name);
    if (plain == "z" || plain == "height") return {Role::Kind::height};
    if (const auto quantity = quantity_of(plain)) return {Role::Kind::value, *quantity};
    if (plain == "u'w'" || plain == "uw") return {Role::Kind::value, ProfileQuantity::reynolds_stress, -1.0};
    if (plain == "uncertainty" || plain == "du" || plain == "deltau") {
        return {Role::Kind::uncertainty, ProfileQuantity::velocity};
    }
    constexpr std::string_view ending = "uncertainty";
    if (plain.size() > ending.size() && plain.substr(plain.size() - ending.size()) == ending) {
        const std::string of = plain.substr(0, plain.size() - ending.size());
        if (of == "u'w'" || of == "uw") return {Role::Kind::uncertainty, ProfileQuantity::reynolds_stress};
        if (const auto quantity = quantity_of(of)) return {Role::Kind::uncertainty, *quantity};
    }
    return {};
}

std::vector<Role> roles_of(const CsvTable& table) {
    std::vector<Role> roles;
    bool any = false;
    for (const CsvColumn& column : table.columns) {
        roles.push_back(role_of(column.name));
        any = any || roles.back().kind != Role::Kind::other;
    }
    if (any) return roles;
    const std::array positional{Role{Role::Kind::height}, Role{Role::Kind::value},
                                Role{Role::Kind::uncertainty}};
    if (roles.size() < 2 || roles.size() > positional.size()) {
        throw FileError(
            fmt::format("{}:{}: expected the columns z, u and, if known, the uncertainty of u, or a header "
                        "that names the columns, "
                        "like \"z [mm], u [m/s], u_rms [m/s]\"; got {} columns",
                        table.path.string(), table.header_line > 0 ? table.header_line : table.lines.front(),
                        roles.size()));
    }
    std::copy_n(positional.begin(), roles.size(), roles.begin());
    return roles;
}

/// Columns of one quantity, its uncertainty behind it; rows in the order of the file.
ProfileColumn& column_of(ProfileRecord& record, ProfileQuantity quantity) {
    for (ProfileColumn& column : record.columns) {
        if (column.quantity == quantity) return column;
    }
    record.columns.push_back({quantity, {}, {}});
    return record.columns.back();
}

void take_column(const CsvTable& table, std::size_t i, const Role& role, ProfileRecord& record) {
    const auto twice = [&] {
        throw FileError(fmt::format("{}:{}: {} is there twice", table.path.string(), table.header_line,
                                    table.column_name(i)));
    };
    if (role.kind == Role::Kind::height) {
        if (!record.z.empty()) twice();
        record.z = column_in_si(table, i, "m");
        return;
    }
    ProfileColumn& column = column_of(record, role.quantity);
    std::vector<double> values = column_in_si(table, i, known(role.quantity).unit);
    if (role.kind == Role::Kind::value) {
        if (!column.values.empty()) twice();
        for (double& v : values) v *= role.sign;
        column.values = std::move(values);
        return;
    }
    if (!column.uncertainty.empty()) twice();
    for (std::size_t row = 0; row < values.size(); ++row) {
        if (values[row] > 0.0 || std::isnan(values[row])) continue;
        throw FileError(fmt::format("{}: expected an uncertainty greater than 0 in {}, got {:.6g}",
                                    table.place(row), table.column_name(i), values[row]));
    }
    column.uncertainty = std::move(values);
}

template <class T>
void reorder(std::vector<T>& values, const std::vector<std::size_t>& order) {
    if (values.empty()) return;
    std::vector<T> sorted;
    sorted.reserve(values.size());
    for (const std::size_t i : order) sorted.push_back(values[i]);
    values = std::move(sorted);
}

void sort_by_height(ProfileRecord& record) {
    std::vector<std::size_t> order(record.z.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&record](std::size_t a, std::size_t b) { return record.z[a] < record.z[b]; });
    reorder(record.z, order);
    reorder(record.lines, order);
    for (ProfileColumn& column : record.columns) {
        reorder(column.values, order);
        reorder(column.uncertainty, order);
    }
    for (std::size_t i = 1; i < record.z.size(); ++i) {
        if (record.z[i] > record.z[i - 1]) continue;
        throw FileError(fmt::format("{}: expected one point for each height; z = {:.6g} m is also in line {}",
                                    record.place(i), record.z[i], record.lines[i - 1]));
    }
}

}  // namespace

std::string_view quantity_name(ProfileQuantity quantity) { return known(quantity).name; }

const ProfileColumn* ProfileRecord::find(ProfileQuantity quantity) const {
    for (const ProfileColumn& column : columns) {
        if (column.quantity == quantity) return &column;
    }
    return nullptr;
}

std::string ProfileRecord::place(std::size_t point) const {
    return fmt::format("{}:{}", source.string(), lines.at(point));
}

ProfileRecord read_profile_record(const std::filesystem::path& path) {
    const CsvTable table = read_csv_table(path, MissingValues::allowed);
    ProfileRecord record;
    record.source = path;
    record.title = table.comment_value("title").value_or("");
    record.comments = table.comments;
    record.lines = table.lines;
    const std::vector<Role> roles = roles_of(table);
    for (std::size_t i = 0; i < roles.size(); ++i) {
        if (roles[i].kind != Role::Kind::other) {
            take_column(table, i, roles[i], record);
        } else {
            record.warnings.push_back(fmt::format("{} is not used: no known quantity", table.column_name(i)));
        }
    }
    if (record.z.empty() || record.columns.empty()) {
        throw FileError(
            fmt::format("{}:{}: expected a column z and one of u, w, u_rms, w_rms, -u'w' or du/dz",
                        path.string(), table.header_line));
    }
    for (std::size_t row = 0; row < record.z.size(); ++row) {
        if (std::isnan(record.z[row]))
            throw FileError(fmt::format("{}: expected a height z", record.place(row)));
    }
    sort_by_height(record);
    for (const ProfileColumn& column : record.columns) {
        if (column.values.empty()) {
            throw FileError(fmt::format("{}:{}: the uncertainty of {} is there, but not {}", path.string(),
                                        table.header_line, quantity_name(column.quantity),
                                        quantity_name(column.quantity)));
        }
        const std::size_t missing = find_gaps(column.values).missing;
        if (missing == 0) continue;
        record.warnings.push_back(fmt::format("{}: {} of {} points have no value",
                                              quantity_name(column.quantity), missing, record.z.size()));
    }
    return record;
}

}  // namespace riffle

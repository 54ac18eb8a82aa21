#include "laboratory/quantity_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "laboratory/record_repair.hpp"

namespace riffle::inline laboratory {

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
    enum class Kind { other, along, across, height, value, uncertainty } kind = Kind::other;
    ProfileQuantity quantity = ProfileQuantity::velocity;
    double sign = 1.0;
};

std::optional<ProfileQuantity> quantity_of(std::string_view plain) {
    for (const Known& k : known_quantities()) {
        if (std::find(k.spellings.begin(), k.spellings.end(), plain) != k.spellings.end()) return k.quantity;
    }
    return std::nullopt;
}

/// The axis of a column of positions; 0 for other columns.
char axis_of(std::string_view plain) {
    if (plain == "height") return 'z';
    return plain == "x" || plain == "y" || plain == "z" ? plain.front() : '\0';
}

Role::Kind kind_of(char axis) {
    return axis == 'x' ? Role::Kind::along : axis == 'y' ? Role::Kind::across : Role::Kind::height;
}

Role role_of(std::string_view name, std::string_view axes) {
    const std::string plain = plain_name(name);
    if (const char axis = axis_of(plain); axis != '\0') {
        return {axes.find(axis) == std::string_view::npos ? Role::Kind::other : kind_of(axis)};
    }
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

std::vector<Role> roles_of(const CsvTable& table, std::string_view axes) {
    std::vector<Role> roles;
    bool any = false;
    for (const CsvColumn& column : table.columns) {
        roles.push_back(role_of(column.name, axes));
        any = any || roles.back().kind != Role::Kind::other;
    }
    if (any) return roles;
    const std::array positional{Role{Role::Kind::height}, Role{Role::Kind::value},
                                Role{Role::Kind::uncertainty}};
    // Names that are not known must not become heights and velocities by their order.
    const bool named = table.header_line > 0;
    if (named || roles.size() < 2 || roles.size() > positional.size()) {
        std::string got = fmt::format("{} columns", roles.size());
        for (std::size_t i = 0; named && i < roles.size(); ++i) {
            got += fmt::format("{}{}", i == 0 ? ": " : ", ", table.column_name(i));
        }
        throw FileError(fmt::format(
            "{}:{}: expected the columns z, u and, if known, the uncertainty of u without a header, or a "
            "header that names the columns, like \"z [mm], u [m/s], u_rms [m/s]\"; got {}",
            table.path.string(), named ? table.header_line : table.lines.front(), got));
    }
    std::copy_n(positional.begin(), roles.size(), roles.begin());
    return roles;
}

/// Columns of one quantity, its uncertainty behind it; rows in the order of the file.
ProfileColumn& column_of(QuantityColumns& record, ProfileQuantity quantity) {
    for (ProfileColumn& column : record.columns) {
        if (column.quantity == quantity) return column;
    }
    record.columns.push_back({quantity, {}, {}});
    return record.columns.back();
}

void take_column(const CsvTable& table, std::size_t i, const Role& role, QuantityColumns& record) {
    const auto twice = [&] {
        throw FileError(fmt::format("{}:{}: {} is there twice", table.path.string(), table.header_line,
                                    table.column_name(i)));
    };
    const auto position = [&](std::vector<double>& values) {
        if (!values.empty()) twice();
        values = column_in_si(table, i, "m");
    };
    switch (role.kind) {
        case Role::Kind::along:
            position(record.x);
            return;
        case Role::Kind::across:
            position(record.y);
            return;
        case Role::Kind::height:
            position(record.z);
            return;
        default:
            break;
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

}  // namespace

std::string_view quantity_name(ProfileQuantity quantity) { return known(quantity).name; }

const ProfileColumn* QuantityColumns::find(ProfileQuantity quantity) const {
    for (const ProfileColumn& column : columns) {
        if (column.quantity == quantity) return &column;
    }
    return nullptr;
}

bool has_position(const CsvTable& table, char axis) {
    return std::any_of(table.columns.begin(), table.columns.end(),
                       [&](const CsvColumn& column) { return axis_of(plain_name(column.name)) == axis; });
}

QuantityColumns quantity_columns(const CsvTable& table, std::string_view axes) {
    QuantityColumns record;
    const std::vector<Role> roles = roles_of(table, axes);
    for (std::size_t i = 0; i < roles.size(); ++i) {
        if (roles[i].kind != Role::Kind::other) {
            take_column(table, i, roles[i], record);
        } else {
            record.warnings.push_back(fmt::format("{} is not used: no known quantity", table.column_name(i)));
        }
    }
    for (const ProfileColumn& column : record.columns) {
        if (!column.values.empty()) continue;
        throw FileError(fmt::format("{}:{}: the uncertainty of {} is there, but not {}", table.path.string(),
                                    table.header_line, quantity_name(column.quantity),
                                    quantity_name(column.quantity)));
    }
    return record;
}

std::vector<std::string> missing_values(const std::vector<ProfileColumn>& columns, std::size_t points) {
    std::vector<std::string> warnings;
    for (const ProfileColumn& column : columns) {
        const std::size_t missing = find_gaps(column.values).missing;
        if (missing == 0) continue;
        warnings.push_back(fmt::format("{}: {} of {} points have no value", quantity_name(column.quantity),
                                       missing, points));
    }
    return warnings;
}

}  // namespace riffle::inline laboratory

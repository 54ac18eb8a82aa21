#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace riffle::inline record {

/// Words that may differ between a run in two dimensions, where forces and volumes are per unit width, and
/// one in three.
struct Wording {
    const char* plane;
    const char* space;

    consteval Wording(const char* both) : plane(both), space(both) {}
    consteval Wording(const char* in_plane, const char* three_dimensions)
        : plane(in_plane), space(three_dimensions) {}

    [[nodiscard]] const char* in(int dimensions) const { return dimensions == 3 ? space : plane; }
};

/// How the values of several rows become one mean.
enum class Averaging {
    none,          ///< places, counts and extremes are not averaged
    over_rows,     ///< rows at equal intervals, each with the same weight
    by_samples,    ///< rows are windows, weighted with their `samples`
    by_particles,  ///< cells of windows, weighted with their particles: `count` times `samples`
    moments,       ///< so, of u'w' + u w; the product of the means is taken off again
    sums,          ///< rows are added; quotients of the sums are means
};

/// Which runs have a field: all of these conditions together. None of them: every run.
enum Condition : unsigned {
    every_run = 0,
    three_dimensions = 1U << 0U,  ///< three dimensions
    free_surface = 1U << 1U,      ///< channel.top
    column_twin = 1U << 2U,       ///< the case has a column
    section_twin = 1U << 3U,      ///< side walls
    no_section_twin = 1U << 4U,   ///< no side walls
    with_closure = 1U << 5U,
    with_solids = 1U << 6U,
    with_moving_solids = 1U << 7U,
    with_spheres = 1U << 8U,       ///< a bed of spheres
    when_asked = 1U << 9U,         ///< chosen by a key of [output]
    at_the_end = 1U << 10U,        ///< once the run has ended or was stopped
    with_profiles = 1U << 11U,     ///< once a block of time is complete
    with_samples = 1U << 12U,      ///< from ten independent samples on
    on_a_slope = 1U << 13U,        ///< where weight acts along the channel
    where_fitted = 1U << 14U,      ///< where the law can be fitted
    verlet_stepping = 1U << 15U,   ///< numerics.stepping
    beeman_stepping = 1U << 16U,   ///< so
    with_open_ends = 1U << 17U,    ///< channel.ends
    with_local_depth = 1U << 18U,  ///< turbulence.depth
    slow_correction = 1U << 19U,   ///< numerics.pressure_correction_time
    with_vegetation = 1U << 20U,
    with_porous_zones = 1U << 21U,
    with_free_bodies = 1U << 22U,
    density_relaxation = 1U << 23U,  ///< numerics.density_relaxation
    level_surface = 1U << 24U,       ///< where the surface is as high all along the channel
    with_periodic_ends = 1U << 25U,  ///< channel.ends
    relaxation_known = 1U << 26U,    ///< where a twin or the ends tell the relaxation time
};

/// Who reads a field.
enum class Reader {
    analysis,     ///< the analysis, a page, a sweep: its values reach what users see
    simulation,   ///< what goes on with a run or starts from it
    index_files,  ///< the index of ParaView
    users,        ///< recorded for users alone, who open the file in Python
};

/// Datasets or attributes that belong together.
struct Group {
    const char* path;  ///< NAME and NNNNN stand for the name of an instrument and the number of a snapshot
    const char* title;
    unsigned written = every_run;  ///< conditions of all its fields
    const char* kind = "";         ///< of the instrument
    const char* note = "";
};

/// A field of the results: one dataset, or an attribute of a group. The tables of fields (`fields::...`) are
/// the one place where names, units and meanings stand.
struct Field {
    const Group* group;
    const char* name;  ///< one that ends in _N is there for each solid, from 1
    Wording unit;      ///< SI; "1" without dimension; "" of a text
    Wording meaning;   ///< `long_name` of a dataset
    const char* axes;  ///< names of the axes, first the slowest; "attribute"
    Averaging averaging;
    unsigned written;  ///< conditions beside those of the group
    Reader reader;
    const char* note;  ///< what users must know beyond the meaning

    [[nodiscard]] bool is_attribute() const { return std::string_view(axes) == "attribute"; }
    [[nodiscard]] std::string path() const { return path_in(group->path); }
    /// Path in the group of an instrument or a snapshot.
    [[nodiscard]] std::string path_in(const std::string& group_path) const { return group_path + "/" + name; }
    [[nodiscard]] bool operator==(const Field& other) const {
        return group == other.group && std::string_view(name) == other.name;
    }
};

/// Name of a field that there is for each solid: its _N with the number of the solid, from 1.
[[nodiscard]] inline std::string numbered_name(const Field& field, std::size_t number) {
    const std::string name = field.name;
    return name.substr(0, name.size() - 1) + std::to_string(number);
}

/// What a row of a table says beside name, unit and meaning.
struct FieldRule {
    std::optional<Averaging> averaging = std::nullopt;
    unsigned written = every_run;
    Reader reader = Reader::analysis;
    const char* axes = nullptr;
    const char* note = "";
};

/// A row; `usual` are averaging and axes where its rule names none.
consteval Field make_field(const Group& group, const char* name, Wording unit, Wording meaning,
                           const FieldRule& rule, const char* usual_axes, Averaging usual = Averaging::none) {
    return {&group,
            name,
            unit,
            meaning,
            rule.axes != nullptr ? rule.axes : usual_axes,
            rule.averaging.value_or(usual),
            rule.written,
            rule.reader,
            rule.note};
}

/// An attribute of a group.
consteval Field make_attribute(const Group& group, const char* name, Wording unit, Wording meaning,
                               const FieldRule& rule = {}) {
    return make_field(group, name, unit, meaning, rule, "attribute");
}

/// The rows of a table in their order. `Table` consists of rows alone.
template <class Row, class Table>
[[nodiscard]] std::array<Row, sizeof(Table) / sizeof(Row)> rows_of(const Table& table) {
    static_assert(sizeof(Table) % sizeof(Row) == 0);
    return std::bit_cast<std::array<Row, sizeof(Table) / sizeof(Row)>>(table);
}
template <class Table>
[[nodiscard]] auto fields_of(const Table& table) {
    return rows_of<Field>(table);
}

}  // namespace riffle::inline record

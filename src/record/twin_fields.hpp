#pragma once

#include "record/field.hpp"

namespace riffle::inline record::fields {

namespace groups {
inline constexpr Group column{"/column", "Column twin", column_twin};
inline constexpr Group section{
    "/section", "Section twin", three_dimensions | section_twin, "",
    "With side walls the section, not the column, is what the departures in `/profiles` and `/summary` refer "
    "to: its velocity at the particles' places, the mean of its stress across the channel."};
}  // namespace groups

consteval Field of_column(const char* name, Wording unit, Wording meaning, const FieldRule& rule = {}) {
    return make_field(groups::column, name, unit, meaning, rule, "z");
}
struct Column {
    Field z = of_column("z", "m", "height above the bed level", {.reader = Reader::users});
    Field velocity =
        of_column("velocity", "m/s", "streamwise velocity of the column", {.reader = Reader::users});
    Field velocity_gradient =
        of_column("velocity_gradient", "1/s", "velocity gradient of the column", {.reader = Reader::users});
    Field shear_stress =
        of_column("shear_stress", "Pa", "shear stress of the column", {.reader = Reader::users});
    Field mixing_length = of_column("mixing_length", "m", "mixing length", {.reader = Reader::users});
    Field eddy_viscosity =
        of_column("eddy_viscosity", "m2/s", "eddy viscosity of the column", {.reader = Reader::users});
};
inline constexpr Column column;

consteval Field column_number(const char* name, Wording unit, Wording meaning, const FieldRule& rule = {}) {
    return make_attribute(groups::column, name, unit, meaning, rule);
}
struct ColumnNumbers {
    Field depth_mean_velocity = column_number("depth_mean_velocity", "m/s", "mean velocity above the datum");
    Field total_mean_velocity =
        column_number("total_mean_velocity", "m/s", "mean velocity over the whole depth");
    Field surface_velocity = column_number("surface_velocity", "m/s", "velocity at the surface");
    Field friction_velocity =
        column_number("friction_velocity", "m/s", "friction velocity, from the stress at the crests");
    Field log_law_friction_velocity =
        column_number("log_law_friction_velocity", "m/s",
                      "friction velocity of the log law fitted to the column", {.written = where_fitted});
    Field equivalent_roughness = column_number(
        "equivalent_roughness", "m", "equivalent roughness of the same fit", {.written = where_fitted});
    Field zero_plane = column_number("zero_plane", "m", "zero plane of the same fit, above the bed level",
                                     {.written = where_fitted, .reader = Reader::users});
    Field drag_share = column_number("drag_share", "1", "bed drag over the weight component");
    Field wall_share = column_number("wall_share", "1", "wall force over the weight component");
    Field vegetation_share =
        column_number("vegetation_share", "1", "drag of the vegetation over the weight component",
                      {.written = with_vegetation});
    Field porous_share =
        column_number("porous_share", "1", "resistance of porous zones over the weight component",
                      {.written = with_porous_zones});
    Field friction_factor =
        column_number("friction_factor", "1", "friction factor", {.reader = Reader::users});
    Field manning = column_number("manning", "s/m^(1/3)", "Manning's n", {.reader = Reader::users});
    Field chezy = column_number("chezy", "m^(1/2)/s", "Chezy's C", {.reader = Reader::users});
    Field reynolds = column_number("reynolds", "1", "Reynolds number", {.reader = Reader::users});
    Field froude = column_number("froude", "1", "Froude number", {.reader = Reader::users});
    Field relaxation_time =
        column_number("relaxation_time", "s", "relaxation time of the flow", {.reader = Reader::users});
};
inline constexpr ColumnNumbers column_numbers;

consteval Field of_section(const char* name, Wording unit, Wording meaning, const FieldRule& rule = {}) {
    return make_field(groups::section, name, unit, meaning, rule, "z y");
}
struct Section {
    Field y = of_section("y", "m", "distance across the channel, cell centres", {.axes = "y"});
    Field z = of_section("z", "m", "height above the bed level, cell centres", {.axes = "z"});
    Field velocity = of_section("velocity", "m/s", "streamwise velocity of the section");
    Field mixing_length = of_section("mixing_length", "m", "mixing length l_x", {.reader = Reader::users});
    Field shear_stress = of_section("shear_stress", "Pa", "stress tau_xz of the section");
    Field lateral_shear_stress =
        of_section("lateral_shear_stress", "Pa", "stress tau_xy of the section", {.reader = Reader::users});
};
inline constexpr Section section;

consteval Field section_number(const char* name, Wording unit, Wording meaning, const FieldRule& rule = {}) {
    return make_attribute(groups::section, name, unit, meaning, rule);
}
struct SectionNumbers {
    Field bulk_velocity = section_number("bulk_velocity", "m/s", "mean velocity over the section");
    Field depth_mean_velocity = section_number("depth_mean_velocity", "m/s", "mean velocity above the datum");
    Field centreline_velocity =
        section_number("centreline_velocity", "m/s", "depth-mean velocity on the centreline");
    Field maximum_velocity =
        section_number("maximum_velocity", "m/s", "largest velocity", {.reader = Reader::users});
    Field wall_layer_velocity = section_number("wall_layer_velocity", "m/s", "mean over the walls' layers",
                                               {.reader = Reader::users});
    Field discharge =
        section_number("discharge", "m3/s", "discharge of the whole width", {.reader = Reader::users});
    Field drag_share = section_number("drag_share", "1", "bed drag over the weight component");
    Field side_wall_share =
        section_number("side_wall_share", "1", "drag of the side walls over the weight component");
    Field wall_share =
        section_number("wall_share", "1",
                       "friction of bed and side walls at which the water rests over the weight component");
    Field vegetation_share =
        section_number("vegetation_share", "1", "drag of the vegetation over the weight component",
                       {.written = with_vegetation});
    Field porous_share =
        section_number("porous_share", "1", "resistance of porous zones over the weight component",
                       {.written = with_porous_zones});
    Field bed_stress = section_number("bed_stress", "Pa", "mean stress on the bed");
    Field wall_stress = section_number("wall_stress", "Pa", "mean stress on the side walls");
    Field side_wall_coefficient = section_number("side_wall_coefficient", "1/m", "beta of the walls' layers",
                                                 {.reader = Reader::users});
    Field relaxation_time =
        section_number("relaxation_time", "s", "relaxation time of the flow", {.reader = Reader::users});
    Field partition_k =
        section_number("partition_k", "1", "k of the partition of Yang & Lim", {.reader = Reader::users});
    Field partition_bed_stress =
        section_number("partition_bed_stress", "Pa", "its mean stress on the bed", {.reader = Reader::users});
    Field partition_wall_stress = section_number(
        "partition_wall_stress", "Pa", "its mean stress on the side walls", {.reader = Reader::users});
    Field partition_bed_share =
        section_number("partition_bed_share", "1", "its share of the bed", {.reader = Reader::users});
};
inline constexpr SectionNumbers section_numbers;

}  // namespace riffle::inline record::fields

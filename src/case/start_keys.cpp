#include "case/start_keys.hpp"

#include <utility>

#include "case/units.hpp"

namespace riffle::inline case_file {

SectionKeys start_keys() {
    using enum Dimension;
    SectionKeys s{"start", "The state at the beginning.", {}};
    const auto key = [](const char* name, auto member, const char* meaning) {
        return make_key("start", name, &Case::start, member, meaning);
    };
    const std::string kind = "start.kind";
    s.keys.push_back(key("kind", &Start::kind, "What the run starts from."));
    s.keys.push_back(
        key("velocity", &Start::velocity,
            "uniform: the velocity; power-law: U_max at the surface; standing-wave, taylor-green: the "
            "velocity amplitude.")
            .measured_in(velocity)
            .unset_by(
                "auto",
                "from the column twin (uniform, power-law), of a canal by Colebrook and White (uniform); zero (standing-wave); an error "
                "(taylor-green)")
            .applies_with(kind, {"uniform", "power-law", "standing-wave", "taylor-green"}));
    s.keys.push_back(key("exponent", &Start::exponent, "m of the power law.")
                         .at_least(0.1)
                         .at_most(100)
                         .because("measured: 3 to 10")
                         .applies_with(kind, {"power-law"}));
    s.keys.push_back(key("amplitude", &Start::amplitude, "Amplitude of the surface of the standing wave.")
                         .measured_in(length)
                         .at_least(0)
                         .applies_with(kind, {"standing-wave"}));
    s.keys.push_back(
        key("file", &Start::file,
            "results: the file to start from; isotropic: CSV table of the energy spectrum, columns "
            "`wavenumber` [1/m] and `energy` [m3/s2], whose integral is the kinetic energy per mass.")
            .applies_with(kind, {"results", "isotropic"}));
    s.keys.push_back(
        key("lattice", &Start::lattice, "Arrangement of the particles at the start.")
            .with_default_note("square; hexagonal, in three dimensions body-centred, in basins beside "
                               "inclined faces, in plane ones also where nothing moves the water (see "
                               "`numerics.pressure_correction_time`)"));
    const auto water = [&](const char* name, auto member, const char* meaning, const char* example) {
        return key(name, member, meaning)
            .measured_in(length)
            .may_be_empty()
            .with_default_note("all up to the depth")
            .with_example(example)
            .applies_with(kind, {"rest", "uniform"}, true);
    };
    s.keys.push_back(
        water("water_x", &Start::water_x,
              "Corners of the outline of the water along the channel, across all of its width; the "
              "depth then only sets the spacing of the rows.",
              R"(["0 mm", "100 mm", "100 mm", "0 mm"])"));
    s.keys.push_back(water("water_z", &Start::water_z, "Heights of the same corners above the bed level.",
                           R"(["0 mm", "0 mm", "200 mm", "200 mm"])"));
    s.keys.push_back(
        key("jitter", &Start::jitter,
            "Largest random displacement of the particles from their lattice, in units of the spacing.")
            .at_least(0)
            .at_most(0.5)
            .because("farther, two particles may meet"));
    s.keys.push_back(
        key("packed", &Start::packed,
            "Whether the particles beside solids, with jitter all, are moved before the run until they fill the "
            "water evenly; else faces that cut the rows of the lattice start with gaps beside them, and in three "
            "dimensions the surface of solids is that of the lattice, to half a spacing.")
            .unset_by(
                "auto",
                "in two dimensions beside solids whose faces leave such gaps, but for free surfaces between open "
                "ends; in three dimensions not")
            .applies_with("start.kind", {"rest", "uniform", "column", "section", "power-law", "results"}));
    s.keys.push_back(
        key("settling_time", &Start::settling_time,
            "Time at the beginning of the run over which a drag takes the motion out of still water, in its second "
            "half less and less: what the start lacks of its balance then becomes no lasting motion.")
            .measured_in(time)
            .at_least(0)
            .with_default_note("0; 2 s of water at rest up to the depth in three dimensions, where it stands "
                               "beside inclined faces and nothing moves")
            .applies_with("start.kind", {"rest", "results"}));
    s.keys.push_back(
        key("perturbation", &Start::perturbation,
            "Random velocity without divergence that is added to the start, root mean square of a component.")
            .measured_in(velocity)
            .at_least(0)
            .unset_by(
                "auto",
                "a quarter of the friction velocity over spheres in two dimensions, where the flow then "
                "starts in the state that lasts; all of it where eddies are resolved, two thirds of its energy "
                "those of streaks along the flow, which make eddies, and it is right to a tenth; 0 elsewhere"));
    s.keys.push_back(key("seed", &Start::seed, "Seed of the random displacement and of the perturbation.")
                         .at_least(0)
                         .at_most(9007199254740991.0)
                         .because("whole numbers that every program keeps"));
    return s;
}

}  // namespace riffle::inline case_file

#include "case/space_validation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <sstream>

#include "case/sphere_tiling.hpp"
#include "case/units.hpp"
#include "case/words.hpp"

namespace riffle {

namespace {

std::string rounded_length_text(double value) { return fmt::format("{:.4f} mm", 1e3 * value); }

class SpaceValidation {
  public:
    SpaceValidation(const Case& c, const Places& places, Problems& problems)
        : c_(c), places_(places), problems_(problems) {}

    void run() {
        if (c_.channel.dimensions == 2) {
            check_plane();
            return;
        }
        check_kinds();
        check_width();
        if (c_.bed.kind == BedKind::spheres) {
            check_spheres();
        }
        if (c_.has_side_walls() && c_.side_walls.drag_form != SideDragForm::none) {
            check_side_walls();
        }
        if (c_.start.kind == StartKind::section && !c_.has_side_walls()) {
            add({"start.kind", "channel.sides"},
                "[start] kind = \"section\": with sides = \"periodic\" the flow does not vary across the "
                "channel; choose kind = \"column\", or sides = \"walls\" or \"half\"");
        }
    }

  private:
    void add(const std::vector<std::string>& keys, std::string message) {
        problems_.add(places_.of_first(keys), std::move(message));
    }

    void check_plane() {
        if (c_.bed.drag_form == DragForm::slice || c_.bed.drag_form == DragForm::plan_mean) {
            add({"bed.drag_form", "channel.dimensions"},
                "[bed] drag_form = \"slice\" or \"plan-mean\" goes with [channel] dimensions = 3; in two "
                "dimensions choose \"consistent\", which is its plan mean");
        }
        if (c_.start.lattice == StartLattice::body_centred) {
            add({"start.lattice", "channel.dimensions"},
                "[start] lattice = \"body-centred\" is an arrangement in space: in two dimensions choose "
                "\"hexagonal\", which rests in still water as it does, or \"square\"");
        }
        if (c_.start.kind == StartKind::section) {
            add({"start.kind", "channel.dimensions"},
                "[start] kind = \"section\" goes with [channel] dimensions = 3; choose \"column\"");
        }
    }

    /// A choice that three dimensions do not have.
    void refuse(bool wrong, const std::string& id, std::string_view chosen, const char* instead) {
        if (wrong) {
            const auto dot = id.find('.');
            add({id, "channel.dimensions"},
                fmt::format("[{}] {} = \"{}\" is not there with [channel] dimensions = 3: choose {}",
                            id.substr(0, dot), id.substr(dot + 1), chosen, instead));
        }
    }

    void check_kinds() {
        const Case& c = c_;
        refuse(c.channel.top != Top::free_surface, "channel.top", word(c.channel.top), "\"free-surface\"");
        refuse(c.bed.kind == BedKind::spheres && c.bed.drag_form == DragForm::paper, "bed.drag_form",
               word(c.bed.drag_form), R"("consistent", "slice" or "thesis")");
        refuse(c.start.lattice == StartLattice::hexagonal, "start.lattice", word(c.start.lattice),
               R"("square" or "body-centred")");
        refuse(c.start.kind == StartKind::standing_wave || c.start.kind == StartKind::taylor_green,
               "start.kind", word(c.start.kind), R"("column", "section", "uniform", "power-law" or "rest")");
        refuse(c.turbulence.closure == ClosureKind::czernuszenko_rylov &&
                   c.turbulence.spanwise_ratio != 1.0 && c.numerics.viscosity != ViscosityForm::morris &&
                   c.numerics.eddy_stress == EddyStress::two_point,
               "numerics.viscosity", word(c.numerics.viscosity),
               "\"morris\", which can weigh the pairs by their direction as czernuszenko-rylov needs it, or "
               "spanwise_ratio = 1");
        refuse(c.turbulence.stress_terms == StressTerms::shear, "turbulence.stress_terms",
               word(c.turbulence.stress_terms), "\"full\"");
    }

    void check_width() {
        const Numerics& n = c_.numerics;
        const double h = n.smoothing_ratio * n.spacing;
        const bool periodic = c_.channel.sides == Sides::periodic;
        const double needed = periodic ? 2.0 * (2.0 + n.skin_in(3)) * h : 2.0 * h;
        if (c_.channel.simulated_width() < needed) {
            add({"channel.width", "numerics.spacing"},
                fmt::format(
                    "[channel] width: the simulated width is {}, at least {} ({}) is needed; make the "
                    "channel wider or the spacing smaller",
                    shown_length(c_.channel.simulated_width()), rounded_length_text(needed),
                    periodic ? "two kernel supports of 2 h with their skin" : "one kernel support, 2 h"));
        }
    }

    void check_spheres() {
        const double d = c_.bed.sphere_diameter;
        if (d > c_.channel.width) {
            add({"bed.sphere_diameter", "channel.width"},
                fmt::format(
                    "[bed] sphere_diameter is {}, wider than the channel ({}): make the spheres smaller "
                    "or the channel wider",
                    shown_length(d), shown_length(c_.channel.width)));
            return;
        }
        const LatticePeriods periods = lattice_periods(c_.bed);
        check_tiling("channel.length", "length", c_.channel.length, periods.x, "D");
        if (c_.channel.sides == Sides::periodic) {
            check_tiling("channel.width", "width", c_.channel.width, periods.y,
                         c_.bed.packing == Packing::hexagonal ? "sqrt(3) D" : "D");
        }
        // Each sphere must be seen by some particles, or its drag depends on where they happen to be.
        constexpr double particles_over_sphere = 4.0;
        if (c_.numerics.spacing > d / particles_over_sphere) {
            add({"numerics.spacing", "bed.sphere_diameter"},
                fmt::format("[numerics] spacing is {}: less than {:.0f} particles over a sphere of {} do not "
                            "resolve its drag; make the spacing {} or less",
                            shown_length(c_.numerics.spacing), particles_over_sphere, shown_length(d),
                            shown_length(d / particles_over_sphere)));
        }
        if (c_.sphere_ramp() > d) {
            add({"bed.sphere_ramp"},
                fmt::format("[bed] sphere_ramp is {}: expected at most the sphere diameter {}",
                            shown_length(c_.sphere_ramp()), shown_length(d)));
        }
    }

    /// The spheres of a periodic bed repeat in the period of their lattice.
    void check_tiling(const std::string& id, const char* name, double extent, double period,
                      const char* period_text) {
        if (std::abs(extent / (whole_periods(extent, period) * period) - 1.0) <= largest_stretch) {
            return;
        }
        const double below = period * std::max(1.0, std::floor(extent / period));
        const double above = below + period;
        add({id, "bed.sphere_diameter"},
            fmt::format(
                "[channel] {} is {}: the spheres do not tile it, as their lattice repeats every {} = {}; "
                "take {} or {}",
                name, shown_length(extent), period_text, rounded_length_text(period),
                rounded_length_text(below), rounded_length_text(above)));
    }

    void check_side_walls() {
        if (c_.bed.kind != BedKind::spheres) {
            add({"side_walls.drag_form", "bed.kind"},
                "[side_walls] drag_form: the drag of the side walls follows from that of the bed's spheres, "
                "and this bed is smooth; choose drag_form = \"none\"");
            return;
        }
        const double layer = c_.side_layer();
        if (layer <= 0.0) {
            add({"side_walls.layer", "bed.roughness_height"},
                "[side_walls] layer is missing: on a smooth bed there is no roughness height to take it "
                "from; give a length, or drag_form = \"none\"");
            return;
        }
        if (layer < c_.numerics.spacing) {
            add({"side_walls.layer", "numerics.spacing"},
                fmt::format(
                    "[side_walls] layer is {}, thinner than the spacing {}: hardly a particle would feel "
                    "the drag of the wall; make it thicker or the spacing smaller",
                    shown_length(layer), shown_length(c_.numerics.spacing)));
        }
        const double edge_zone = c_.turbulence.edge_zone * 0.5 * c_.total_depth();
        if (c_.turbulence.closure == ClosureKind::czernuszenko_rylov && layer > edge_zone) {
            add({"side_walls.layer", "turbulence.edge_zone"},
                fmt::format("[side_walls] layer is {}, thicker than the edge zone of the mixing lengths, "
                            "edge_zone H / 2 = {}: make it thinner, or edge_zone larger",
                            shown_length(layer), rounded_length_text(edge_zone)));
        }
        if (layer > 0.25 * c_.channel.width) {
            add({"side_walls.layer", "channel.width"},
                fmt::format(
                    "[side_walls] layer is {}: the layers of both walls would fill more than half of the "
                    "channel ({}); make it thinner",
                    shown_length(layer), shown_length(c_.channel.width)));
        }
    }

    const Case& c_;
    const Places& places_;
    Problems& problems_;
};

}  // namespace

void validate_space(const Case& c, const Places& places, Problems& problems) {
    SpaceValidation(c, places, problems).run();
}

void validate_snapshots(const Case& c, const Places& places, Problems& problems) {
    constexpr std::array<const char*, 4> known = {"velocity", "pressure", "density", "eddy_viscosity"};
    std::istringstream fields(c.output.snapshot_fields);
    std::set<std::string> given;
    for (std::string field; fields >> field;) {
        if (!given.insert(field).second) {
            problems.add(places.of_first({"output.snapshot_fields"}),
                         fmt::format("[output] snapshot_fields: \"{}\" is named twice: remove one", field));
            break;
        }
        if (std::find(known.begin(), known.end(), field) == known.end()) {
            problems.add(
                places.of_first({"output.snapshot_fields"}),
                fmt::format("[output] snapshot_fields: \"{}\" is no field of a snapshot; expected some of "
                            "{}, with spaces between them",
                            field, fmt::join(known, ", ")));
        }
    }
    struct Range {
        const char* name;
        const std::vector<double>& range;
        double extent;  // of the water, m; waves may rise above the depth
    };
    const Range ranges[] = {{"snapshot_x", c.output.snapshot_x, c.channel.length},
                            {"snapshot_y", c.output.snapshot_y, c.channel.simulated_width()},
                            {"snapshot_z", c.output.snapshot_z, 1.5 * c.total_depth()}};
    for (const auto& [name, range, extent] : ranges) {
        if (!range.empty() && (range.size() != 2 || !(range[0] < range[1]))) {
            problems.add(
                places.of_first({fmt::format("output.{}", name)}),
                fmt::format("[output] {}: expected two lengths, from and to, the first one smaller, for "
                            "example {} = [\"0 mm\", \"50 mm\"]",
                            name, name));
        } else if (!range.empty() && (range[1] <= 0.0 || range[0] >= extent)) {
            problems.add(
                places.of_first({fmt::format("output.{}", name)}),
                fmt::format("[output] {}: there is no water from {} to {}; expected a part of 0 to {}", name,
                            shown_length(range[0]), shown_length(range[1]), shown_length(extent)));
        }
    }
}

}  // namespace riffle

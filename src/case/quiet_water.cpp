#include "case/quiet_water.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "case/flow_kind.hpp"
#include "case/outline.hpp"
#include "case/solid_mesh.hpp"

namespace riffle::inline case_file {

namespace {

/// Of a face that is level or upright, all components of its normal but one are less than this share of it.
constexpr double straight = 1e-6;

/// Whether a vector has more than one component that counts.
template <std::size_t N>
bool is_inclined(const std::array<double, N>& v) {
    double most = 0.0;
    for (const double component : v) most = std::max(most, std::abs(component));
    return std::count_if(v.begin(), v.end(),
                         [most](double component) { return std::abs(component) > straight * most; }) > 1;
}

/// Time to settle before a run in three dimensions, s.
constexpr double quiet_settling_time = 2.0;

StartLattice quiet_lattice(const Case& c) {
    return c.channel.dimensions == 3 ? StartLattice::body_centred : StartLattice::hexagonal;
}

double quiet_smoothing_ratio(const Case& c) { return c.channel.dimensions == 3 ? 1.65 : 1.83; }

double quiet_correction_time(const Case& c) {
    constexpr double longest_of_most = 100.0;  // s
    return std::max(longest_of_most, 3.0 * c.run.time);
}

/// Whether a solid at rest stands above all of the water, where it cuts none of its rows.
bool stays_dry(const Case& c, const Solid& solid) {
    if (!solid.rests() || !c.start.water_x.empty()) return false;
    const SolidMesh* const mesh = c.channel.dimensions == 3 ? mesh_of(c, solid) : nullptr;
    const double lowest = mesh != nullptr   ? mesh->lower()[2]
                          : solid.z.empty() ? 0.0
                                            : *std::min_element(solid.z.begin(), solid.z.end());
    return lowest >= c.total_depth();
}

/// The water that an outline gives a plane case at its start, in cells of a spacing. None of what is no
/// outline, and where they would be too many to look at: what the keys demand of each other is judged later.
class WaterCells {
  public:
    explicit WaterCells(const Case& c)
        : spacing_(c.numerics.spacing), water_{c.start.water_x, c.start.water_z} {
        if (water_.x.size() != water_.z.size()) return;
        const double top = *std::max_element(water_.z.begin(), water_.z.end());
        const double columns = std::ceil(c.channel.length / spacing_);
        const double rows = std::ceil(top / spacing_) + 1.0;
        constexpr double most = 1e6;
        if (!(columns > 0.0 && rows > 0.0 && columns * rows < most)) return;
        columns_ = static_cast<int>(columns);
        rows_ = static_cast<int>(rows);
        for (const Solid& solid : c.solids) solids_.push_back({solid.x, solid.z});
        for (int i = 0; i < columns_; ++i) {
            for (int k = 0; k < rows_; ++k) cells_.push_back(find(i, k));
        }
    }

    /// Whether each pool of it has one level, and walls, solids or water on either side and below.
    [[nodiscard]] bool rests() {
        if (cells_.empty()) return false;
        for (int i = 0; i < columns_; ++i) {
            for (int k = 0; k < rows_; ++k) {
                if (at(i, k) == Cell::water && !pool_rests(i, k)) return false;
            }
        }
        return true;
    }

  private:
    enum class Cell : char { air, water, seen, solid };

    [[nodiscard]] Cell find(int i, int k) const {
        const double x = (i + 0.5) * spacing_;
        const double z = (k + 0.5) * spacing_;
        const auto holds_place = [x, z](const Outline& outline) { return contains(outline, x, z); };
        if (std::any_of(solids_.begin(), solids_.end(), holds_place)) return Cell::solid;
        return holds_place(water_) ? Cell::water : Cell::air;
    }
    [[nodiscard]] Cell& at(int i, int k) {
        return cells_[static_cast<std::size_t>(i) * static_cast<std::size_t>(rows_) +
                      static_cast<std::size_t>(k)];
    }
    [[nodiscard]] bool is_air(int i, int k) {
        return i >= 0 && i < columns_ && k >= 0 && (k >= rows_ || at(i, k) == Cell::air);
    }

    /// Of all cells that hang together with one.
    bool pool_rests(int i, int k) {
        std::vector<std::array<int, 2>> pending{{i, k}};
        at(i, k) = Cell::seen;
        std::optional<int> surface;
        while (!pending.empty()) {
            const auto [x, z] = pending.back();
            pending.pop_back();
            if (is_air(x - 1, z) || is_air(x + 1, z) || is_air(x, z - 1)) return false;
            if (is_air(x, z + 1) && surface.value_or(z) != z) return false;
            if (is_air(x, z + 1)) surface = z;
            for (const auto& [dx, dz] : {std::array{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
                const int beside = x + dx;
                const int over = z + dz;
                if (beside < 0 || beside >= columns_ || over < 0 || over >= rows_) continue;
                if (at(beside, over) != Cell::water) continue;
                at(beside, over) = Cell::seen;
                pending.push_back({beside, over});
            }
        }
        return true;
    }

    double spacing_;
    Outline water_;
    std::vector<Outline> solids_;
    int columns_ = 0;
    int rows_ = 0;
    std::vector<Cell> cells_;
};

bool all_rest(const Case& c) {
    return std::all_of(c.solids.begin(), c.solids.end(), [](const Solid& solid) { return solid.rests(); });
}

/// Whether neither a slope nor a lid drives the water, and its surface is free.
bool is_undriven(const Case& c) {
    return flow_kind(c) == FlowKind::tank && c.streamwise_gravity() == 0.0 && c.channel.lid_velocity == 0.0 &&
           c.channel.top == Top::free_surface && c.fluid.gravity > 0.0;
}

bool comes_back(const Solid& solid) {
    return solid.rests() || (solid.motion == SolidMotion::oscillating && solid.amplitude_angle == 0.0);
}

}  // namespace

bool has_inclined_faces(const Case& c, const Solid& solid) {
    if (c.channel.dimensions == 2) {
        for (std::size_t i = 0; i < solid.x.size(); ++i) {
            const std::size_t next = (i + 1) % solid.x.size();
            if (is_inclined<2>({solid.x[next] - solid.x[i], solid.z[next] - solid.z[i]})) {
                return true;
            }
        }
        return false;
    }
    const SolidMesh* const mesh = mesh_of(c, solid);
    if (mesh == nullptr) return false;
    const auto& triangles = mesh->tree().triangles();
    return std::any_of(triangles.begin(), triangles.end(),
                       [](const Triangle& t) { return is_inclined<3>(normal_of(t)); });
}

bool is_quiet_beside_inclined_faces(const Case& c) {
    return is_undriven(c) && std::all_of(c.solids.begin(), c.solids.end(), comes_back) &&
           std::any_of(c.solids.begin(), c.solids.end(), [&c](const Solid& solid) {
               return has_inclined_faces(c, solid) && !stays_dry(c, solid);
           });
}

bool is_still(const Case& c) {
    const bool starts_at_rest = c.channel.dimensions == 2 && c.channel.ends == Ends::walls &&
                                is_undriven(c) && all_rest(c) && c.porous.empty() &&
                                c.start.kind == StartKind::rest;
    return starts_at_rest && (c.start.water_x.empty() || WaterCells(c).rests());
}

void choose_for_quiet_water(Case& c, const GivenNumerics& given) {
    Numerics& n = c.numerics;
    if (n.preset != Preset::riffle || n.wall != WallKind::dummy) return;
    if (!is_quiet_beside_inclined_faces(c) && !is_still(c)) return;
    const bool space = c.channel.dimensions == 3;
    if (!given.lattice) c.start.lattice = quiet_lattice(c);
    // The smoothing length goes with that lattice alone.
    if (!given.smoothing_ratio && c.start.lattice == quiet_lattice(c)) {
        n.smoothing_ratio = quiet_smoothing_ratio(c);
    }
    if (!given.wall_layers) n.wall_layers = layers_of_kernel(n.smoothing_ratio);
    if (!given.pressure_correction_time && n.pressure_form == PressureForm::corrected) {
        n.pressure_correction_time = quiet_correction_time(c);
    }
    if (space && all_rest(c) && !given.settling_time && c.start.kind == StartKind::rest &&
        c.start.water_x.empty()) {
        c.start.settling_time = quiet_settling_time;
    }
}

std::optional<std::string> quiet_water_note(const Case& c) {
    const bool beside_faces = is_quiet_beside_inclined_faces(c);
    if (!beside_faces && !is_still(c)) return std::nullopt;
    const Numerics& n = c.numerics;
    std::vector<std::string> chosen;
    if (c.start.lattice == quiet_lattice(c)) {
        chosen.push_back(fmt::format(
            "{} lattice", c.start.lattice == StartLattice::hexagonal ? "hexagonal" : "body-centred"));
    }
    if (n.smoothing_ratio == quiet_smoothing_ratio(c)) {
        chosen.push_back(fmt::format("h = {} dx", n.smoothing_ratio));
    }
    if (n.pressure_correction_time == quiet_correction_time(c)) {
        chosen.push_back(
            fmt::format("mean of the pressure's correction over {:.4g} s", n.pressure_correction_time));
    }
    if (c.start.settling_time == quiet_settling_time) {
        chosen.push_back(fmt::format("{:.3g} s to settle before the run", c.start.settling_time));
    }
    if (chosen.empty()) return std::nullopt;
    return fmt::format("{}: the defaults {}", fmt::join(chosen, ", "),
                       beside_faces ? "beside inclined faces" : "where nothing moves the water");
}

}  // namespace riffle::inline case_file

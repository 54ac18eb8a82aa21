#include "solver/profile_blocks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "base/due_times.hpp"
#include "base/interpolation.hpp"
#include "base/not_a_number.hpp"
#include "base/parallel.hpp"
#include "case/end_buffers.hpp"
#include "case/flow_kind.hpp"
#include "particles/lattice.hpp"
#include "solver/averaging_rows.hpp"
#include "statistics/confidence.hpp"

namespace riffle::inline solver {

namespace {

constexpr std::size_t index(LayerQuantity q) { return static_cast<std::size_t>(q); }

/// Stress of a twin at height z, Pa, from its profile: rho g S0 (H - z) less the drag above z.
double stress_at(const std::vector<double>& height, const std::vector<double>& stress, double z) {
    if (z >= height.back()) {
        // Above the last cell centre the stress goes to zero at the surface on its straight line.
        const double dz = height[height.size() - 1] - height[height.size() - 2];
        const double slope = (stress[stress.size() - 1] - stress[stress.size() - 2]) / dz;
        return stress.back() + slope * (z - height.back());
    }
    return place_in(height, z).in(stress);
}

/// Mean of the section's stress tau_xz across the channel at each of its heights, Pa.
std::vector<double> mean_stress(const SectionResult& section) {
    std::vector<double> mean(section.z.size(), 0.0);
    double face = 0.0;  // of the cell, nearer to y = 0; the centres lie in the middle of the cells
    for (std::size_t iy = 0; iy < section.y.size(); ++iy) {
        const double width = 2.0 * (section.y[iy] - face);
        for (std::size_t iz = 0; iz < mean.size(); ++iz) {
            mean[iz] += width * section.shear_stress[iz * section.y.size() + iy];
        }
        face += width;
    }
    for (double& stress : mean) stress /= face;
    return mean;
}

}  // namespace

std::span<const std::string> profile_quantity_names(int dimensions) {
    static const std::array<std::string, profile_quantities(3)> names = {"count",
                                                                         "height",
                                                                         "u",
                                                                         "w",
                                                                         "uu",
                                                                         "ww",
                                                                         "uw",
                                                                         "column_u",
                                                                         "shear",
                                                                         "eddy_viscosity",
                                                                         "pressure",
                                                                         "density",
                                                                         "mass",
                                                                         "pair_force",
                                                                         "viscous_force",
                                                                         "drag_force",
                                                                         "v",
                                                                         "vv",
                                                                         "uv",
                                                                         "vw",
                                                                         "side_wall_force"};
    return std::span(names).first(profile_quantities(dimensions));
}

ProfileSampler::ProfileSampler(const Case& c, const ColumnResult* column, const SectionResult* section)
    : case_(c), column_(column), section_(section), quantities_(profile_quantities(c.channel.dimensions)) {
    const Lattice lattice = lattice_of(c);
    layers_ = static_cast<std::size_t>(averaging_rows(c));
    thickness_ = lattice.dz;
    plan_area_ = c.channel.length * c.channel.flow_width();
    current_.end = profile_block_duration;
    current_.sums.assign(layers_ * quantities_, 0.0);
}

template <int D>
void ProfileSampler::add_particles(const SimulationIn<D>& simulation, std::size_t begin, std::size_t end,
                                   std::vector<double>& layer_sums) const {
    const Particles<D>& p = simulation.particles();
    const ParticleFields& f = simulation.fields();
    const auto twin_velocity = [&](const Particles<D>& of, std::size_t i) {
        const double z = of.position[D - 1][i];
        if (D == 3 && section_ != nullptr) return section_->velocity_at(of.position[1][i], z);
        return column_ != nullptr ? column_->velocity_at(z) : 0.0;
    };
    for (std::size_t i = begin; i < end; ++i) {
        if (!in_channel(case_, p.position[0][i])) continue;
        const double z = p.position[D - 1][i];
        const double u = p.velocity[0][i];
        const double w = p.velocity[D - 1][i];
        const double mass = p.mass[i];
        // A particle above the last layer or below the first belongs to it: none is dropped.
        const auto layer =
            static_cast<std::size_t>(std::clamp(z / thickness_, 0.0, static_cast<double>(layers_) - 0.5));
        double* sums = &layer_sums[layer * profile_quantities(D)];
        const auto add = [&](LayerQuantity q, double value) { sums[index(q)] += value; };
        add(LayerQuantity::count, 1.0);
        add(LayerQuantity::height, z);
        add(LayerQuantity::u, u);
        add(LayerQuantity::w, w);
        add(LayerQuantity::uu, u * u);
        add(LayerQuantity::ww, w * w);
        add(LayerQuantity::uw, u * w);
        add(LayerQuantity::column_u, twin_velocity(p, i));
        add(LayerQuantity::shear, f.shear[i]);
        add(LayerQuantity::eddy_viscosity, f.eddy_viscosity[i]);
        add(LayerQuantity::pressure, f.pressure[i]);
        add(LayerQuantity::density, p.density_deviation[i]);
        add(LayerQuantity::mass, mass);
        add(LayerQuantity::pair_force, mass * f.pair_acceleration_x[i]);
        add(LayerQuantity::viscous_force, mass * f.viscous_acceleration_x[i]);
        add(LayerQuantity::drag_force,
            mass * (f.drag_acceleration_x[i] + f.vegetation_acceleration_x[i] + f.porous_acceleration_x[i]));
        if constexpr (D == 3) {
            const double v = p.velocity[1][i];
            add(LayerQuantity::v, v);
            add(LayerQuantity::vv, v * v);
            add(LayerQuantity::uv, u * v);
            add(LayerQuantity::vw, v * w);
            add(LayerQuantity::side_wall_force, mass * f.side_wall_acceleration_x[i]);
        }
    }
}

template <int D>
void ProfileSampler::sample(const SimulationIn<D>& simulation) {
    const std::size_t n = simulation.particles().size();
    if constexpr (D == 2) {
        add_particles(simulation, 0, n, current_.sums);
    } else {
        // Many particles: in parallel.
        constexpr std::size_t block = std::size_t{1} << 15U;
        const std::vector<double> none(current_.sums.size(), 0.0);
        current_.sums = reduce_blocks(
            n, block, current_.sums,
            [&](std::size_t begin, std::size_t end) {
                std::vector<double> sums = none;
                add_particles(simulation, begin, end, sums);
                return sums;
            },
            [](std::vector<double> sums, const std::vector<double>& part) {
                std::transform(sums.begin(), sums.end(), part.begin(), sums.begin(), std::plus<>());
                return sums;
            });
    }
    current_.samples += 1.0;
    if (has_come(simulation.clock().time, current_.end, profile_block_duration)) {
        blocks_.push_back(current_);
        // Blocks end on multiples of their duration; a long step may pass several.
        current_.end = due_next(simulation.clock().time, current_.end, profile_block_duration);
        current_.samples = 0.0;
        std::fill(current_.sums.begin(), current_.sums.end(), 0.0);
    }
}

template void ProfileSampler::sample(const SimulationIn<2>&);
template void ProfileSampler::sample(const SimulationIn<3>&);

void ProfileSampler::restore(std::vector<ProfileBlock> blocks, ProfileBlock current) {
    blocks_ = std::move(blocks);
    current_ = std::move(current);
}

std::vector<double> ProfileSampler::lost_above(const std::vector<double>& sums, LayerQuantity force,
                                               double per_area) const {
    std::vector<double> lost(layers_, 0.0);
    double sum = 0.0;
    for (std::size_t layer = layers_; layer-- > 0;) {
        lost[layer] = -sum;
        sum += sums[layer * quantities_ + index(force)] * per_area;
    }
    return lost;
}

std::vector<double> ProfileSampler::stress_of_means(const std::vector<double>& sums) const {
    const auto mean = [&](std::size_t layer, LayerQuantity q) {
        const double* s = &sums[layer * quantities_];
        return s[index(q)] / s[index(LayerQuantity::count)];
    };
    const auto holds_water = [&](std::size_t layer) {
        return sums[layer * quantities_ + index(LayerQuantity::count)] > 0.0;
    };
    std::vector<double> upper(layers_, 0.0);
    for (std::size_t layer = 0; layer + 1 < layers_; ++layer) {
        if (!holds_water(layer) || !holds_water(layer + 1)) continue;
        const double eddies = 0.5 * (mean(layer, LayerQuantity::eddy_viscosity) +
                                     mean(layer + 1, LayerQuantity::eddy_viscosity));
        const double gradient = (mean(layer + 1, LayerQuantity::u) - mean(layer, LayerQuantity::u)) /
                                (mean(layer + 1, LayerQuantity::height) - mean(layer, LayerQuantity::height));
        upper[layer] = case_.fluid.density * (case_.fluid.kinematic_viscosity + eddies) * gradient;
    }
    if (case_.channel.top == Top::wall && layers_ > 2) {
        upper.back() = 2.0 * upper[layers_ - 2] - upper[layers_ - 3];
    }
    return upper;
}

Profiles ProfileSampler::average(double from, double to) const {
    Profiles result;
    std::vector<double> sums(layers_ * quantities_, 0.0);
    std::vector<std::vector<double>> layer_velocity(layers_);
    const double tolerance = 1e-6;
    for (const ProfileBlock& block : blocks_) {
        if (block.end > to + tolerance || block.end - profile_block_duration < from - tolerance ||
            block.samples == 0.0) {
            continue;
        }
        result.window_start =
            result.samples == 0.0 ? block.end - profile_block_duration : result.window_start;
        result.window_end = block.end;
        result.samples += block.samples;
        for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += block.sums[k];
        for (std::size_t layer = 0; layer < layers_; ++layer) {
            const double* s = &block.sums[layer * quantities_];
            if (s[index(LayerQuantity::count)] > 0.0) {
                layer_velocity[layer].push_back(s[index(LayerQuantity::u)] / s[index(LayerQuantity::count)]);
            }
        }
    }
    if (result.samples == 0.0) return result;
    const double rho = case_.fluid.density;
    const std::vector<double> section_stress =
        section_ != nullptr ? mean_stress(*section_) : std::vector<double>();
    const std::vector<double>* twin_height = nullptr;
    const std::vector<double>* twin_stress = nullptr;
    if (section_ != nullptr) {
        twin_height = &section_->z;
        twin_stress = &section_stress;
    } else if (column_ != nullptr) {
        twin_height = &column_->profile.z;
        twin_stress = &column_->profile.shear_stress;
    }
    const double per_area = 1.0 / (result.samples * plan_area_);
    const std::vector<double> pair_upper = lost_above(sums, LayerQuantity::pair_force, per_area);
    const std::vector<double> viscous_upper = only_bed_holds(case_)
                                                  ? lost_above(sums, LayerQuantity::viscous_force, per_area)
                                                  : stress_of_means(sums);
    // Between ends that differ the pressure drives the water, which is no stress on planes.
    const bool has_pair_stress = case_.channel.ends == Ends::periodic;
    std::vector<double> reynolds(layers_, 0.0);
    for (std::size_t layer = 0; layer < layers_; ++layer) {
        const double* s = &sums[layer * quantities_];
        const double n = s[index(LayerQuantity::count)];
        reynolds[layer] = n > 0.0 ? -rho * (s[index(LayerQuantity::uw)] / n -
                                            s[index(LayerQuantity::u)] * s[index(LayerQuantity::w)] / (n * n))
                                  : 0.0;
    }
    for (std::size_t layer = 0; layer < layers_; ++layer) {
        const double* s = &sums[layer * quantities_];
        const double n = s[index(LayerQuantity::count)];
        if (n == 0.0) {
            continue;  // no particle was ever here: the profile has no value at this height
        }
        const auto mean = [&](LayerQuantity q) { return s[index(q)] / n; };
        const double upper = static_cast<double>(layer + 1) * thickness_;
        const double u = mean(LayerQuantity::u);
        const double w = mean(LayerQuantity::w);
        result.bin_lower.push_back(static_cast<double>(layer) * thickness_);
        result.bin_upper.push_back(upper);
        result.z.push_back(mean(LayerQuantity::height));
        result.velocity.push_back(u);
        result.velocity_half_width.push_back(
            trusted_half_width(mean_with_confidence(layer_velocity[layer])).value_or(not_a_number));
        result.vertical_velocity.push_back(w);
        result.column_velocity.push_back(mean(LayerQuantity::column_u));
        result.velocity_deviation.push_back(u - mean(LayerQuantity::column_u));
        result.velocity_gradient.push_back(mean(LayerQuantity::shear));
        result.eddy_viscosity.push_back(mean(LayerQuantity::eddy_viscosity));
        result.pressure.push_back(mean(LayerQuantity::pressure));
        result.density.push_back(rho * (1.0 + mean(LayerQuantity::density)));
        result.velocity_rms.push_back(std::sqrt(std::max(0.0, mean(LayerQuantity::uu) - u * u)));
        result.vertical_velocity_rms.push_back(std::sqrt(std::max(0.0, mean(LayerQuantity::ww) - w * w)));
        const double reynolds_upper =
            layer + 1 < layers_ ? 0.5 * (reynolds[layer] + reynolds[layer + 1]) : 0.0;
        result.reynolds_stress.push_back(reynolds_upper);
        if (has_pair_stress) result.pair_stress.push_back(pair_upper[layer]);
        result.viscous_stress.push_back(viscous_upper[layer]);
        result.total_stress.push_back(reynolds_upper + (has_pair_stress ? pair_upper[layer] : 0.0) +
                                      viscous_upper[layer]);
        // Walls, stems and stones carry a part of the weight that a twin alone knows.
        const bool bed_alone = only_bed_holds(case_) && !case_.has_side_wall_drag() &&
                               case_.vegetation.empty() && case_.porous.empty();
        if (has_pair_stress && (twin_height != nullptr || bed_alone)) {
            const double line = rho * case_.streamwise_gravity() * (case_.total_depth() - upper);
            const bool of_twin = twin_height != nullptr && (case_.channel.top == Top::wall ||
                                                            upper < case_.total_depth() - 0.5 * thickness_);
            result.analytic_stress.push_back(of_twin ? stress_at(*twin_height, *twin_stress, upper) : line);
        }
        const double volume = result.samples * plan_area_ * thickness_;
        result.drag.push_back(s[index(LayerQuantity::drag_force)] / volume);
        if (quantities_ > index(LayerQuantity::v)) {
            const double v = mean(LayerQuantity::v);
            result.spanwise_velocity.push_back(v);
            result.spanwise_velocity_rms.push_back(std::sqrt(std::max(0.0, mean(LayerQuantity::vv) - v * v)));
            result.side_wall_drag.push_back(s[index(LayerQuantity::side_wall_force)] / volume);
        }
    }
    return result;
}

}  // namespace riffle::inline solver

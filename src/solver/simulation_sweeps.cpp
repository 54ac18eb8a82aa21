// The sweeps over the clusters that make up a force evaluation.

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "solver/simulation_of.hpp"

namespace riffle {

namespace {
/// Clusters per task of a sweep: about 10 microseconds of work.
constexpr std::size_t sweep_block = 16;
}  // namespace

template <class Real>
void SimulationOf<Real>::sweep_gradients(double density_step) {
    parallel_blocks(clusters_.size(), sweep_block, [&](std::size_t begin, std::size_t end) {
        loops_.gradient(data_, begin, end);
        for (std::size_t cluster = begin; cluster < end; ++cluster) {
            const auto [first, last] = particles_of(cluster);
            const std::size_t slot = cluster * cluster_size;
            for (std::size_t i = first; i < last; ++i) {
                const std::size_t lane = slot + (i - first);
                double& s = particles_.density_deviation[i];
                density_rate_[i] = (1.0 + s) * static_cast<double>(data_.gradient.density_rate[lane]) +
                                   static_cast<double>(data_.gradient.diffusion[lane]);
                s += density_step * density_rate_[i];
            }
            evaluate_closure(first, last, slot);
            for (std::size_t i = first; i < last; ++i) {
                pack_force(i, slot + (i - first));
            }
        }
    });
}

template <class Real>
void SimulationOf<Real>::evaluate_closure(std::size_t first, std::size_t last, std::size_t slot) {
    const std::size_t count = last - first;
    const auto& gradient = data_.gradient.velocity_gradient;
    if (closure_) {
        closure_->mixing_lengths({&particles_.position[1][first], count}, {&mixing_length_[first], count});
    }
    for (std::size_t i = first; i < last; ++i) {
        const std::size_t lane = slot + (i - first);
        const auto g = [&](std::size_t k) { return static_cast<double>(gradient[k][lane]); };
        fields_.shear[i] = g(1);
        fields_.regularity[i] = static_cast<double>(data_.gradient.regularity[lane]);
        double nu_t = 0.0;
        if (closure_) {
            // |S| = sqrt(2 S_ij S_ij); the paper keeps only du/dz.
            const double shear_rate = g(1) + g(2);
            const double strain =
                case_.turbulence.stress_terms == StressTerms::shear
                    ? std::abs(g(1))
                    : std::sqrt(2.0 * (g(0) * g(0) + g(3) * g(3)) + shear_rate * shear_rate);
            nu_t = mixing_length_viscosity(mixing_length_[i], strain);
        }
        fields_.eddy_viscosity[i] = nu_t;
    }
}

template <class Real>
void SimulationOf<Real>::pack_force(std::size_t i, std::size_t slot) {
    ForceRecord<2, Real>& record = data_.fluid_force[slot];
    const GradientRecord<2, Real>& gradient = data_.fluid_gradient[slot];
    const double s = particles_.density_deviation[i];
    const double pressure = scheme_.state.pressure(s);
    const double volume = particles_.mass[i] / (scheme_.density * (1.0 + s));
    record.x = gradient.x;
    record.u = gradient.u;
    record.volume = static_cast<Real>(volume);
    fields_.pressure[i] = scheme_.density * pressure;

    const bool corrected = case_.numerics.pressure_form == PressureForm::corrected;
    // Symmetric form (thesis 2.42): Q = p/rho^2 with weight m_j. Corrected: Q = p B with weight V_j/(1 +
    // s_i).
    const double tensor_scale = corrected ? 1.0 : 1.0 / ((1.0 + s) * (1.0 + s));
    record.weight = static_cast<Real>(corrected ? volume : volume * (1.0 + s));
    const double scalar = pressure * tensor_scale;
    data_.fluid_pressure[slot] = static_cast<Real>(scalar);
    for (std::size_t k = 0; k < 4; ++k) {
        record.stress[k] =
            static_cast<Real>(scalar * static_cast<double>(data_.gradient.correction[k][slot]));
    }
    double nu = scheme_.viscosity;
    if (case_.numerics.eddy_stress == EddyStress::two_point) {
        nu += fields_.eddy_viscosity[i];
    } else if (closure_) {
        // tau_ij = rho nu_t 2 S_ij, in the stress-divergence form of the thesis (4.1) part of the tensor.
        const auto g = [&](std::size_t k) {
            return static_cast<double>(data_.gradient.velocity_gradient[k][slot]);
        };
        const double nu_t = fields_.eddy_viscosity[i] * (1.0 + s) * tensor_scale;
        const bool shear_only = case_.turbulence.stress_terms == StressTerms::shear;
        const double shear = nu_t * (shear_only ? g(1) : g(1) + g(2));
        record.stress[1] -= static_cast<Real>(shear);
        record.stress[2] -= static_cast<Real>(shear);
        if (!shear_only) {
            record.stress[0] -= static_cast<Real>(2.0 * nu_t * g(0));
            record.stress[3] -= static_cast<Real>(2.0 * nu_t * g(3));
        }
    }
    nu *= static_cast<double>(data_.gradient.viscosity_factor[slot]);
    record.viscosity_root = static_cast<Real>(std::sqrt((1.0 + s) * nu));
}

template <class Real>
void SimulationOf<Real>::sweep_walls(double step) {
    if (walls_.size() == 0) {
        return;
    }
    parallel_blocks(wall_clusters_.size(), sweep_block, [&](std::size_t begin, std::size_t end) {
        loops_.wall(data_, begin, end);
        for (std::size_t slot = begin * cluster_size; slot < end * cluster_size; ++slot) {
            const std::int32_t particle = wall_clusters_.particle_of_slot[slot];
            if (particle < 0) {
                continue;
            }
            const auto i = static_cast<std::size_t>(particle);
            auto& record = data_.wall_force[slot];
            double pressure = 0.0;
            const auto weight = static_cast<double>(data_.wall.weight[slot]);
            if (wall_law_.dynamic) {
                double& s = wall_deviation_[i];
                s += step * (1.0 + s) * static_cast<double>(data_.wall.density_rate[slot]);
                pressure = scheme_.state.pressure(s);
            } else if (weight > 0.0) {
                // Adami et al. (2012), eq. 27: p_w = [sum p_f W + g . sum rho r_wf W] / sum W.
                pressure = (static_cast<double>(data_.wall.pressure[slot]) -
                            scheme_.normal_gravity * static_cast<double>(data_.wall.offset[1][slot])) /
                           weight;
                wall_deviation_[i] = scheme_.state.deviation(pressure);
                wet_wall(slot, i, pressure);
            }
            record.stress = {static_cast<Real>(pressure), Real(0), Real(0), static_cast<Real>(pressure)};
            record.u = {};
            if (wall_law_.no_slip && !wall_law_.dynamic && weight > 0.0) {
                // No slip at the wall's surface: u is extrapolated along the line through zero at the surface
                // that fits the fluid's momentum near by, so that a linear profile is met exactly.
                const double nx = walls_.normal[0][i];
                const double nz = walls_.normal[1][i];
                const double height = -(nx * static_cast<double>(data_.wall.offset[0][slot]) +
                                        nz * static_cast<double>(data_.wall.offset[1][slot])) -
                                      walls_.depth[i] * weight;
                if (height > 0.0) {
                    for (std::size_t k = 0; k < 2; ++k) {
                        record.u[k] = static_cast<Real>(-walls_.depth[i] / height *
                                                        static_cast<double>(data_.wall.velocity[k][slot]));
                    }
                }
            }
        }
    });
}

// An end wall stands higher than the water. Its particles above the surface, where the extrapolated pressure
// is negative, must be as empty as the space over the rest of the surface, or they pull at the water below:
// their volume fades out over one spacing.
template <class Real>
void SimulationOf<Real>::wet_wall(std::size_t slot, std::size_t particle, double pressure) {
    if (walls_.normal[1][particle] != 0.0 || scheme_.normal_gravity <= 0.0) {
        return;
    }
    const double wetness =
        std::clamp(0.5 + pressure / (scheme_.normal_gravity * case_.numerics.spacing), 0.0, 1.0);
    const auto volume = static_cast<Real>(wetness * walls_.volume[particle]);
    data_.wall_gradient[slot].volume = volume;
    data_.wall_force[slot].weight = volume;
    data_.wall_force[slot].volume = wall_law_.no_slip ? volume : Real(0);
}

template <class Real>
void SimulationOf<Real>::sweep_forces(const std::function<void(std::size_t, std::size_t)>& move) {
    measure_stirring();
    const bool corrected = case_.numerics.pressure_form == PressureForm::corrected;
    parallel_blocks(clusters_.size(), sweep_block, [&](std::size_t begin, std::size_t end) {
        loops_.force(data_, begin, end);
        for (std::size_t cluster = begin; cluster < end; ++cluster) {
            const auto [first, last] = particles_of(cluster);
            const std::size_t slot = cluster * cluster_size;
            if (drag_) {
                drag_->coefficients({&particles_.position[1][first], last - first},
                                    {&drag_coefficient_[first], last - first});
            }
            double largest = 0.0;
            for (std::size_t i = first; i < last; ++i) {
                const std::size_t lane = slot + (i - first);
                const double inverse = 1.0 / (1.0 + particles_.density_deviation[i]);
                const double tensor_factor = corrected ? inverse : 1.0;
                std::array<double, 2> a{};
                for (std::size_t k = 0; k < 2; ++k) {
                    const double tensor = tensor_factor * static_cast<double>(data_.force.tensor[k][lane]);
                    const double viscous = inverse * static_cast<double>(data_.force.viscous[k][lane]);
                    a[k] = tensor + viscous;
                    if (k == 0) {
                        fields_.pair_acceleration_x[i] = tensor;
                        fields_.viscous_acceleration_x[i] = viscous;
                        fields_.wall_acceleration_x[i] =
                            inverse * static_cast<double>(data_.force.wall[0][lane]);
                    }
                }
                body_forces(i, a[0], a[1]);
                acceleration_[0][i] = a[0];
                acceleration_[1][i] = a[1];
                largest = std::max(largest, a[0] * a[0] + a[1] * a[1]);
            }
            cluster_largest_[cluster] = largest;
            move(first, last);
        }
    });
}

// The mean of the stirring over the particles: taken off it, so that it adds no streamwise momentum even
// where the particles' spacing correlates with its pattern.
template <class Real>
void SimulationOf<Real>::measure_stirring() {
    if (!stirring_.active()) {
        return;
    }
    using Sums = std::array<double, 2>;
    const Sums sums = reduce_blocks(
        particles_.size(), std::size_t{1024}, Sums{},
        [&](std::size_t begin, std::size_t end) {
            Sums part{};
            for (std::size_t i = begin; i < end; ++i) {
                double ax = 0.0;
                double az = 0.0;
                stirring_.add(particles_.position[0][i], particles_.position[1][i], clock_.time, ax, az);
                part[0] += particles_.mass[i] * ax;
                part[1] += particles_.mass[i];
            }
            return part;
        },
        [](const Sums& a, const Sums& b) {
            return Sums{a[0] + b[0], a[1] + b[1]};
        });
    stirring_mean_ = sums[0] / sums[1];
}

template <class Real>
void SimulationOf<Real>::body_forces(std::size_t i, double& ax, double& az) const {
    ax += scheme_.streamwise_gravity;
    az -= scheme_.normal_gravity;
    if (stirring_.active()) {
        stirring_.add(particles_.position[0][i], particles_.position[1][i], clock_.time, ax, az);
        ax -= stirring_mean_;
    }
}

template <class Real>
void SimulationOf<Real>::allocate_filter() {
    auto& filter = data_.filter;
    const std::size_t slots = clusters_.slots();
    filter.zeroth.resize(slots);
    filter.mass.resize(slots);
    for (std::size_t k = 0; k < 2; ++k) {
        filter.first[k].resize(slots);
        filter.mass_first[k].resize(slots);
        filter.velocity[k].resize(slots);
    }
    for (auto& moment : filter.second) {
        moment.resize(slots);
    }
}

template <class Real>
void SimulationOf<Real>::sweep_smoothed_velocity() {
    allocate_filter();
    parallel_blocks(clusters_.size(), sweep_block,
                    [&](std::size_t begin, std::size_t end) { loops_.filter(data_, begin, end); });
}

template <class Real>
void SimulationOf<Real>::filter_density() {
    allocate_filter();
    const auto& filter = data_.filter;
    const double h = scheme_.smoothing_length;
    const bool mls = case_.numerics.density_filter == DensityFilter::mls;
    parallel_blocks(clusters_.size(), sweep_block, [&](std::size_t begin, std::size_t end) {
        loops_.filter(data_, begin, end);
        for (std::size_t slot = begin * cluster_size; slot < end * cluster_size; ++slot) {
            const std::int32_t particle = clusters_.particle_of_slot[slot];
            if (particle < 0) {
                continue;
            }
            const auto get = [&](const std::vector<Real>& values) {
                return static_cast<double>(values[slot]);
            };
            const double zeroth = get(filter.zeroth);
            // Shepard: rho = sum m W / sum V W.
            double density = get(filter.mass) / zeroth;
            if (mls) {
                // MLS (Dilts; Colagrossi & Landrini 2003): rho = sum m W (b0 + b.r), A b = e0, lengths in h.
                const double a01 = get(filter.first[0]) / h;
                const double a02 = get(filter.first[1]) / h;
                const double a11 = get(filter.second[0]) / (h * h);
                const double a12 = get(filter.second[1]) / (h * h);
                const double a22 = get(filter.second[2]) / (h * h);
                const double c00 = a11 * a22 - a12 * a12;
                const double c01 = a02 * a12 - a01 * a22;
                const double c02 = a01 * a12 - a02 * a11;
                const double det = zeroth * c00 + a01 * c01 + a02 * c02;
                // Too few neighbours for a plane (spray): Shepard's mean stands.
                if (det > 1e-6 * zeroth) {
                    density = (c00 * get(filter.mass) + c01 * get(filter.mass_first[0]) / h +
                               c02 * get(filter.mass_first[1]) / h) /
                              det;
                }
            }
            particles_.density_deviation[static_cast<std::size_t>(particle)] = density - 1.0;
        }
    });
}

template class SimulationOf<float>;
template class SimulationOf<double>;

}  // namespace riffle

#include "instruments/fluid_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "boundary/wall.hpp"
#include "case/porous_zone.hpp"
#include "particles/lattice.hpp"
#include "sph/correction.hpp"
#include "sph/kernel_registry.hpp"

namespace riffle::inline instruments {

namespace {

/// Sums over the neighbours of a point, weighted with the kernel: of 1, of the distances in smoothing lengths
/// and their products, and each of N quantities times 1 and the distances.
template <int D, std::size_t N>
struct Moments {
    static constexpr auto axes = static_cast<std::size_t>(D);
    double one = 0.0;
    double images = 0.0;  ///< of 1 over the mirror images
    Vec<D> r{};
    Symmetric<double, D> rr{};
    std::array<std::array<double, axes + 1>, N> quantity{};

    void add(double weight, const Vec<D>& distance, const std::array<double, N>& values) {
        one += weight;
        std::size_t product = 0;
        for (std::size_t k = 0; k < D; ++k) {
            r[k] += weight * distance[k];
            for (std::size_t l = k; l < D; ++l) rr[product++] += weight * distance[k] * distance[l];
        }
        for (std::size_t n = 0; n < N; ++n) {
            const double flux = weight * values[n];
            quantity[n][0] += flux;
            for (std::size_t l = 0; l < D; ++l) quantity[n][l + 1] += flux * distance[l];
        }
    }
};

/// Value at the point of the linear field that fits the neighbours best, from their moments. Where they are
/// too few or stand too much in line or plane to say a slope, their mean.
template <int D>
struct LinearFit {
    std::array<double, static_cast<std::size_t>(D) + 1> weight{};

    template <std::size_t N>
    explicit LinearFit(const Moments<D, N>& m) {
        weight[0] = 1.0 / m.one;
        if constexpr (D == 2) {
            // First row of the inverse of ((1, x, z), (x, xx, xz), (z, xz, zz)).
            const Symmetric<double, 3> matrix{m.one, m.r[0], m.r[1], m.rr[0], m.rr[1], m.rr[2]};
            const auto size = determinant<double, 3>(matrix);
            // Of a full support the second moments are about 0.3; a thousandth of that says nothing.
            if (size > 1e-4 * m.one * m.one * m.one) {
                const auto row = cofactors<double, 3>(matrix);
                weight = {row[0] / size, row[1] / size, row[2] / size};
            }
        } else {
            // The second moments about the neighbours' middle, N = M - r r^T / m; the first row of the
            // inverse of ((m, r^T), (r, M)) is (1/m + r.s/m, -s) with N s = r/m.
            Symmetric<double, 3> about = m.rr;
            std::size_t product = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                for (std::size_t l = k; l < 3; ++l) about[product++] -= m.r[k] * m.r[l] / m.one;
            }
            const auto size = determinant<double, 3>(about);
            // Of a full support the second moments are about 0.25; a thousandth of that says nothing.
            if (size > 1e-5 * m.one * m.one * m.one) {
                const auto c = cofactors<double, 3>(about);
                const auto [x, y, z] = m.r;
                const double scale = 1.0 / (size * m.one);
                const double s_x = scale * (c[0] * x + c[1] * y + c[2] * z);
                const double s_y = scale * (c[1] * x + c[3] * y + c[4] * z);
                const double s_z = scale * (c[2] * x + c[4] * y + c[5] * z);
                weight = {(1.0 + x * s_x + y * s_y + z * s_z) / m.one, -s_x, -s_y, -s_z};
            }
        }
    }
    [[nodiscard]] double value(const std::array<double, static_cast<std::size_t>(D) + 1>& sums) const {
        double result = weight[0] * sums[0];
        for (std::size_t k = 1; k <= D; ++k) result += weight[k] * sums[k];
        return result;
    }
};

/// The planes that end the water along a horizontal axis: end walls, side walls, a plane of symmetry; none
/// where it is periodic.
template <int D>
std::vector<double> planes_across(const Case& c, std::size_t axis) {
    if (axis == 0) {
        return c.channel.ends == Ends::walls ? std::vector{0.0, c.channel.length} : std::vector<double>{};
    }
    return domain_of<D>(c).periodic[axis] ? std::vector<double>{}
                                          : std::vector{0.0, c.channel.simulated_width()};
}

}  // namespace

std::optional<FluidView::Velocity> velocity_below(const FluidView& view, Vec<3> place,
                                                  double smoothing_length) {
    constexpr int points = 5;
    for (int point = 0; point < points; ++point) {
        const FluidView::Velocity velocity = view.velocity_at(place);
        if (std::isfinite(velocity.u)) return velocity;
        place[2] -= 0.5 * smoothing_length;
    }
    return std::nullopt;
}

template <int D>
typename FluidViewIn<D>::Mirrored FluidViewIn<D>::mirror(const Case& c, const Particles<D>& particles,
                                                         double reach) {
    Mirrored mirrored;
    const std::size_t n = particles.size();
    for (std::size_t axis = 0; axis + 1 < D; ++axis) {
        for (const double plane : planes_across<D>(c, axis)) {
            // Images have images where two walls meet.
            const std::size_t present = n + mirrored.of.size();
            for (std::size_t i = 0; i < present; ++i) {
                const auto value = [&](std::size_t k) {
                    return i < n ? particles.position[k][i] : mirrored.position[k][i - n];
                };
                const double place = value(axis);
                if (std::abs(place - plane) >= reach) continue;
                for (std::size_t k = 0; k < D; ++k) {
                    mirrored.position[k].push_back(k == axis ? 2.0 * plane - place : value(k));
                }
                mirrored.of.push_back(i < n ? i : mirrored.of[i - n]);
            }
        }
    }
    return mirrored;
}

template <int D>
typename FluidViewIn<D>::Positions FluidViewIn<D>::positions() const {
    Positions joined;
    for (std::size_t k = 0; k < D; ++k) {
        joined[k] = {particles_.position[k], mirrored_.position[k]};
    }
    return joined;
}

template <int D>
FluidViewIn<D>::FluidViewIn(const Case& c, const Particles<D>& particles, double h,
                            const WallParticles<D>* walls)
    : particles_(particles),
      walls_(walls),
      domain_(domain_of<D>(c)),
      kernel_(c.numerics.kernel),
      h_(h),
      width_(c.channel.flow_width()),
      gravity_(c.normal_gravity()),
      detection_(c.output.surface_detection),
      surface_threshold_(c.output.surface_threshold.value_or(usual_surface_threshold(detection_, D))),
      mirrored_(mirror(c, particles, 2.0 * h)),
      volume_(particles.size() + mirrored_.of.size()),
      cells_(domain_, positions(), 2.0 * h) {
    const std::size_t n = particles.size();
    for (std::size_t i = 0; i < n; ++i) {
        volume_[i] = particles.mass[i] / (c.fluid.density * (1.0 + particles.density_deviation[i]));
    }
    // With the grains around it.
    if (const PorosityField pores(c); !pores.empty()) {
        for (std::size_t i = 0; i < n; ++i) {
            porosity_.push_back(pores.porosity(vector_of(particles.position, i)));
            volume_[i] /= porosity_[i];
        }
    }
    for (std::size_t i = 0; i < mirrored_.of.size(); ++i) volume_[n + i] = volume_[mirrored_.of[i]];
}

template <int D>
template <class F>
void FluidViewIn<D>::weigh_around(const Vec<3>& point, const F& f) const {
    Vec<D> at{};
    at[0] = point[0];
    if constexpr (D == 3) at[1] = point[1];
    at[D - 1] = point[2];
    const double inverse_h = 1.0 / h_;
    visit_kernel<D>(kernel_, [&](auto kernel) {
        cells_.around(at, [&](std::size_t j) {
            Vec<D> r;
            double squared = 0.0;
            for (std::size_t k = 0; k < D; ++k) {
                r[k] = cells_.distance(k, cells_.positions()[k][j], at[k]) * inverse_h;
                squared += r[k] * r[k];
            }
            if (squared >= 4.0) return;
            double weight = volume_[j];
            for (std::size_t k = 0; k < D; ++k) weight *= inverse_h;
            weight *= decltype(kernel)::value(std::sqrt(squared));
            f(j, weight, r);
        });
    });
}

template <int D>
template <std::size_t N, class Values>
std::array<double, N> FluidViewIn<D>::interpolate(const Vec<3>& point, const Values& values_of) const {
    Moments<D, N> m;
    const std::size_t n = particles_.size();
    weigh_around(point, [&](std::size_t j, double weight, const Vec<D>& r) {
        if (j >= n) {
            m.images += weight;
            return;
        }
        m.add(weight, r, values_of(j));
    });
    std::array<double, N> result;
    if (m.one + m.images < wet_share) {
        result.fill(std::numeric_limits<double>::quiet_NaN());
        return result;
    }
    const LinearFit<D> fit(m);
    for (std::size_t k = 0; k < N; ++k) result[k] = fit.value(m.quantity[k]);
    return result;
}

template <int D>
FluidView::Velocity FluidViewIn<D>::velocity_at(const Vec<3>& point) const {
    const auto& velocity = particles_.velocity;
    if constexpr (D == 2) {
        const auto [u, w] = interpolate<2>(point, [&](std::size_t j) {
            return std::array<double, 2>{velocity[0][j], velocity[1][j]};
        });
        return {u, std::isnan(u) ? u : 0.0, w};
    } else {
        const auto [u, v, w] = interpolate<3>(point, [&](std::size_t j) {
            return std::array<double, 3>{velocity[0][j], velocity[1][j], velocity[2][j]};
        });
        return {u, v, w};
    }
}

template <int D>
FluidView::Flow FluidViewIn<D>::flow_at(const Vec<3>& point, const WorkingValues& pressure,
                                        std::span<const double> shear_stress) const {
    const auto& velocity = particles_.velocity;
    if constexpr (D == 2) {
        const auto [u, w, p, tau] = interpolate<4>(point, [&](std::size_t j) {
            return std::array<double, 4>{velocity[0][j], velocity[1][j], pressure[j], shear_stress[j]};
        });
        return {{u, std::isnan(u) ? u : 0.0, w}, p, tau};
    } else {
        const auto [u, v, w, p, tau] = interpolate<5>(point, [&](std::size_t j) {
            return std::array<double, 5>{velocity[0][j], velocity[1][j], velocity[2][j], pressure[j],
                                         shear_stress[j]};
        });
        return {{u, v, w}, p, tau};
    }
}

template <int D>
FluidView::Pressure FluidViewIn<D>::pressure_at(const Vec<3>& point, const WorkingValues& pressure,
                                                double weight) const {
    const std::size_t n = particles_.size();
    double share = 0.0;
    double images = 0.0;
    double sum = 0.0;
    weigh_around(point, [&](std::size_t j, double kernel, const Vec<D>& r) {
        (j < n ? share : images) += kernel;
        sum += kernel * (pressure[j < n ? j : mirrored_.of[j - n]] + weight * r[D - 1] * h_);
    });
    // The images centre the mean beside a wall; they are no water that covers the gauge.
    const double mean = share > 0.0 ? sum / (share + images) : 0.0;
    return {mean * std::min(1.0, share / least_wet_share), share};
}

template <int D>
FluidView::Pressure FluidViewIn<D>::pressure_on_solid(const Vec<3>& place, const WorkingValues& pressure,
                                                      double weight) const {
    constexpr double least = 0.2;
    constexpr double enough = 0.3;
    Pressure at = pressure_at(place, pressure, weight);
    const double trust = std::clamp((at.wet_share - least) / (enough - least), 0.0, 1.0);
    if (trust > 0.0) {
        Moments<D, 1> m;
        const std::size_t n = particles_.size();
        weigh_around(place, [&](std::size_t j, double kernel, const Vec<D>& r) {
            if (j < n) {
                m.add(kernel, r, {pressure[j]});
            }
        });
        at.pressure += trust * (LinearFit<D>(m).value(m.quantity[0]) - at.pressure);
    }
    return at;
}

template <int D>
std::vector<double> FluidViewIn<D>::surface_at(std::span<const Vec<2>> at) const {
    std::vector<Vec<D - 1>> places(at.size());
    for (std::size_t i = 0; i < at.size(); ++i) std::copy_n(at[i].begin(), D - 1, places[i].begin());
    return find_surface<D>(detection_, surface_threshold_,
                           {domain_, positions(), volume_, kernel_, h_, solids()}, places);
}

template <int D>
SolidParticles<D> FluidViewIn<D>::solids() const {
    SolidParticles<D> solids;
    for (std::size_t i = 0; walls_ != nullptr && i < walls_->size(); ++i) {
        // Behind end walls and side walls stand mirror images of the water.
        if (!is_solid(*walls_, i) && walls_->position[D - 1][i] >= 0.0) continue;
        for (std::size_t k = 0; k < D; ++k) solids.position[k].push_back(walls_->position[k][i]);
        solids.volume.push_back(walls_->volume[i]);
    }
    return solids;
}

template <int D>
FluidView::Section FluidViewIn<D>::section_at(double x, const WorkingValues* pressure) const {
    Section section{};
    const std::size_t n = particles_.size();
    const double inverse_h = 1.0 / h_;
    visit_kernel<1>(kernel_, [&](auto kernel) {
        cells_.around_section(x, [&](std::size_t j) {
            if (j >= n) return;
            const double q = std::abs(cells_.distance(0, cells_.positions()[0][j], x)) * inverse_h;
            const double weight = inverse_h * decltype(kernel)::value(q);
            const double area = volume_[j] * weight;
            const double of_water = porosity_.empty() ? 1.0 : porosity_[j];
            const double u = particles_.velocity[0][j];
            section.flow_rate += of_water * area * u;
            section.depth += area;
            section.momentum_flux += particles_.mass[j] * weight * u * u;
            double squares = 0.0;
            for (const auto& component : particles_.velocity) squares += component[j] * component[j];
            const double push = pressure != nullptr ? area * (*pressure)[j] : 0.0;
            const double per_mass = 0.5 * squares + gravity_ * particles_.position[D - 1][j];
            section.pressure_force += push;
            section.energy_flux += (particles_.mass[j] * weight * per_mass + of_water * push) * u;
        });
    });
    section.depth /= width_;
    return section;
}

template class FluidViewIn<2>;
template class FluidViewIn<3>;

}  // namespace riffle::inline instruments

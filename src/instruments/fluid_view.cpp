#include "instruments/fluid_view.hpp"

#include <cmath>
#include <limits>

#include "sph/free_surface.hpp"
#include "sph/kernel_registry.hpp"

namespace riffle {

namespace {

std::vector<double> volumes(const Particles<2>& p, double density) {
    std::vector<double> volume(p.size());
    for (std::size_t i = 0; i < p.size(); ++i) {
        volume[i] = p.mass[i] / (density * (1.0 + p.density_deviation[i]));
    }
    return volume;
}

/// Sums over the neighbours of a point, weighted with the kernel: of 1 and of the distances in smoothing
/// lengths, and each times a velocity.
struct Moments {
    double one = 0.0, x = 0.0, z = 0.0, xx = 0.0, xz = 0.0, zz = 0.0;
    double u = 0.0, ux = 0.0, uz = 0.0, w = 0.0, wx = 0.0, wz = 0.0;
};

/// Value at the point of the plane that fits the neighbours best, from their moments. Where they are too few
/// or stand too much in line to say a slope, their mean.
struct PlaneFit {
    double weight_one, weight_x, weight_z;

    explicit PlaneFit(const Moments& m) : weight_one(1.0 / m.one), weight_x(0.0), weight_z(0.0) {
        // First row of the inverse of ((1, x, z), (x, xx, xz), (z, xz, zz)).
        const double cofactor_one = m.xx * m.zz - m.xz * m.xz;
        const double cofactor_x = m.xz * m.z - m.x * m.zz;
        const double cofactor_z = m.x * m.xz - m.xx * m.z;
        const double determinant = m.one * cofactor_one + m.x * cofactor_x + m.z * cofactor_z;
        // Of a full support the second moments are about 0.3; a thousandth of that says nothing.
        constexpr double least = 1e-4;
        if (determinant > least * m.one * m.one * m.one) {
            weight_one = cofactor_one / determinant;
            weight_x = cofactor_x / determinant;
            weight_z = cofactor_z / determinant;
        }
    }
    [[nodiscard]] double value(double sum, double sum_x, double sum_z) const {
        return weight_one * sum + weight_x * sum_x + weight_z * sum_z;
    }
};

}  // namespace

FluidView::FluidView(const Particles<2>& particles, const Domain<2>& domain, KernelKind kernel,
                     double density, double smoothing_length, SurfaceDetection detection)
    : particles_(particles),
      domain_(domain),
      kernel_(kernel),
      h_(smoothing_length),
      detection_(detection),
      volume_(volumes(particles, density)),
      cells_(domain, particles.position[0], particles.position[1], 2.0 * smoothing_length) {}

FluidView::Velocity FluidView::velocity_at(double x, double z) const {
    Moments m;
    const double inverse_h = 1.0 / h_;
    visit_kernel<2>(kernel_, [&](auto kernel) {
        cells_.around(x, z, [&](std::size_t j) {
            const double rx = cells_.distance(cells_.x()[j], x) * inverse_h;
            const double rz = (cells_.z()[j] - z) * inverse_h;
            const double squared = rx * rx + rz * rz;
            if (squared >= 4.0) {
                return;
            }
            const double weight =
                volume_[j] * inverse_h * inverse_h * decltype(kernel)::value(std::sqrt(squared));
            const double u = weight * particles_.velocity[0][j];
            const double w = weight * particles_.velocity[1][j];
            m.one += weight;
            m.x += weight * rx;
            m.z += weight * rz;
            m.xx += weight * rx * rx;
            m.xz += weight * rx * rz;
            m.zz += weight * rz * rz;
            m.u += u;
            m.ux += u * rx;
            m.uz += u * rz;
            m.w += w;
            m.wx += w * rx;
            m.wz += w * rz;
        });
    });
    if (m.one < wet_share) {
        const double dry = std::numeric_limits<double>::quiet_NaN();
        return {dry, dry};
    }
    const PlaneFit fit(m);
    return {fit.value(m.u, m.ux, m.uz), fit.value(m.w, m.wx, m.wz)};
}

std::vector<double> FluidView::surface_at(std::span<const double> x) const {
    std::vector<Vec<1>> at;
    for (const double place : x) {
        at.push_back({place});
    }
    return find_surface<2>(
        detection_, {domain_, {particles_.position[0], particles_.position[1]}, volume_, kernel_, h_}, at);
}

FluidView::Section FluidView::section_at(double x) const {
    Section section{0.0, 0.0};
    const double inverse_h = 1.0 / h_;
    visit_kernel<1>(kernel_, [&](auto kernel) {
        cells_.around(x, [&](std::size_t j) {
            const double q = std::abs(cells_.distance(cells_.x()[j], x)) * inverse_h;
            const double area = volume_[j] * inverse_h * decltype(kernel)::value(q);
            section.flow_rate += area * particles_.velocity[0][j];
            section.depth += area;
        });
    });
    return section;
}

}  // namespace riffle

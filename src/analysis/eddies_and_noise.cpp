#include "analysis/eddies_and_noise.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "particles/particle_cells.hpp"

namespace riffle::inline analysis {

namespace {

/// Neighbours from which a linear field is taken; it has four coefficients.
constexpr int fewest_neighbours = 8;

}  // namespace

NoiseSplit::NoiseSplit(const Domain<3>& domain, double spacing, double height)
    : domain_(domain),
      spacing_(spacing),
      layers_(static_cast<std::size_t>(std::max(1.0, std::ceil(height / spacing)))) {}

void NoiseSplit::add(const ParticleVelocities& particles) {
    const double reach = noise_reach * spacing_;
    const auto& x = particles.position;
    const ParticleCells<3> cells(domain_, {x[0], x[1], x[2]}, reach);
    const std::size_t n = x[0].size();
    for (std::size_t i = 0; i < n; ++i) {
        const double layer_number = std::floor(x[2][i] / spacing_);
        if (layer_number < 0.0 || layer_number >= static_cast<double>(layers_.size())) {
            continue;  // spray above the layers has no neighbours to fit
        }
        Eigen::Matrix4d moments = Eigen::Matrix4d::Zero();
        Eigen::Matrix<double, 4, 3> sums = Eigen::Matrix<double, 4, 3>::Zero();
        int neighbours = 0;
        cells.around({x[0][i], x[1][i], x[2][i]}, [&](std::size_t j) {
            Eigen::Vector4d basis(1.0, 0.0, 0.0, 0.0);
            double squared = 0.0;
            for (std::size_t k = 0; k < 3; ++k) {
                const double d = cells.distance(k, x[k][j], x[k][i]) / reach;
                basis[static_cast<int>(k) + 1] = d;
                squared += d * d;
            }
            if (j == i || squared >= 1.0) return;
            const double q = std::sqrt(squared);
            const double weight = (1.0 - q) * (1.0 - q) * (1.0 - q) * (1.0 - q) * (1.0 + 4.0 * q);
            moments += weight * basis * basis.transpose();
            for (std::size_t k = 0; k < 3; ++k) {
                sums.col(static_cast<int>(k)) += weight * particles.velocity[k][j] * basis;
            }
            ++neighbours;
        });
        if (neighbours < fewest_neighbours) continue;
        const Eigen::LDLT<Eigen::Matrix4d> solver(moments);
        if (solver.rcond() < 1e-6) {
            continue;  // neighbours in one plane
        }
        const Eigen::RowVector3d fitted = solver.solve(sums).row(0);
        Layer& layer = layers_[static_cast<std::size_t>(layer_number)];
        layer.count += 1.0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double u = particles.velocity[k][i];
            const double eddy = fitted[static_cast<int>(k)];
            layer.particle[k] += u;
            layer.eddy[k] += eddy;
            layer.eddy_squared[k] += eddy * eddy;
            layer.noise_squared[k] += (u - eddy) * (u - eddy);
        }
        layer.particle_product += particles.velocity[0][i] * particles.velocity[2][i];
        layer.eddy_product += fitted[0] * fitted[2];
    }
    ++moments_;
}

EddiesAndNoise NoiseSplit::result(double fewest) const {
    EddiesAndNoise split;
    split.snapshots = moments_;
    for (std::size_t l = 0; l < layers_.size(); ++l) {
        const Layer& layer = layers_[l];
        if (moments_ == 0 || layer.count < fewest * static_cast<double>(moments_)) continue;
        const auto mean = [&](double sum) { return sum / layer.count; };
        split.z.push_back((static_cast<double>(l) + 0.5) * spacing_);
        split.velocity.push_back(mean(layer.particle[0]));
        for (std::size_t k = 0; k < 3; ++k) {
            const double of_eddies = mean(layer.eddy[k]);
            split.eddies[k].push_back(
                std::sqrt(std::max(0.0, mean(layer.eddy_squared[k]) - of_eddies * of_eddies)));
            split.noise[k].push_back(std::sqrt(mean(layer.noise_squared[k])));
        }
        split.stress.push_back(mean(layer.particle[0]) * mean(layer.particle[2]) -
                               mean(layer.particle_product));
        split.stress_of_eddies.push_back(mean(layer.eddy[0]) * mean(layer.eddy[2]) -
                                         mean(layer.eddy_product));
    }
    return split;
}

double noise_viscosity(const EddiesAndNoise& split, double from, double to) {
    double stress = 0.0;
    std::vector<std::size_t> layers;
    for (std::size_t i = 0; i < split.z.size(); ++i) {
        if (split.z[i] > from && split.z[i] < to) {
            layers.push_back(i);
            stress += split.stress[i] - split.stress_of_eddies[i];
        }
    }
    if (layers.size() < 2) return 0.0;
    const double gradient = (split.velocity[layers.back()] - split.velocity[layers.front()]) /
                            (split.z[layers.back()] - split.z[layers.front()]);
    return gradient > 0.0 ? stress / static_cast<double>(layers.size()) / gradient : 0.0;
}

}  // namespace riffle::inline analysis

#include "analysis/eddies_and_noise.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "case/flow_kind.hpp"
#include "case/solid_shapes.hpp"
#include "particles/lattice.hpp"
#include "particles/particle_cells.hpp"
#include "record/particle_fields.hpp"

namespace riffle {

namespace {

/// Neighbours from which a linear field is taken; it has four coefficients.
constexpr int fewest_neighbours = 8;

std::array<std::vector<double>, 3> components(const std::vector<double>& rows) {
    std::array<std::vector<double>, 3> result;
    for (std::size_t k = 0; k < 3; ++k) {
        result[k].resize(rows.size() / 3);
        for (std::size_t i = 0; i < result[k].size(); ++i) {
            result[k][i] = rows[3 * i + k];
        }
    }
    return result;
}

/// Whether a snapshot holds all of the water, so that each particle has its neighbours.
bool snapshots_are_whole(const Case& c) {
    const Output& output = c.output;
    return output.snapshot_x.empty() && output.snapshot_y.empty() && output.snapshot_z.empty();
}

/// Whether the flow is the same all along a channel, on the mean over its plan: nothing stands in it but a
/// bed of bodies.
bool is_uniform_over_plan(const Case& c) {
    return c.channel.ends == Ends::periodic && is_channel(flow_kind(c)) &&
           std::all_of(c.solids.begin(), c.solids.end(),
                       [](const Solid& solid) { return is_bed_shape(solid.shape); });
}

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
            if (j == i || squared >= 1.0) {
                return;
            }
            const double q = std::sqrt(squared);
            const double weight = (1.0 - q) * (1.0 - q) * (1.0 - q) * (1.0 - q) * (1.0 + 4.0 * q);
            moments += weight * basis * basis.transpose();
            for (std::size_t k = 0; k < 3; ++k) {
                sums.col(static_cast<int>(k)) += weight * particles.velocity[k][j] * basis;
            }
            ++neighbours;
        });
        if (neighbours < fewest_neighbours) {
            continue;
        }
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
        if (moments_ == 0 || layer.count < fewest * static_cast<double>(moments_)) {
            continue;
        }
        const auto mean = [&](double sum) { return sum / layer.count; };
        split.z.push_back((static_cast<double>(l) + 0.5) * spacing_);
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

EddiesAndNoise read_eddies_and_noise(const RunResults& results, const Case& c, double from, double to,
                                     std::size_t most_particles) {
    if (c.channel.dimensions != 3 || !is_uniform_over_plan(c) || has_mixing_length(c) ||
        !snapshots_are_whole(c)) {
        return {};
    }
    const auto& of = fields::snapshot;
    std::vector<std::string> groups;
    for (const std::string& name : results.children(snapshots_group)) {
        std::string group = std::string(snapshots_group) + "/" + name;
        const double time = results.number({group, of.time}).value_or(from - 1.0);
        if (time >= from && time <= to && results.has({group, of.position}) &&
            results.has({group, of.velocity})) {
            groups.push_back(std::move(group));
        }
    }
    if (groups.empty()) {
        return {};
    }
    const std::size_t in_one = std::max<std::size_t>(results.shape({groups[0], of.position})[0], 1);
    const std::size_t most = std::clamp<std::size_t>(most_particles / in_one, 1, groups.size());
    NoiseSplit split(domain_of<3>(c), c.numerics.spacing, 1.5 * c.total_depth());
    for (std::size_t i = 0; i < most; ++i) {
        const std::string& group = groups[i * groups.size() / most];
        const std::vector<double> position = results.values({group, of.position});
        const std::vector<double> velocity = results.values({group, of.velocity});
        if (position.size() != velocity.size()) {
            throw FileError(group + " of " + results.path().string() +
                            ": positions and velocities do not fit each other; the file is damaged");
        }
        split.add({components(position), components(velocity)});
    }
    return split.result();
}

}  // namespace riffle

#include "centre_lines.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "sph/kernel.hpp"

namespace riffle::verification {

namespace {

/// Sums for a least-squares fit of a linear field round a point.
class LinearFit {
  public:
    LinearFit(double x, double z, double h) : x_(x), z_(z), h_(h) {}

    void add(double x, double z, double value) {
        const double dx = (x - x_) / h_;
        const double dz = (z - z_) / h_;
        const double w = WendlandC2<2>::value(std::hypot(dx, dz));
        const Eigen::Vector3d basis(1.0, dx, dz);
        matrix_ += w * basis * basis.transpose();
        right_ += w * value * basis;
    }
    [[nodiscard]] double value() const { return matrix_.ldlt().solve(right_)[0]; }

  private:
    double x_, z_, h_;
    Eigen::Matrix3d matrix_ = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right_ = Eigen::Vector3d::Zero();
};

}  // namespace

CentreLines ghia_reynolds_100() {
    return {{0.0547, 0.0625, 0.0703, 0.1016, 0.1719, 0.2813, 0.4531, 0.5000, 0.6172, 0.7344, 0.8516, 0.9531,
             0.9609, 0.9688, 0.9766},
            {-0.03717, -0.04192, -0.04775, -0.06434, -0.10150, -0.15662, -0.21090, -0.20581, -0.13641,
             0.00332, 0.23151, 0.68717, 0.73722, 0.78871, 0.84123},
            {0.0625, 0.0703, 0.0781, 0.0938, 0.1563, 0.2266, 0.2344, 0.5000, 0.8047, 0.8594, 0.9063, 0.9453,
             0.9531, 0.9609, 0.9688},
            {0.09233, 0.10091, 0.10890, 0.12317, 0.16077, 0.17507, 0.17527, 0.05454, -0.24533, -0.22445,
             -0.16914, -0.10313, -0.08864, -0.07391, -0.05906}};
}

CentreLines ghia_reynolds_1000() {
    return {{0.0547, 0.0625, 0.0703, 0.1016, 0.1719, 0.2813, 0.4531, 0.5000, 0.6172, 0.7344, 0.8516, 0.9531,
             0.9609, 0.9688, 0.9766},
            {-0.18109, -0.20196, -0.22220, -0.29730, -0.38289, -0.27805, -0.10648, -0.06080, 0.05702, 0.18719,
             0.33304, 0.46604, 0.51117, 0.57492, 0.65928},
            {0.0625, 0.0703, 0.0781, 0.0938, 0.1563, 0.2266, 0.2344, 0.5000, 0.8047, 0.8594, 0.9063, 0.9453,
             0.9531, 0.9609, 0.9688},
            {0.27485, 0.29012, 0.30353, 0.32627, 0.37095, 0.33075, 0.32235, 0.02526, -0.31966, -0.42665,
             -0.51550, -0.39188, -0.33714, -0.27669, -0.21388}};
}

double cavity_error(CheckRun& run, const CentreLines& lines, double time, double span) {
    const Case& c = run.parameters();
    const double edge = c.channel.length;
    const double lid = c.channel.lid_velocity;
    const double h = run.simulation().scheme().smoothing_length;
    std::vector<double> u(lines.z.size());
    std::vector<double> w(lines.x.size());
    constexpr int samples = 20;
    for (int sample = 1; sample <= samples; ++sample) {
        run.advance_to(time - span + span * sample / samples);
        const auto& p = run.particles();
        const auto average = [&](double x, double z, std::size_t component) {
            LinearFit fit(x, z, h);
            for (std::size_t i = 0; i < p.size(); ++i) {
                if (std::abs(p.position[0][i] - x) < 2 * h && std::abs(p.position[1][i] - z) < 2 * h) {
                    fit.add(p.position[0][i], p.position[1][i], p.velocity[component][i]);
                }
            }
            return fit.value() / lid / samples;
        };
        for (std::size_t k = 0; k < u.size(); ++k) u[k] += average(0.5 * edge, lines.z[k] * edge, 0);
        for (std::size_t k = 0; k < w.size(); ++k) w[k] += average(lines.x[k] * edge, 0.5 * edge, 1);
    }
    double largest = 0.0;
    for (std::size_t k = 0; k < u.size(); ++k) largest = std::max(largest, std::abs(u[k] - lines.u[k]));
    for (std::size_t k = 0; k < w.size(); ++k) largest = std::max(largest, std::abs(w[k] - lines.w[k]));
    return largest;
}

}  // namespace riffle::verification

#include "hydraulics/secondary_flow_laws.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/error.hpp"
#include "statistics/separable_fit.hpp"

namespace riffle::inline hydraulics {

namespace {

using std::numbers::pi;

/// What the phase adds to the linear stress.
double stress_departure(double xi) { return secondary_flow_bed_amplitude * (1.0 - xi) * (1.0 - 7.0 * xi); }

Eigen::VectorXd vector_of(const std::vector<double>& values) {
    return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

}  // namespace

double secondary_flow_phase(double y, double cell_width) { return std::cos(pi * y / cell_width); }

double secondary_flow_log_law(double z, double depth, double friction_velocity, double zero_velocity_height,
                              double phase, double kappa, const SecondaryFlowConstants& constants) {
    const double logarithm = std::log(z / zero_velocity_height);
    const double sine = std::sin(0.5 * pi * z / depth);
    const double cell = constants.logarithm * logarithm + constants.offset + constants.wake * sine * sine;
    return friction_velocity / kappa * (logarithm + phase * cell);
}

double secondary_flow_stress(double z, double depth, double phase) {
    const double xi = z / depth;
    return 1.0 - xi + phase * stress_departure(xi);
}

double secondary_flow_bed_stress(double phase) { return 1.0 + secondary_flow_bed_amplitude * phase; }

SecondaryStressFit fit_secondary_flow_stress(std::span<const double> z,
                                             std::span<const double> relative_stress, double depth,
                                             FitRange range) {
    if (!(depth > 0.0)) throw InputError("fit of the stress: the depth must be greater than 0");
    const FitPoints used({z, relative_stress}, range);
    SecondaryStressFit fit;
    constexpr Eigen::Index fewest = 3;
    if (const auto why = used.obstacle(fewest, depth); !why.empty()) {
        static_cast<FitQuality&>(fit) = failed(used.quality(), why);
        return fit;
    }
    const Eigen::ArrayXd xi = used.height.array() / depth;
    const Eigen::MatrixXd basis = xi.unaryExpr([](double x) { return stress_departure(x); });
    const auto line = fit_linear(basis, used.velocity.array() - (1.0 - xi));
    if (!line) {
        static_cast<FitQuality&>(fit) = failed(used.quality(), "the heights do not determine the phase");
        return fit;
    }
    static_cast<FitQuality&>(fit) = succeeded(used.quality(), line->residuals);
    fit.phase = coefficient(*line, 0);
    return fit;
}

double BedStressFit::at(double y) const {
    return mean.value * (1.0 + amplitude * secondary_flow_phase(y - downflow, cell_width.value));
}

BedStressFit fit_bed_stress(std::span<const double> y, std::span<const double> stress) {
    if (y.size() != stress.size()) {
        throw InputError("fit of the bed stress: places and stresses differ in number");
    }
    std::vector<double> place;
    std::vector<double> value;
    for (std::size_t i = 0; i < y.size(); ++i) {
        if (!std::isfinite(stress[i])) continue;
        place.push_back(y[i]);
        value.push_back(stress[i]);
    }
    BedStressFit fit;
    fit.points = place.size();
    constexpr std::size_t fewest = 6;
    if (place.size() < fewest) {
        static_cast<FitQuality&>(fit) = failed(fit, "fewer than six places across the channel");
        return fit;
    }
    const auto [first, last] = std::minmax_element(place.begin(), place.end());
    fit.from = *first;
    fit.to = *last;
    const double extent = *last - *first;
    const Eigen::ArrayXd at = vector_of(place).array() - *first;
    const auto basis = [&at](double wavenumber) {
        Eigen::MatrixXd columns(at.size(), 3);
        columns.col(0).setOnes();
        columns.col(1) = (wavenumber * at).cos();
        columns.col(2) = (wavenumber * at).sin();
        return columns;
    };
    constexpr double narrowest = 20.0;  // cells over the extent
    constexpr int steps = 400;
    const SeparableFit search(basis, vector_of(value), {}, pi / extent, narrowest * pi / extent, steps);
    if (!search.determined()) {
        static_cast<FitQuality&>(fit) =
            failed(fit, "no width of cells between a twentieth and the whole of the channel fits best");
        return fit;
    }
    static_cast<FitQuality&>(fit) = succeeded(fit, search.linear().residuals);
    fit.mean = search.coefficient(0);
    fit.cell_width = linear_of(inverse_of(search.parameter()), pi);
    const double cosine = search.linear().coefficients(1);
    const double sine = search.linear().coefficients(2);
    fit.amplitude = std::hypot(cosine, sine) / fit.mean.value;
    // cos(k (y - y0)) with the first maximum at or behind the first place.
    const double turn = std::atan2(sine, cosine);
    fit.downflow = *first + (turn < 0.0 ? turn + 2.0 * pi : turn) / pi * fit.cell_width.value;
    return fit;
}

}  // namespace riffle::inline hydraulics

#include "analysis/surface_families.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>

#include "analysis/surface_spectra.hpp"
#include "base/error.hpp"
#include "statistics/fourier.hpp"

namespace riffle::inline analysis {

namespace {

using std::numbers::pi;

/// A window along or across the plan: none where it repeats itself.
std::vector<double> plan_window(std::size_t n, bool periodic) {
    return periodic ? std::vector<double>(n, 1.0) : hann_window(n);
}

/// The families of a surface, by wavenumber and frequency.
class Families {
  public:
    Families(const GravityCapillaryWaves& waves, double slowest, double fastest, double sampling, double step)
        : waves_(waves), slowest_(slowest), fastest_(fastest), sampling_(sampling), step_(step) {}

    /// Of a component with k_x >= 0.
    [[nodiscard]] SurfaceFamily at(double kx, double ky, double omega) const {
        const double still = 2.0 * step_;
        const double moving = std::max(still, 0.1 * kx * std::abs(waves_.velocity));
        const double carried = kx * waves_.velocity;
        const double own = waves_.intrinsic_frequency(std::hypot(kx, ky));
        SurfaceFamily family = SurfaceFamily::other;
        double least = 1.0;
        const auto compare = [&](SurfaceFamily candidate, double distance, double tolerance) {
            if (distance / tolerance < least) {
                least = distance / tolerance;
                family = candidate;
            }
        };
        compare(SurfaceFamily::bed_locked, folded(omega), still);
        if (kx > 0.0) {
            const double middle = 0.5 * kx * (slowest_ + fastest_);
            const double half = 0.5 * kx * std::abs(fastest_ - slowest_);
            compare(SurfaceFamily::advected, std::max(0.0, folded(omega - middle) - half), moving);
        }
        const bool across = kx == 0.0;
        compare(across ? SurfaceFamily::waves_across : SurfaceFamily::waves_downstream,
                folded(omega - carried - own), moving);
        compare(across ? SurfaceFamily::waves_across : SurfaceFamily::waves_upstream,
                folded(omega - carried + own), moving);
        return family;
    }

  private:
    /// Size of a difference of frequencies that sampling cannot tell from those a whole multiple apart.
    [[nodiscard]] double folded(double difference) const {
        return std::abs(std::remainder(difference, sampling_));
    }

    GravityCapillaryWaves waves_;
    double slowest_, fastest_;
    double sampling_;  ///< 2 pi over the interval
    double step_;
};

/// Signed wavenumber of each component of a transform.
std::vector<double> wavenumbers(std::size_t n, double spacing) {
    std::vector<double> k = two_sided_frequencies(n, spacing);
    for (double& value : k) value *= 2.0 * pi;
    return k;
}

void require_sound(const SurfacePlan& plan, std::size_t segment_times) {
    constexpr std::size_t fewest = 8;
    if (segment_times < fewest || plan.times() < segment_times || !(plan.interval > 0.0)) {
        throw InputError(
            fmt::format("families of the surface: segments of {} times in a record of {}; at least {} "
                        "are needed",
                        segment_times, plan.times(), fewest));
    }
    if (!std::all_of(plan.elevation.begin(), plan.elevation.end(),
                     [](double z) { return std::isfinite(z); })) {
        throw InputError("families of the surface: a point of the maps has no water at some time");
    }
}

}  // namespace

double SurfaceMakeup::whole() const { return std::accumulate(variance.begin(), variance.end(), 0.0); }

double SurfaceMakeup::share(SurfaceFamily family) const {
    return variance[static_cast<std::size_t>(family)] / whole();
}

double SurfaceMakeup::share_of_noise(SurfaceFamily family) const {
    return variance_of_noise[static_cast<std::size_t>(family)] / whole();
}

SurfaceMakeup surface_makeup(const SurfacePlan& plan, const GravityCapillaryWaves& waves, double slowest,
                             double fastest, std::size_t segment_times) {
    require_sound(plan, segment_times);
    const std::size_t points = plan.rows * plan.columns;
    const std::vector<double> in_time = hann_window(segment_times);
    const std::vector<double> along = plan_window(plan.columns, plan.periodic_x);
    const std::vector<double> across = plan_window(plan.rows, plan.periodic_y);
    const std::vector<double> kx = wavenumbers(plan.columns, plan.spacing_x);
    const std::vector<double> ky = wavenumbers(plan.rows, plan.spacing_y);
    const std::vector<double> frequency = wavenumbers(segment_times, plan.interval);

    SurfaceMakeup result;
    const double step = 2.0 * pi / (plan.interval * static_cast<double>(segment_times));
    result.frequency_step = step;
    const double band = 2.0 * pi /
                        std::max(plan.spacing_x * static_cast<double>(plan.columns),
                                 plan.spacing_y * static_cast<double>(plan.rows));
    const double largest = pi / std::max(plan.spacing_x, plan.spacing_y);
    const auto bands = static_cast<std::size_t>(std::max(1.0, std::floor(largest / band)));
    for (std::size_t i = 0; i < bands; ++i) {
        result.wavenumber.push_back((static_cast<double>(i) + 1.0) * band);
    }
    for (auto& of_family : result.density) of_family.assign(bands, 0.0);

    const Families families(waves, slowest, fastest, 2.0 * pi / plan.interval, step);
    // Of each component, and of each wavenumber how many of its frequencies.
    std::vector<std::uint8_t> family_of(segment_times * points);
    std::vector<std::array<double, surface_families>> share_of(points);
    std::vector<double> power_of(points);
    for (std::size_t at = 0; at < family_of.size(); ++at) {
        const double of_x = kx[at % plan.columns];
        // exp(i (k x + w t)) is a wave of frequency -w; of k_x < 0 it is the one of -k and w.
        const double sign = of_x < 0.0 ? -1.0 : 1.0;
        const double of_y = ky[at / plan.columns % plan.rows];
        const SurfaceFamily family = families.at(sign * of_x, sign * of_y, -sign * frequency[at / points]);
        family_of[at] = static_cast<std::uint8_t>(family);
        share_of[at % points][family_of[at]] += 1.0 / static_cast<double>(segment_times);
    }
    std::vector<Complex> box(segment_times * points);
    const std::size_t hop = std::max<std::size_t>(1, segment_times / 2);
    for (std::size_t first = 0; first + segment_times <= plan.times(); first += hop) {
        ++result.segments;
        for (std::size_t t = 0; t < segment_times; ++t) {
            for (std::size_t j = 0; j < plan.rows; ++j) {
                for (std::size_t i = 0; i < plan.columns; ++i) {
                    const std::size_t at = (t * plan.rows + j) * plan.columns + i;
                    box[at] = plan.elevation[first * points + at] * in_time[t] * across[j] * along[i];
                }
            }
        }
        fourier_transform_3d(box, segment_times, plan.rows, plan.columns);
        for (std::size_t at = 0; at < box.size(); ++at) {
            const std::size_t i = at % plan.columns;
            const std::size_t j = at / plan.columns % plan.rows;
            if (i == 0 && j == 0) continue;  // the mean over the plan
            const std::size_t family = family_of[at];
            const double power = std::norm(box[at]);
            result.variance[family] += power;
            power_of[at % points] += power;
            const auto of_band = static_cast<std::size_t>(std::lround(std::hypot(kx[i], ky[j]) / band));
            if (of_band >= 1 && of_band <= bands) result.density[family][of_band - 1] += power / band;
        }
    }
    for (std::size_t point = 0; point < points; ++point) {
        for (std::size_t family = 0; family < surface_families; ++family) {
            result.variance_of_noise[family] += power_of[point] * share_of[point][family];
        }
    }
    // Parseval: the sum of |X|^2 is the number of values times the sum of the squares.
    const double scale = 1.0 / (static_cast<double>(box.size()) * static_cast<double>(box.size()) *
                                static_cast<double>(result.segments));
    for (double& value : result.variance) value *= scale;
    for (double& value : result.variance_of_noise) value *= scale;
    for (auto& of_family : result.density) {
        for (double& value : of_family) value *= scale;
    }
    return result;
}

}  // namespace riffle::inline analysis

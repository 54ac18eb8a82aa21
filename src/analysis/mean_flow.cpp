#include "analysis/mean_flow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/not_a_number.hpp"
#include "record/flow_fields.hpp"
#include "statistics/jackknife.hpp"

namespace riffle::inline analysis {

namespace {

constexpr std::size_t index(FieldQuantity q) { return static_cast<std::size_t>(q); }

/// The fields of the quantities, in the order of these.
const auto& all_fields() {
    static const std::array<Field, field_quantities> all = fields_of(fields::mean_field);
    return all;
}

/// The two velocities of a second moment; others give themselves back twice.
struct Factors {
    FieldQuantity first, second;
};
constexpr Factors factors_of(FieldQuantity moment) {
    switch (moment) {
        case FieldQuantity::velocity_variance:
            return {FieldQuantity::velocity, FieldQuantity::velocity};
        case FieldQuantity::spanwise_velocity_variance:
            return {FieldQuantity::spanwise_velocity, FieldQuantity::spanwise_velocity};
        case FieldQuantity::vertical_velocity_variance:
            return {FieldQuantity::vertical_velocity, FieldQuantity::vertical_velocity};
        case FieldQuantity::velocity_covariance:
            return {FieldQuantity::velocity, FieldQuantity::vertical_velocity};
        case FieldQuantity::velocity_spanwise_covariance:
            return {FieldQuantity::velocity, FieldQuantity::spanwise_velocity};
        case FieldQuantity::spanwise_vertical_covariance:
            return {FieldQuantity::spanwise_velocity, FieldQuantity::vertical_velocity};
        default:
            return {moment, moment};
    }
}
const std::array<Averaging, field_quantities> averagings = [] {
    std::array<Averaging, field_quantities> of{};
    std::transform(all_fields().begin(), all_fields().end(), of.begin(),
                   [](const Field& field) { return field.averaging; });
    return of;
}();
bool is_moment(std::size_t q) { return averagings[q] == Averaging::moments; }
/// Forces and the count are per cell and sample, the others per particle and sample.
bool is_per_cell(std::size_t q) { return averagings[q] == Averaging::by_samples; }

FieldSums sum_of(const std::vector<FieldSums>& parts) {
    FieldSums total = parts.front();
    for (std::size_t i = 1; i < parts.size(); ++i) total.add(parts[i]);
    return total;
}

}  // namespace

const Field& field_of(FieldQuantity quantity) { return all_fields()[index(quantity)]; }

void FieldSums::add_window(std::size_t cell, const FieldValues& values, double samples) {
    double* const sums = &sums_[cell * width];
    sums[field_quantities] += samples;
    const double particles = samples * values[index(FieldQuantity::count)];
    for (std::size_t q = 0; q < field_quantities; ++q) {
        if (is_per_cell(q)) {
            if (std::isfinite(values[q])) sums[q] += samples * values[q];
            continue;
        }
        if (!(particles > 0.0)) continue;
        double value = values[q];
        if (is_moment(q)) {
            const Factors factors = factors_of(static_cast<FieldQuantity>(q));
            value += values[index(factors.first)] * values[index(factors.second)];
        }
        sums[q] += particles * value;
    }
}

void FieldSums::add(std::size_t cell, const FieldSums& other, std::size_t other_cell) {
    for (std::size_t q = 0; q < width; ++q) sums_[cell * width + q] += other.sums_[other_cell * width + q];
}

void FieldSums::add(const FieldSums& other, double sign) {
    for (std::size_t i = 0; i < sums_.size(); ++i) sums_[i] += sign * other.sums_[i];
}

double FieldSums::mean(FieldQuantity quantity, std::size_t cell) const {
    const double* const sums = &sums_[cell * width];
    const std::size_t q = index(quantity);
    const double samples = sums[field_quantities];
    if (is_per_cell(q)) return samples > 0.0 ? sums[q] / samples : not_a_number;
    const double particles = sums[index(FieldQuantity::count)];
    // What is left of a sum that has been taken away again is rounding.
    if (!(particles > 1e-9 * samples)) return not_a_number;
    if (!is_moment(q)) return sums[q] / particles;
    const Factors factors = factors_of(quantity);
    return sums[q] / particles -
           sums[index(factors.first)] / particles * (sums[index(factors.second)] / particles);
}

std::vector<double> FieldSums::means(FieldQuantity quantity) const {
    std::vector<double> values(cells());
    for (std::size_t cell = 0; cell < values.size(); ++cell) values[cell] = mean(quantity, cell);
    return values;
}

FieldSums MeanFlow::section() const { return sum_of(sections); }

FieldSums MeanFlow::plan() const {
    FieldSums sums(y.size() * x.size());
    for (std::size_t iz = 0; iz < z.size(); ++iz) {
        for (std::size_t cell = 0; cell < sums.cells(); ++cell) sums.add(cell, box, iz * sums.cells() + cell);
    }
    return sums;
}

FieldSums MeanFlow::side() const {
    FieldSums sums(z.size() * x.size());
    for (std::size_t iz = 0; iz < z.size(); ++iz) {
        for (std::size_t iy = 0; iy < y.size(); ++iy) {
            for (std::size_t ix = 0; ix < x.size(); ++ix) sums.add(iz * x.size() + ix, box, at(iz, iy, ix));
        }
    }
    return sums;
}

FieldEstimates section_estimates(const MeanFlow& field, const SectionEstimator& estimator) {
    const FieldSums total = sum_of(field.block_sections);
    FieldEstimates result{estimator(total), {}};
    const std::size_t blocks = field.block_sections.size();
    result.half_width.assign(result.value.size(), std::numeric_limits<double>::infinity());
    if (blocks < 2) return result;
    std::vector<std::vector<double>> without_one;
    for (const FieldSums& block : field.block_sections) {
        FieldSums others = total;
        others.add(block, -1.0);
        without_one.push_back(estimator(others));
    }
    std::vector<double> values(blocks);
    for (std::size_t i = 0; i < result.value.size(); ++i) {
        for (std::size_t b = 0; b < blocks; ++b) values[b] = without_one[b][i];
        result.half_width[i] = jackknife_half_width(values);
    }
    return result;
}

Estimate section_estimate(const MeanFlow& field,
                          const std::function<double(const FieldSums& section)>& estimator) {
    const FieldEstimates found = section_estimates(
        field, [&](const FieldSums& section) { return std::vector<double>{estimator(section)}; });
    return {found.value.front(), found.half_width.front()};
}

std::vector<std::size_t> columns_of_strip(const MeanFlow& field, double from, double to) {
    const double tolerance = 1e-6 * field.cell_width();
    std::vector<std::size_t> places;
    std::size_t nearest = 0;
    const double middle = 0.5 * (from + to);
    for (std::size_t iy = 0; iy < field.y.size(); ++iy) {
        if (field.y[iy] >= from - tolerance && field.y[iy] <= to + tolerance) places.push_back(iy);
        if (std::abs(field.y[iy] - middle) < std::abs(field.y[nearest] - middle)) nearest = iy;
    }
    if (places.empty()) places.push_back(nearest);
    return places;
}

FieldSums strip_of(const MeanFlow& field, const FieldSums& section, double from, double to) {
    const std::vector<std::size_t> places = columns_of_strip(field, from, to);
    FieldSums strip(field.z.size());
    for (std::size_t iz = 0; iz < field.z.size(); ++iz) {
        for (const std::size_t iy : places) strip.add(iz, section, field.at(iz, iy));
    }
    return strip;
}

std::vector<double> period_means(const std::vector<double>& y, const std::vector<double>& values,
                                 double period) {
    std::vector<double> result(y.size(), not_a_number);
    for (std::size_t i = 0; i < y.size(); ++i) {
        double sum = 0.0;
        double count = 0.0;
        for (std::size_t j = 0; j < y.size(); ++j) {
            if (std::abs(y[j] - y[i]) > 0.5 * period || !std::isfinite(values[j])) continue;
            sum += values[j];
            count += 1.0;
        }
        if (count > 0.0) result[i] = sum / count;
    }
    return result;
}

}  // namespace riffle::inline analysis

#include "ends/velocity_shape.hpp"

#include <algorithm>
#include <utility>

#include "base/interpolation.hpp"

namespace riffle::inline ends {

VelocityShape::VelocityShape(std::vector<double> height, std::vector<double> velocity, double depth)
    : place_(std::move(height)), value_(std::move(velocity)) {
    for (double& z : place_) z /= depth;
    constexpr int fine = 4000;
    const double mean = mean_of_rows(fine);
    for (double& value : value_) value /= mean;
}

double VelocityShape::at(double place) const { return place_in(place_, place).in(value_); }

double VelocityShape::largest() const { return *std::max_element(value_.begin(), value_.end()); }

double VelocityShape::mean_of_rows(int rows) const {
    double sum = 0.0;
    for (int row = 0; row < rows; ++row) sum += at((row + 0.5) / rows);
    return sum / rows;
}

}  // namespace riffle::inline ends

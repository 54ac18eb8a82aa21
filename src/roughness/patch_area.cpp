#include "roughness/patch_area.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace riffle::inline roughness {

double PatchStretch::share(double place, double width) const {
    if (all) return 1.0;
    const auto overlap = [&](double shift) {
        return std::max(
            0.0, std::min(place + 0.5 * width, to + shift) - std::max(place - 0.5 * width, from + shift));
    };
    double length = overlap(0.0);
    if (period > 0.0) length += overlap(-period) + overlap(period);
    return length / width;
}

OutlinedArea::OutlinedArea(Outline outline, double width, const std::array<double, 2>& periods)
    : outline_(std::move(outline)), width_(width), periods_(periods) {
    for (std::size_t k = 0; k < 2; ++k) {
        const std::vector<double>& places = k == 0 ? outline_.x : outline_.z;
        const auto [least, most] = std::minmax_element(places.begin(), places.end());
        // The square around a place reaches half a width beyond the outline.
        cells_[k] = static_cast<int>(std::ceil((*most - *least) / width_)) + 2;
        range_[k] = {*least - width_, *least - width_ + cells_[k] * width_};
    }
    for (int j = 0; j < cells_[1]; ++j) {
        for (int i = 0; i < cells_[0]; ++i) {
            const double x = range_[0].from + i * width_;
            const double y = range_[1].from + j * width_;
            const double within =
                area_in_rectangle(outline_, {x, x + width_}, {y, y + width_}) / (width_ * width_);
            constexpr double rounding = 1e-9;
            kind_.push_back(within < rounding         ? Cell::outside
                            : within > 1.0 - rounding ? Cell::within
                                                      : Cell::cut);
        }
    }
}

double OutlinedArea::own_share(double x, double y) const {
    const auto cell_of = [&](double place, std::size_t k) {
        return static_cast<int>(std::floor((place - range_[k].from) / width_));
    };
    const double half = 0.5 * width_;
    const std::array<int, 2> first{cell_of(x - half, 0), cell_of(y - half, 1)};
    // The square around the place lies over four cells at most.
    const auto kind = [&](int i, int j) {
        if (i < 0 || i >= cells_[0] || j < 0 || j >= cells_[1]) return Cell::outside;
        return kind_[static_cast<std::size_t>(j) * static_cast<std::size_t>(cells_[0]) +
                     static_cast<std::size_t>(i)];
    };
    const Cell corner = kind(first[0], first[1]);
    if (corner != Cell::cut && corner == kind(first[0] + 1, first[1]) &&
        corner == kind(first[0], first[1] + 1) && corner == kind(first[0] + 1, first[1] + 1)) {
        return corner == Cell::within ? 1.0 : 0.0;
    }
    return area_in_rectangle(outline_, {x - half, x + half}, {y - half, y + half}) / (width_ * width_);
}

double OutlinedArea::share(double x, double y) const {
    double sum = 0.0;
    for (const double along : {0.0, -periods_[0], periods_[0]}) {
        for (const double across : {0.0, -periods_[1], periods_[1]}) {
            sum += own_share(x + along, y + across);
            if (periods_[1] == 0.0) break;
        }
        if (periods_[0] == 0.0) break;
    }
    return sum;
}

}  // namespace riffle::inline roughness

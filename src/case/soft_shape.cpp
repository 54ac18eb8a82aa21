#include "case/soft_shape.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace riffle::inline case_file {

double SoftRange::share(double place, double edge) const {
    const auto passed = [&](double end, bool hard) {
        if (hard || std::isinf(end)) return place >= end ? 1.0 : 0.0;
        return share_within(place - end, edge);
    };
    const auto once = [&](double shift) {
        return passed(from + shift, hard_from) - passed(to + shift, hard_to);
    };
    return period > 0.0 ? once(0.0) + once(-period) + once(period) : once(0.0);
}

bool SoftRange::holds(double place) const {
    const double inside = period > 0.0 ? place - period * std::floor(place / period) : place;
    return inside >= from && inside <= to;
}

namespace {

/// Weight of a distance along an axis, 1/m: the derivative of share_within().
double weight_at(double distance, double edge) {
    const double t = distance / edge + 0.5;
    return t > 0.0 && t < 1.0 ? 6.0 * t * (1.0 - t) / edge : 0.0;
}

/// A straight edge on its way from t = 0 to 1, from a place.
struct EdgeFrom {
    std::array<double, 2> begin;
    std::array<double, 2> way;

    [[nodiscard]] double at(std::size_t axis, double t) const { return begin[axis] + t * way[axis]; }
};

/// Integral over an edge of share_within(x) weight_at(y) dy: what the edge adds, by Green's theorem, to the
/// integral of both axes' weights over the outline.
double share_of_edge(const EdgeFrom& from, double edge) {
    const double half = 0.5 * edge;
    const auto reaches = [&](std::size_t axis) {
        return std::minmax({from.begin[axis], from.begin[axis] + from.way[axis]});
    };
    const auto [lowest, highest] = reaches(1);
    const auto [least, most] = reaches(0);
    if (from.way[1] == 0.0 || highest <= -half || lowest >= half || most <= -half) return 0.0;
    if (least >= half) {
        return share_within(from.begin[1] + from.way[1], edge) - share_within(from.begin[1], edge);
    }
    // Where the way enters and leaves the strip along x in which y has a weight, and passes the ends of that
    // along y: between them the integrand is a polynomial of the fifth degree.
    const auto passes = [&](std::size_t axis, double place) {
        return std::clamp((place - from.begin[axis]) / from.way[axis], 0.0, 1.0);
    };
    std::array<double, 4> t{passes(1, -half), passes(1, half), 0.0, 0.0};
    if (t[0] > t[1]) std::swap(t[0], t[1]);
    t[2] = t[3] = t[1];
    if (from.way[0] != 0.0) {
        t[2] = std::clamp(passes(0, -half), t[0], t[1]);
        t[3] = std::clamp(passes(0, half), t[0], t[1]);
    }
    std::sort(t.begin(), t.end());
    constexpr std::array<double, 3> places{-0.7745966692414834, 0.0, 0.7745966692414834};  // Gauss
    constexpr std::array<double, 3> weights{5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
    double sum = 0.0;
    for (std::size_t piece = 0; piece + 1 < t.size(); ++piece) {
        const double length = t[piece + 1] - t[piece];
        if (length <= 0.0) continue;
        for (std::size_t k = 0; k < places.size(); ++k) {
            const double at = t[piece] + 0.5 * length * (1.0 + places[k]);
            sum += length * weights[k] * share_within(from.at(0, at), edge) * weight_at(from.at(1, at), edge);
        }
    }
    return sum * from.way[1];
}

}  // namespace

SoftOutline::SoftOutline(Outline outline, std::vector<bool> at_solid, const WaterBounds& bounds, double edge,
                         double touch)
    : outline_(std::move(outline)),
      at_solid_(std::move(at_solid)),
      bounds_(bounds),
      turn_(signed_area(outline_) < 0.0 ? -1.0 : 1.0),
      edge_(edge),
      touch_(touch) {
    if (std::none_of(at_solid_.begin(), at_solid_.end(), [](bool solid) { return solid; })) at_solid_.clear();
    const auto range = [edge](const std::vector<double>& values) {
        const auto [least, most] = std::minmax_element(values.begin(), values.end());
        return std::array{*least - 0.5 * edge, *most + 0.5 * edge};
    };
    first_range_ = range(outline_.x);
    second_range_ = range(outline_.z);
    constexpr double most_strips = 4096;
    const double height = second_range_[1] - second_range_[0];
    strip_ = std::max(edge, height / most_strips);
    strips_.resize(static_cast<std::size_t>(height / strip_) + 1);
    for (std::size_t i = 0; i < outline_.size(); ++i) {
        const auto [low, high] = std::minmax({outline_.z[i], outline_.z[outline_.next(i)]});
        const std::size_t last = strip_of(high + 0.5 * edge);
        for (std::size_t k = strip_of(low - 0.5 * edge); k <= last; ++k) strips_[k].push_back(i);
    }
    const auto shifts = [edge](double period, const std::array<double, 2>& reach) {
        std::vector<double> needed{0.0};
        for (const double shift : {-period, period}) {
            const bool meets = reach[1] + shift >= -edge && reach[0] + shift <= period + edge;
            if (period > 0.0 && meets) needed.push_back(shift);
        }
        return needed;
    };
    for (const double first : shifts(bounds.periods[0], first_range_)) {
        for (const double second : shifts(bounds.periods[1], second_range_)) {
            images_.push_back({first, second});
        }
    }
}

std::size_t SoftOutline::strip_of(double second) const {
    const double strip = std::max(0.0, (second - second_range_[0]) / strip_);
    return std::min(static_cast<std::size_t>(strip), strips_.size() - 1);
}

double SoftOutline::before_solids(double first, double second) const {
    double part = 1.0;
    double nearest = std::numeric_limits<double>::infinity();
    bool behind = false;
    for (std::size_t i = 0; i < outline_.size(); ++i) {
        const double distance = distance_from_edge(outline_, i, first, second);
        if (distance < nearest) {
            nearest = distance;
            behind = at_solid_[i];
        }
        if (!at_solid_[i] || distance > edge_) continue;
        const std::size_t j = outline_.next(i);
        const double x = outline_.x[j] - outline_.x[i];
        const double z = outline_.z[j] - outline_.z[i];
        const double within = turn_ * (x * (second - outline_.z[i]) - z * (first - outline_.x[i]));
        part *= share_within(within / std::hypot(x, z), edge_);
    }
    if (behind && nearest > touch_ && !contains(outline_, first, second)) return 0.0;
    return part;
}

double SoftOutline::own_share(double first, double second) const {
    if (first < first_range_[0] || first > first_range_[1] || second < second_range_[0] ||
        second > second_range_[1]) {
        return 0.0;
    }
    double sum = 0.0;
    for (const std::size_t i : strips_[strip_of(second)]) {
        const std::size_t j = outline_.next(i);
        sum += share_of_edge({{outline_.x[i] - first, outline_.z[i] - second},
                              {outline_.x[j] - outline_.x[i], outline_.z[j] - outline_.z[i]}},
                             edge_);
    }
    sum = std::max(0.0, turn_ * sum);
    if (at_solid_.empty() || sum == 0.0) return sum;
    const double part = before_solids(first, second);
    return part > 0.0 ? std::min(1.0, sum / part) : 0.0;
}

double SoftOutline::share(double first, double second) const {
    double sum = 0.0;
    for (const auto& shift : images_) sum += own_share(first - shift[0], second - shift[1]);
    // What of the place is in the channel; a particle may stand a little beyond a wall.
    double water = 1.0;
    const std::array place{first, second};
    for (std::size_t axis = 0; axis < place.size(); ++axis) {
        const double at = std::clamp(place[axis], bounds_.from[axis], bounds_.to[axis]);
        water *= share_within(at - bounds_.from[axis], edge_) - share_within(at - bounds_.to[axis], edge_);
    }
    return water > 0.0 ? std::min(1.0, sum / water) : 0.0;
}

bool SoftOutline::holds(double first, double second) const {
    return std::any_of(images_.begin(), images_.end(), [&](const auto& shift) {
        return contains(outline_, first - shift[0], second - shift[1]);
    });
}

}  // namespace riffle::inline case_file

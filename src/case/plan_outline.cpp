#include "case/plan_outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace riffle::inline case_file {

namespace {

/// Where two straight edges cross, along x; nothing where they do not or lie along each other.
std::optional<double> crossing_place(const Outline& one, std::size_t i, const Outline& other, std::size_t j) {
    const std::size_t i_end = one.next(i);
    const std::size_t j_end = other.next(j);
    const double ax = one.x[i_end] - one.x[i];
    const double ay = one.z[i_end] - one.z[i];
    const double bx = other.x[j_end] - other.x[j];
    const double by = other.z[j_end] - other.z[j];
    const double turn = ax * by - ay * bx;
    if (turn == 0.0) return std::nullopt;
    const double x = other.x[j] - one.x[i];
    const double y = other.z[j] - one.z[i];
    const double on_one = (x * by - y * bx) / turn;
    const double on_other = (x * ay - y * ax) / turn;
    if (on_one < 0.0 || on_one > 1.0 || on_other < 0.0 || on_other > 1.0) return std::nullopt;
    return one.x[i] + on_one * ax;
}

/// The part of an outline on one side of a line at a right angle to an axis: where sign * place is at most
/// sign * bound. What the line cuts apart stays together by edges on it that enclose no area.
Outline cut(const Outline& outline, std::size_t axis, double bound, double sign) {
    Outline kept;
    const std::vector<double>& place = axis == 0 ? outline.x : outline.z;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::size_t j = outline.next(i);
        const bool here = sign * place[i] <= sign * bound;
        const bool there = sign * place[j] <= sign * bound;
        if (here) {
            kept.x.push_back(outline.x[i]);
            kept.z.push_back(outline.z[i]);
        }
        if (here != there) {
            const double part = (bound - place[i]) / (place[j] - place[i]);
            kept.x.push_back(outline.x[i] + part * (outline.x[j] - outline.x[i]));
            kept.z.push_back(outline.z[i] + part * (outline.z[j] - outline.z[i]));
        }
    }
    return kept;
}

}  // namespace

Outline rectangle_in_plan(const PatchRange& along, const PatchRange& across) {
    return {{along.from, along.to, along.to, along.from}, {across.from, across.from, across.to, across.to}};
}

std::vector<PatchRange> chords(const Outline& outline, std::size_t axis, double place) {
    const std::vector<double>& own = axis == 0 ? outline.x : outline.z;
    const std::vector<double>& other = axis == 0 ? outline.z : outline.x;
    std::vector<double> crossings;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::size_t j = outline.next(i);
        if ((other[i] > place) == (other[j] > place)) continue;
        crossings.push_back(own[i] + (place - other[i]) / (other[j] - other[i]) * (own[j] - own[i]));
    }
    std::sort(crossings.begin(), crossings.end());
    std::vector<PatchRange> stretches;
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
        // A line through a corner alone cuts nothing.
        if (crossings[k + 1] > crossings[k]) stretches.push_back({crossings[k], crossings[k + 1]});
    }
    return stretches;
}

double least_width(const Outline& outline) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::size_t j = outline.next(i);
        const double x = outline.x[j] - outline.x[i];
        const double z = outline.z[j] - outline.z[i];
        const double length = std::hypot(x, z);
        if (length == 0.0) continue;
        double low = 0.0;
        double high = 0.0;
        for (std::size_t k = 0; k < outline.size(); ++k) {
            const double beside =
                (x * (outline.z[k] - outline.z[i]) - z * (outline.x[k] - outline.x[i])) / length;
            low = std::min(low, beside);
            high = std::max(high, beside);
        }
        least = std::min(least, high - low);
    }
    return least;
}

double usual_thickness(const Outline& outline) {
    std::vector<std::pair<double, double>> edges;  // thickness and length
    double around = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::size_t j = outline.next(i);
        const double length = std::hypot(outline.x[j] - outline.x[i], outline.z[j] - outline.z[i]);
        if (length == 0.0) continue;
        edges.emplace_back(thickness_at(outline, i), length);
        around += length;
    }
    std::sort(edges.begin(), edges.end());
    double passed = 0.0;
    for (const auto& [thickness, length] : edges) {
        passed += length;
        if (passed >= 0.5 * around) return thickness;
    }
    return 0.0;
}

double common_area(const Outline& one, const Outline& other) {
    // Between two places where either has a corner, or their edges cross, what they have in common across the
    // channel changes linearly along it.
    std::vector<double> places = one.x;
    places.insert(places.end(), other.x.begin(), other.x.end());
    for (std::size_t i = 0; i < one.size(); ++i) {
        for (std::size_t j = 0; j < other.size(); ++j) {
            if (const auto x = crossing_place(one, i, other, j)) places.push_back(*x);
        }
    }
    std::sort(places.begin(), places.end());
    double area = 0.0;
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
        const double middle = 0.5 * (places[k] + places[k + 1]);
        for (const PatchRange& here : chords(one, 1, middle)) {
            for (const PatchRange& there : chords(other, 1, middle)) {
                area += std::max(0.0, here.overlap(there)) * (places[k + 1] - places[k]);
            }
        }
    }
    return area;
}

double area_in_rectangle(const Outline& outline, const PatchRange& along, const PatchRange& across) {
    Outline inside = cut(outline, 0, along.to, 1.0);
    inside = cut(inside, 0, along.from, -1.0);
    inside = cut(inside, 1, across.to, 1.0);
    inside = cut(inside, 1, across.from, -1.0);
    return std::abs(signed_area(inside));
}

}  // namespace riffle::inline case_file

#include "case/closed_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "case/self_crossing.hpp"
#include "case/triangle_tree.hpp"
#include "case/winding.hpp"

namespace riffle::inline case_file {

namespace {

using Number = std::uint32_t;

/// Corners by number: those of the same place have the same number.
class Corners {
  public:
    Corners(const Point3& lower, const Point3& upper, std::size_t expected) : lower_(lower) {
        const Point3 size = minus(upper, lower);
        tolerance_ = weld_tolerance * std::sqrt(dot(size, size));
        // So wide that hardly a corner needs the cells beside its own.
        cell_ = std::max(64.0 * tolerance_, std::numeric_limits<double>::min());
        first_.reserve(expected);
        place_.reserve(expected);
        next_.reserve(expected);
    }

    Number number_of(const Point3& p) {
        const Cell own = cell_of(p);
        if (const auto found = in_cell(own, p)) return *found;
        Cell low{};
        Cell high{};
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = cell_at(p[k] - tolerance_, k);
            high[k] = cell_at(p[k] + tolerance_, k);
        }
        for (std::int32_t x = low[0]; x <= high[0]; ++x) {
            for (std::int32_t y = low[1]; y <= high[1]; ++y) {
                for (std::int32_t z = low[2]; z <= high[2]; ++z) {
                    const Cell cell{x, y, z};
                    const auto found = cell == own ? std::nullopt : in_cell(cell, p);
                    if (found) return *found;
                }
            }
        }
        const auto number = static_cast<Number>(place_.size());
        place_.push_back(p);
        const auto [entry, fresh] = first_.try_emplace(own, number);
        next_.push_back(fresh ? none : entry->second);
        entry->second = number;
        return number;
    }

    [[nodiscard]] const Point3& place(Number number) const { return place_[number]; }
    [[nodiscard]] std::size_t size() const { return place_.size(); }

  private:
    using Cell = std::array<std::int32_t, 3>;
    struct Hash {
        std::size_t operator()(const Cell& cell) const {
            std::uint64_t mixed = 0;
            for (const std::int32_t index : cell) {
                mixed = (mixed ^ static_cast<std::uint32_t>(index)) * 0x9e3779b97f4a7c15U;
                mixed ^= mixed >> 29U;
            }
            return static_cast<std::size_t>(mixed);
        }
    };
    static constexpr Number none = std::numeric_limits<Number>::max();

    [[nodiscard]] std::int32_t cell_at(double x, std::size_t axis) const {
        return static_cast<std::int32_t>(std::floor((x - lower_[axis]) / cell_));
    }
    [[nodiscard]] Cell cell_of(const Point3& p) const {
        return {cell_at(p[0], 0), cell_at(p[1], 1), cell_at(p[2], 2)};
    }
    [[nodiscard]] std::optional<Number> in_cell(const Cell& cell, const Point3& p) const {
        const auto first = first_.find(cell);
        for (Number i = first == first_.end() ? none : first->second; i != none; i = next_[i]) {
            const Point3 way = minus(place_[i], p);
            if (dot(way, way) <= tolerance_ * tolerance_) return i;
        }
        return std::nullopt;
    }

    Point3 lower_;
    double tolerance_ = 0.0;
    double cell_ = 0.0;
    std::unordered_map<Cell, Number, Hash> first_;
    std::vector<Number> next_;  ///< in the same cell
    std::vector<Point3> place_;
};

/// A side of a triangle, its ends in the order of their numbers.
struct Edge {
    Number low = 0;
    Number high = 0;
    Number triangle = 0;
    bool forward = false;  ///< whether the triangle passes it from `low` to `high`
};

std::string text_of(const Point3& p) { return fmt::format("({:g}, {:g}, {:g})", p[0], p[1], p[2]); }

/// Sets of triangles that hang together.
class Shells {
  public:
    explicit Shells(std::size_t triangles) : parent_(triangles) {
        std::iota(parent_.begin(), parent_.end(), Number{0});
    }
    Number of(Number i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(Number a, Number b) {
        const Number first = of(a);
        const Number second = of(b);
        parent_[std::max(first, second)] = std::min(first, second);
    }

  private:
    std::vector<Number> parent_;
};

class Surface {
  public:
    Surface(Triangles triangles, const std::string& name) : name_(name), triangles_(std::move(triangles)) {}

    ClosedSurface closed() {
        check_numbers();
        weld();
        Shells joined(triangles_.size());
        check_edges(joined);
        const std::size_t shells = turn_outward(joined);
        check_crossings(joined);
        return {std::move(triangles_), shells};
    }

  private:
    [[noreturn]] void fault(std::size_t triangle, const std::string& what) const {
        throw FileError(fmt::format("{}: triangle {}: {}", name_, triangle + 1, what));
    }

    void check_numbers() const {
        constexpr auto most =
            static_cast<double>(std::numeric_limits<float>::max());  // what a binary file can hold
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            for (const Point3& corner : triangles_[i]) {
                for (const double x : corner) {
                    if (!(std::abs(x) <= most)) {
                        fault(i, "a coordinate is not a finite number of at most 3.4e38: correct the file");
                    }
                }
            }
        }
    }

    /// Numbers the corners, moves each to the place of its number, and leaves out triangles without three.
    void weld() {
        Point3 lower = triangles_.front()[0];
        Point3 upper = lower;
        for (const Triangle& t : triangles_) {
            for (const Point3& corner : t) {
                for (std::size_t k = 0; k < 3; ++k) {
                    lower[k] = std::min(lower[k], corner[k]);
                    upper[k] = std::max(upper[k], corner[k]);
                }
            }
        }
        Corners corners(lower, upper, triangles_.size() / 2 + 2);
        std::size_t kept = 0;
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            std::array<Number, 3> numbers{};
            for (std::size_t k = 0; k < 3; ++k) numbers[k] = corners.number_of(triangles_[i][k]);
            if (numbers[0] == numbers[1] || numbers[1] == numbers[2] || numbers[2] == numbers[0]) continue;
            for (std::size_t k = 0; k < 3; ++k) triangles_[kept][k] = corners.place(numbers[k]);
            numbers_.push_back(numbers);
            in_file_.push_back(static_cast<Number>(i));
            ++kept;
        }
        triangles_.resize(kept);
        if (triangles_.empty()) {
            throw FileError(
                fmt::format("{}: holds no triangle with an area: give the closed surface of a body", name_));
        }
    }

    /// Each edge must be passed as often in one sense as in the other.
    void check_edges(Shells& shells) const {
        std::vector<Edge> edges;
        edges.reserve(3 * triangles_.size());
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                const Number a = numbers_[i][k];
                const Number b = numbers_[i][(k + 1) % 3];
                edges.push_back({std::min(a, b), std::max(a, b), static_cast<Number>(i), a < b});
            }
        }
        std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
            return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
        });
        const Edge* first_fault = nullptr;
        std::size_t passes_there = 0;
        for (std::size_t begin = 0; begin < edges.size();) {
            std::size_t end = begin;
            std::ptrdiff_t sum = 0;
            for (; end < edges.size() && edges[end].low == edges[begin].low &&
                   edges[end].high == edges[begin].high;
                 ++end) {
                sum += edges[end].forward ? 1 : -1;
                shells.join(edges[begin].triangle, edges[end].triangle);
            }
            if (sum != 0 && (first_fault == nullptr || edges[begin].triangle < first_fault->triangle)) {
                first_fault = &edges[begin];
                passes_there = end - begin;
            }
            begin = end;
        }
        if (first_fault != nullptr) {
            report({first_fault, first_fault + passes_there});
        }
    }

    /// Say what is wrong at an edge, by the triangles that pass it.
    [[noreturn]] void report(const std::vector<Edge>& passes) const {
        const Edge& first = passes.front();
        const auto corner = [&](Number number) {
            for (std::size_t k = 0; k < 3; ++k) {
                if (numbers_[first.triangle][k] == number) return text_of(triangles_[first.triangle][k]);
            }
            return std::string();
        };
        const std::string edge = fmt::format("its edge from {} to {}", corner(first.low), corner(first.high));
        const std::size_t triangle = in_file_[first.triangle];
        if (passes.size() == 1) {
            fault(triangle,
                  edge +
                      " has no neighbour: the surface is not closed; close it in the program that made it "
                      "(corners closer than a millionth of its size count as one)");
        }
        if (passes.size() == 2) {
            fault(triangle,
                  fmt::format("{} is passed in the same sense by triangle {}: one of the two is turned over; "
                              "let the program that made the file turn all of them outward",
                              edge, in_file_[passes[1].triangle] + 1));
        }
        const auto forward =
            std::count_if(passes.begin(), passes.end(), [](const Edge& e) { return e.forward; });
        fault(triangle, fmt::format("{} has {} triangles on the one side and {} on the other: a triangle is "
                                    "missing, doubled or turned over; mend it in the program that made it",
                                    edge, forward, passes.size() - static_cast<std::size_t>(forward)));
    }

    /// Shells may pass through each other, but none through itself.
    void check_crossings(Shells& shells) const {
        const TriangleTree tree(triangles_);
        const Point3 size = minus(tree.upper(), tree.lower());
        const auto crossing = self_crossing(
            tree, weld_tolerance * std::sqrt(dot(size, size)), [&](std::size_t i, std::size_t j) {
                return shells.of(static_cast<Number>(i)) == shells.of(static_cast<Number>(j));
            });
        if (crossing) {
            fault(in_file_[crossing->first],
                  fmt::format("passes through triangle {} at {}: the surface crosses itself, and what lies "
                              "inside is not known; mend it in the program that made it, or join its parts "
                              "there (Boolean union)",
                              in_file_[crossing->second] + 1, text_of(crossing->place)));
        }
    }

    void turn(const std::vector<char>& which, const std::vector<Number>& shell) {
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            if (which[shell[i]] != 0) std::swap(triangles_[i][1], triangles_[i][2]);
        }
    }

    /// Enclosed volumes by shell, negative where it is inside out.
    [[nodiscard]] std::vector<double> volumes(const std::vector<Number>& shell, std::size_t shells) const {
        std::vector<double> sums(shells, 0.0);
        std::vector<std::optional<Point3>> origins(
            shells);  // far from the origin a sum would lose its digits
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            const Triangle& t = triangles_[i];
            std::optional<Point3>& origin = origins[shell[i]];
            origin = origin.value_or(t[0]);
            sums[shell[i]] +=
                dot(minus(t[0], *origin), cross(minus(t[1], *origin), minus(t[2], *origin))) / 6.0;
        }
        return sums;
    }

    std::size_t turn_outward(Shells& joined) {
        std::vector<Number> shell(triangles_.size());
        std::size_t shells = 0;
        for (std::size_t i = 0; i < shell.size(); ++i) {
            const Number first = joined.of(static_cast<Number>(i));  // the first triangle of the shell
            shell[i] = first == i ? static_cast<Number>(shells++) : shell[first];
        }
        std::vector<double> volume = volumes(shell, shells);
        if (std::accumulate(volume.begin(), volume.end(), 0.0) < 0.0) {
            turn(std::vector<char>(shells, 1), shell);
            volume = volumes(shell, shells);
        }
        if (std::any_of(volume.begin(), volume.end(), [](double v) { return v < 0.0; })) {
            const TriangleTree tree(triangles_);
            std::vector<char> inside_out(shells);
            for (std::size_t i = 0; i < triangles_.size(); ++i) {
                if (volume[shell[i]] >= 0.0 || inside_out[shell[i]] != 0) continue;
                const auto around = [&](std::size_t other) { return volume[shell[other]] > 0.0; };
                inside_out[shell[i]] =
                    std::any_of(triangles_[i].begin(), triangles_[i].end(),
                                [&](const auto& p) { return winding_number(tree, p, around) == 0; })
                        ? 1
                        : 0;
            }
            turn(inside_out, shell);
        }
        return shells;
    }

    const std::string& name_;
    Triangles triangles_;
    std::vector<std::array<Number, 3>> numbers_;  ///< of the corners
    std::vector<Number> in_file_;                 ///< which triangle of the file each one is
};

}  // namespace

ClosedSurface closed_surface(Triangles triangles, const std::string& name) {
    return Surface(std::move(triangles), name).closed();
}

}  // namespace riffle::inline case_file

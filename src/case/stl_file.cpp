// STL files: triangles without a unit. Binary: 80 bytes, a count, 50 bytes for each triangle (normal, three
// corners, two spare bytes). Text: "solid", then "facet ... vertex x y z" three times ... "endfacet".

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "case/solid_mesh.hpp"

namespace riffle {

namespace {

static_assert(std::endian::native == std::endian::little, "binary STL files are little-endian");

std::string text_of(const Point3& p) { return fmt::format("({:g}, {:g}, {:g})", p[0], p[1], p[2]); }

class StlReader {
  public:
    explicit StlReader(const std::filesystem::path& file) : name_(file.string()) {
        std::ifstream stream(file, std::ios::binary);
        std::ostringstream content;
        content << stream.rdbuf();
        if (!stream) {
            throw FileError(fmt::format("{}: there is no such STL file, or it cannot be read", name_));
        }
        content_ = content.str();
    }

    Triangles read() {
        // Some programs begin binary files with "solid" too: the size decides.
        std::uint32_t count = 0;
        if (content_.size() >= header) {
            std::memcpy(&count, content_.data() + 80, sizeof count);
        }
        const bool binary = content_.size() == header + record * static_cast<std::size_t>(count);
        const bool text = content_.compare(0, 5, "solid") == 0;
        if (!binary && !text) {
            throw FileError(
                content_.size() < header
                    ? fmt::format("{}: not an STL file: shorter than the head of one and without \"solid\"",
                                  name_)
                    : fmt::format(
                          "{}: not an STL file, or cut short: it announces {} triangles, {} bytes, and "
                          "has {}",
                          name_, count, header + record * static_cast<std::size_t>(count), content_.size()));
        }
        Triangles triangles = binary ? read_binary(count) : read_text();
        if (triangles.empty()) {
            throw FileError(fmt::format("{}: holds no triangle", name_));
        }
        check(triangles);
        turn_outward(triangles);
        return triangles;
    }

  private:
    static constexpr std::size_t header = 84;
    static constexpr std::size_t record = 50;

    [[noreturn]] void fault(std::size_t triangle, const std::string& what) const {
        throw FileError(fmt::format("{}: triangle {}: {}", name_, triangle + 1, what));
    }

    [[nodiscard]] Triangles read_binary(std::size_t count) const {
        Triangles triangles(count);
        for (std::size_t i = 0; i < count; ++i) {
            std::array<float, 9> numbers{};
            std::memcpy(numbers.data(), content_.data() + header + record * i + 12, sizeof numbers);
            for (std::size_t k = 0; k < 9; ++k) {
                triangles[i][k / 3][k % 3] = static_cast<double>(numbers[k]);
            }
        }
        return triangles;
    }

    [[nodiscard]] Triangles read_text() const {
        std::istringstream stream(content_);
        Triangles triangles;
        std::string word;
        std::size_t corners = 0;
        bool ended = false;
        std::getline(stream, word);  // "solid" and a name of any words
        while (stream >> word) {
            if (word == "facet") {
                triangles.emplace_back();
                corners = 0;
            } else if (word == "vertex") {
                if (triangles.empty() || corners == 3) {
                    fault(triangles.empty() ? 0 : triangles.size() - 1,
                          "expected three lines `vertex x y z`");
                }
                for (double& x : triangles.back()[corners]) {
                    if (!(stream >> x)) {
                        fault(triangles.size() - 1, "expected `vertex` and three numbers");
                    }
                }
                ++corners;
            } else if (word == "endfacet" && corners != 3) {
                fault(triangles.empty() ? 0 : triangles.size() - 1,
                      fmt::format("has {} corners instead of 3", corners));
            } else if (word == "endsolid") {
                ended = true;
                break;
            }
        }
        if (!ended) {
            throw FileError(fmt::format("{}: cut short: `endsolid` is missing", name_));
        }
        return triangles;
    }

    void check(const Triangles& triangles) const {
        std::map<std::pair<Point3, Point3>, std::size_t> edges;
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            const auto& t = triangles[i];
            for (const Point3& corner : t) {
                for (const double x : corner) {
                    if (!std::isfinite(x)) {
                        fault(i, "a coordinate is not a finite number");
                    }
                }
            }
            for (std::size_t k = 0; k < 3; ++k) {
                const Point3& a = t[k];
                const Point3& b = t[(k + 1) % 3];
                if (a == b) {
                    fault(i, fmt::format("two of its corners are the same, {}: it has no area", text_of(a)));
                }
                const auto [other, fresh] = edges.emplace(std::pair(a, b), i);
                if (!fresh) {
                    fault(i, fmt::format(
                                 "its edge from {} to {} is passed in the same sense by triangle {}: one "
                                 "of the two is turned over, or the surface meets itself there",
                                 text_of(a), text_of(b), other->second + 1));
                }
            }
            if (has_no_area(t)) {
                fault(i, "its corners lie on a line: it has no area");
            }
        }
        for (const auto& [edge, i] : edges) {
            if (!edges.contains({edge.second, edge.first})) {
                fault(i,
                      fmt::format("its edge from {} to {} has no neighbour: the surface is not closed; close "
                                  "it in the program that made it (its corners must agree to the last digit)",
                                  text_of(edge.first), text_of(edge.second)));
            }
        }
    }

    static bool has_no_area(const std::array<Point3, 3>& t) {
        Point3 a{};
        Point3 b{};
        for (std::size_t k = 0; k < 3; ++k) {
            a[k] = t[1][k] - t[0][k];
            b[k] = t[2][k] - t[0][k];
        }
        const double area =
            std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
        return area <= 1e-12 * std::hypot(a[0], a[1], a[2]) * std::hypot(b[0], b[1], b[2]);
    }

    static void turn_outward(Triangles& triangles) {
        if (SolidMesh(triangles).volume() < 0.0) {
            for (auto& t : triangles) {
                std::swap(t[1], t[2]);
            }
        }
    }

    std::string name_;
    std::string content_;
};

}  // namespace

Triangles read_stl(const std::filesystem::path& file) { return StlReader(file).read(); }

}  // namespace riffle

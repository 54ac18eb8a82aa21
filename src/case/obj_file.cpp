#include "case/obj_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "base/error.hpp"
#include "case/polygon.hpp"
#include "case/text_lines.hpp"

namespace riffle::inline case_file {

namespace {

class ObjReader {
  public:
    ObjReader(std::string_view content, const std::string& name) : lines_(content, name), name_(name) {}

    Triangles read() {
        while (lines_.next()) {
            const auto& line = lines_.words();
            const auto comment =
                std::find_if(line.begin(), line.end(), [](auto word) { return word.starts_with('#'); });
            words_.insert(words_.end(), line.begin(), comment);
            if (!words_.empty() && words_.back() == "\\") {  // the statement goes on in the next line
                words_.pop_back();
                continue;
            }
            statement();
            words_.clear();
        }
        if (!words_.empty()) lines_.fault("cut short: a line that ends with \\ must be followed by another");
        if (triangles_.empty()) {
            throw FileError(
                fmt::format("{}: holds no face (lines `f ...`): give the closed surface of a body", name_));
        }
        return std::move(triangles_);
    }

  private:
    void statement() {
        static constexpr std::array<std::string_view, 18> passed_over{
            "vt", "vn", "vp",     "g",      "o",   "s",     "mg",       "usemtl",   "mtllib",
            "l",  "p",  "usemap", "maplib", "lod", "bevel", "c_interp", "d_interp", "shadow_obj"};
        if (words_.empty()) return;
        const std::string_view keyword = words_.front();
        if (keyword == "v") {
            add_corner();
        } else if (keyword == "f") {
            add_face();
        } else if (std::find(passed_over.begin(), passed_over.end(), keyword) == passed_over.end()) {
            lines_.fault(fmt::format(
                "expected `v` (a corner), `f` (a face) or what goes with them, found `{}`: not an OBJ file of "
                "polygons; let the program that made it write triangles",
                shown_word(keyword)));
        }
    }

    void add_corner() {
        // Behind x, y and z there may be a weight or a colour.
        if (words_.size() < 4) {
            lines_.fault(fmt::format("expected `v` and three numbers, found {}", words_.size() - 1));
        }
        Point3 corner{};
        for (std::size_t k = 0; k < 3; ++k) corner[k] = lines_.number(words_[k + 1], "`v` and three numbers");
        corners_.push_back(corner);
    }

    void add_face() {
        if (words_.size() < 4) {
            lines_.fault(fmt::format("a face has {} corners: expected three or more", words_.size() - 1));
        }
        constexpr std::size_t most = 1000;
        if (words_.size() - 1 > most) {
            lines_.fault(
                fmt::format("a face has {} corners: expected at most {}; let the program that made "
                            "the file write triangles",
                            words_.size() - 1, most));
        }
        std::vector<Point3> face;
        for (auto word = words_.begin() + 1; word != words_.end(); ++word) face.push_back(corner_of(*word));
        if (face.size() == 3) {
            triangles_.push_back({face[0], face[1], face[2]});
            return;
        }
        const auto parts = polygon_triangles(face);
        if (parts.empty()) lines_.fault("a face crosses itself or has no area: mend it, or write triangles");
        for (const auto& part : parts) {
            triangles_.push_back({face[part[0]], face[part[1]], face[part[2]]});
        }
    }

    /// The corner of "i", "i/texture", "i//normal" or "i/texture/normal"; negative ones count back.
    [[nodiscard]] const Point3& corner_of(std::string_view word) const {
        const long long number =
            lines_.integer(word.substr(0, word.find('/')), "`f` and the numbers of its corners");
        const auto count = static_cast<long long>(corners_.size());
        const long long index = number > 0 ? number - 1 : count + number;
        if (number == 0 || index < 0 || index >= count) {
            lines_.fault(
                fmt::format("a face names corner {}, and {} stand before it: the file is damaged or "
                            "cut; write it anew",
                            number, count));
        }
        return corners_[static_cast<std::size_t>(index)];
    }

    TextLines lines_;
    const std::string& name_;
    std::vector<std::string_view> words_;
    std::vector<Point3> corners_;
    Triangles triangles_;
};

}  // namespace

Triangles parse_obj(std::string_view content, const std::string& name) {
    return ObjReader(content, name).read();
}

}  // namespace riffle::inline case_file

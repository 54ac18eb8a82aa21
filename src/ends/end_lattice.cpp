#include "ends/end_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "case/cross_section.hpp"
#include "case/end_levels.hpp"
#include "case/solid_mesh.hpp"
#include "column/canal_channel.hpp"

namespace riffle::inline ends {

EndLattice::EndLattice(const Case& c, const Lattice& lattice, double x) {
    const Solid* const bed = uneven_bed_of(c);
    if (bed == nullptr) return;
    files_ = static_cast<std::size_t>(lattice.files);
    const auto meshes = meshes_of(c);
    const SolidMesh& mesh = (*meshes)[static_cast<std::size_t>(bed - c.solids.data())];
    const int rows = std::max(2, static_cast<int>(std::ceil(level_with_room(c) / lattice.dz)));
    std::vector<double> depth{0.0};
    std::vector<double> width;
    floor_.assign(files_, lattice.z(rows - 1));
    for (int row = 0; row < rows; ++row) {
        int wet = 0;
        for (int file = 0; file < lattice.files; ++file) {
            const bool holds = !mesh.contains({x, lattice.y(file, row), lattice.z(row)});
            holds_.push_back(static_cast<std::uint8_t>(holds));
            if (!holds) continue;
            ++wet;
            double& floor = floor_[static_cast<std::size_t>(file)];
            floor = std::min(floor, row * lattice.dz);
        }
        if (wet == 0 && width.empty()) {
            lowest_ = (row + 1) * lattice.dz;  // no water as low as that
            continue;
        }
        width.push_back(wet / static_cast<double>(files_));
        depth.push_back(lattice.z(row) - lowest_);
    }
    if (width.empty()) {
        // All of it stands above the water: as if a row began there.
        width.push_back(1.0);
        depth.push_back(0.5 * lattice.dz);
    }
    // From the floor to the middle of the lowest row it is as wide as that.
    width.insert(width.begin(), width.front());
    std::vector<double> perimeter(width.size(), 1.0);  // not asked for
    shape_ = std::make_shared<const SectionShape>(std::move(depth), std::move(width), std::move(perimeter));
}

bool EndLattice::holds(int row, int file) const {
    if (is_rectangle()) return true;
    const std::size_t last = holds_.size() / files_ - 1;
    const std::size_t at = std::min(static_cast<std::size_t>(std::max(row, 0)), last);
    return holds_[at * files_ + static_cast<std::size_t>(file)] != 0;
}

double EndLattice::floor_of(int file) const {
    return is_rectangle() ? 0.0 : floor_[static_cast<std::size_t>(file)];
}

LongWaves waves_of_lattice(const Case& c, bool at_inflow) {
    return EndLattice(c, lattice_of(c), place_of_end(c, at_inflow)).waves(c.normal_gravity());
}

LongWaves waves_of(const Case& c, bool at_inflow) {
    const Solid* const section = section_of(c);
    if (section != nullptr) return {c.normal_gravity(), shape_of_section(c, *section)};
    return measured_bed_of(c) != nullptr ? waves_of_lattice(c, at_inflow) : LongWaves(c.normal_gravity());
}

}  // namespace riffle::inline ends

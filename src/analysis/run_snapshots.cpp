#include "analysis/run_snapshots.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "case/flow_kind.hpp"
#include "case/solid_shapes.hpp"
#include "particles/lattice.hpp"
#include "record/particle_fields.hpp"
#include "record/whole_snapshots.hpp"

namespace riffle::inline analysis {

namespace {

/// Whether the flow is the same all along a channel, on the mean over its plan: nothing stands in it but a
/// bed of bodies.
bool is_uniform_over_plan(const Case& c) {
    return c.channel.ends == Ends::periodic && is_channel(flow_kind(c)) &&
           std::all_of(c.solids.begin(), c.solids.end(),
                       [](const Solid& solid) { return solid.part_of_bed || is_bed_shape(solid.shape); });
}

}  // namespace

std::array<std::vector<double>, 3> components(const std::vector<double>& rows) {
    std::array<std::vector<double>, 3> result;
    for (std::size_t k = 0; k < 3; ++k) {
        result[k].resize(rows.size() / 3);
        for (std::size_t i = 0; i < result[k].size(); ++i) result[k][i] = rows[3 * i + k];
    }
    return result;
}

EddiesAndNoise read_eddies_and_noise(const RunResults& results, const Case& c, const TimeWindow& window,
                                     std::size_t most_particles) {
    if (c.channel.dimensions != 3 || !is_uniform_over_plan(c) || has_mixing_length(c) ||
        !snapshots_are_whole(c)) {
        return {};
    }
    const auto& of = fields::snapshot;
    std::vector<std::string> groups;
    for (SnapshotPlace& snapshot : snapshots_with_velocities(results)) {
        if (window.holds(snapshot.time)) groups.push_back(std::move(snapshot.group));
    }
    if (groups.empty()) {
        return {};
    }
    const std::size_t in_one = std::max<std::size_t>(results.shape({groups[0], of.position})[0], 1);
    const std::size_t most = std::clamp<std::size_t>(most_particles / in_one, 1, groups.size());
    NoiseSplit split(domain_of<3>(c), c.numerics.spacing, 1.5 * c.total_depth());
    for (std::size_t i = 0; i < most; ++i) {
        const std::string& group = groups[i * groups.size() / most];
        const std::vector<double> position = results.values({group, of.position});
        const std::vector<double> velocity = results.values({group, of.velocity});
        if (position.size() != velocity.size()) {
            throw FileError(group + " of " + results.path().string() +
                            ": positions and velocities do not fit each other; the file is damaged");
        }
        split.add({components(position), components(velocity)});
    }
    return split.result();
}

}  // namespace riffle::inline analysis

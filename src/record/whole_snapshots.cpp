#include "record/whole_snapshots.hpp"

#include <optional>
#include <utility>

#include "record/particle_fields.hpp"

namespace riffle::inline record {

bool snapshots_are_whole(const Case& c) {
    const Output& output = c.output;
    return output.snapshot_x.empty() && output.snapshot_y.empty() && output.snapshot_z.empty();
}

std::vector<SnapshotPlace> snapshots_with_velocities(const RunResults& results) {
    const auto& of = fields::snapshot;
    std::vector<SnapshotPlace> found;
    for (const std::string& name : results.children(snapshots_group)) {
        std::string group = std::string(snapshots_group) + "/" + name;
        const std::optional<double> time = results.number({group, of.time});
        if (time && results.has({group, of.position}) && results.has({group, of.velocity})) {
            found.push_back({*time, std::move(group)});
        }
    }
    return found;
}

}  // namespace riffle::inline record

#include "solver/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/error.hpp"
#include "case/refusals.hpp"
#include "instruments/probe_set.hpp"
#include "output/checkpoint_file.hpp"
#include "output/folder_lock.hpp"
#include "solver/recorder.hpp"
#include "solver/run_identity.hpp"
#include "solver/run_session.hpp"
#include "solver/start.hpp"

namespace riffle::inline solver {

namespace {

namespace fs = std::filesystem;

/// Lock the folder of a run, with a note where the file system cannot.
FolderLock lock_folder(RunOptions& options) {
    FolderLock lock(options.folder, FolderLock::Work::run);
    if (!lock.holds()) {
        options.notes.push_back(fmt::format(
            "the file system of {} knows no locks: take care that no second run works in this folder",
            options.folder.string()));
    }
    return lock;
}

/// Keys that a resumed run may change: they leave the state valid.
bool may_change(const std::string& key) {
    constexpr std::array<const char*, 2> steps = {"numerics.courant_number", "numerics.time_step"};
    // A record that begins or ends in the middle would have gaps that no reader expects.
    constexpr std::array<const char*, 4> fixed = {"output.standard_probes", "output.mean_field_interval",
                                                  "output.mean_field_spacing", "output.snapshot_fields"};
    return std::find(fixed.begin(), fixed.end(), key) == fixed.end() &&
           (key.rfind("run.", 0) == 0 || key.rfind("output.", 0) == 0 || key == steps[0] || key == steps[1]);
}

/// f.operator()<D>() with the dimensions of the case.
template <class F>
RunOutcome in_dimensions(const Case& c, const F& f) {
    return c.channel.dimensions == 2 ? f.template operator()<2>() : f.template operator()<3>();
}

}  // namespace

void check_runnable(const Case& c) {
    // Between side walls a flow may have a section twin, by whose relaxation time it is tested, and no
    // column.
    if (c.run.until != RunUntil::converged || !has_section(c)) refuse_to_run(c);
    const auto column = has_column(c) ? std::optional(solve_column(c)) : std::nullopt;
    (void)ProbeSet(c, largest_step(c, make_scheme(c, column ? &*column : nullptr)));
}

RunOutcome run_case(const Case& c, const RunOptions& given) {
    check_runnable(c);
    RunOptions options = given;
    const FolderLock lock = lock_folder(options);
    const RunFiles files{options.folder};
    if (!options.overwrite && (fs::exists(files.results()) || fs::exists(files.checkpoint()))) {
        throw FileError(
            fmt::format("{} already holds results. Go on with `riffle resume {}`, give another folder with "
                        "-o, or replace them with --force",
                        options.folder.string(), options.folder.string()));
    }
    return in_dimensions(c, [&]<int D>() { return RunSession<D>(c, options, lock).run(); });
}

RunOutcome resume_run(const RunOptions& given, const fs::path& checkpoint,
                      const std::vector<Override>& overrides) {
    RunOptions options = given;
    const RunFiles files{options.folder};
    const fs::path from = checkpoint.empty() ? files.checkpoint() : checkpoint;
    if (std::error_code error; fs::is_regular_file(options.folder, error)) {
        const fs::path folder = options.folder.has_parent_path() ? options.folder.parent_path() : ".";
        const bool of_run = fs::exists(RunFiles{folder}.checkpoint());
        throw FileError(fmt::format("{} is a file: give the folder of the run, {}", options.folder.string(),
                                    of_run ? fmt::format("`riffle resume {}`", folder.string())
                                           : "for example `riffle resume results/my-flume`"));
    }
    if (!fs::exists(files.results()) && !fs::exists(from)) {
        throw FileError(
            fmt::format("{} holds no run to resume (no results.h5, no checkpoint.h5); start one with "
                        "`riffle run CASE -o {}`",
                        options.folder.string(), options.folder.string()));
    }
    for (const Override& o : overrides) {
        if (!may_change(o.key)) {
            throw InputError(fmt::format(
                "--set {}: a resumed run may change only the keys of [run] and [output], "
                "numerics.courant_number and numerics.time_step, but not output.standard_probes, "
                "output.mean_field_interval, output.mean_field_spacing and output.snapshot_fields; start a "
                "new run for this",
                o.key));
        }
    }
    const FolderLock lock = lock_folder(options);
    const CheckpointReader checkpoint_file(from);
    const Case c = parse_case(checkpoint_file.read_string("/case/text"), from.string(), {}, overrides);
    // Before any of its files is read: one that is gone or another one is said to be so.
    const std::vector<std::string> warnings = compare_identity(checkpoint_file, c);
    check_runnable(c);
    return in_dimensions(c, [&]<int D>() { return RunSession<D>(c, options, lock).resume(from, warnings); });
}

}  // namespace riffle::inline solver

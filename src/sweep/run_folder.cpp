#include "sweep/run_folder.hpp"

#include <fmt/format.h>

#include <sstream>
#include <system_error>
#include <vector>

#include "base/error.hpp"
#include "case/conversion.hpp"
#include "case/key_table.hpp"
#include "record/run_fields.hpp"
#include "record/run_results.hpp"
#include "solver/run.hpp"

namespace riffle::inline sweep {

namespace {

/// The keys in which two cases differ, with their values: "numerics.spacing = 2 mm, not 1 mm".
std::string differences(const Case& found, const Case& wanted) {
    std::vector<std::string> list;
    for (const SectionKeys& section : key_table()) {
        if (section.repeated()) continue;
        for (const Key& key : section.keys) {
            if (key.get(found) != key.get(wanted)) {
                list.push_back(fmt::format("{} = {}, not {}", key.id(), handy_value_text(key, key.get(found)),
                                           handy_value_text(key, key.get(wanted))));
            }
        }
    }
    if (list.empty()) return "other instruments";
    constexpr std::size_t most = 4;
    const std::size_t more = list.size() > most ? list.size() - most : 0;
    list.resize(list.size() - more);
    return fmt::format("{}{}", fmt::join(list, "; "), more > 0 ? fmt::format("; and {} more", more) : "");
}

}  // namespace

FolderStanding standing_of(const SweepRun& run) {
    const RunFiles files{run.folder};
    std::error_code error;
    const bool results = std::filesystem::exists(files.results(), error);
    const bool checkpoint = std::filesystem::exists(files.checkpoint(), error);
    if (!results) {
        return checkpoint ? FolderStanding{FolderState::other, "a checkpoint without results.h5"}
                          : FolderStanding{};
    }
    try {
        const RunResults results_file(files.results());
        const Case found =
            parse_case(results_file.stored_text(fields::stored_case.text), files.results().string());
        if (found.text != run.flow.text) {
            return {FolderState::other, differences(found, run.flow)};
        }
        if (results_file.number(fields::file.complete).value_or(0.0) != 0.0) {
            return {FolderState::complete, {}};
        }
        const std::string failure = results_file.text(fields::file.failure);
        if (!failure.empty()) {
            return {FolderState::failed, failure};
        }
    } catch (const Error& unreadable) {
        return {FolderState::other, unreadable.what()};
    }
    // Without a checkpoint nothing of it can be gone on with.
    return checkpoint ? FolderStanding{FolderState::interrupted, {}} : FolderStanding{};
}

const char* word(FolderState state) {
    switch (state) {
        case FolderState::empty:
            return "new";
        case FolderState::interrupted:
            return "interrupted";
        case FolderState::complete:
            return "complete";
        case FolderState::failed:
            return "failed";
        case FolderState::other:
            break;
    }
    return "another case";
}

}  // namespace riffle::inline sweep

#include "sweep/run_folder.hpp"

#include <fmt/format.h>

#include <sstream>
#include <system_error>
#include <vector>

#include "base/error.hpp"
#include "case/conversion.hpp"
#include "case/key_table.hpp"
#include "output/results_file.hpp"
#include "solver/run.hpp"

namespace riffle {

namespace {

/// The keys in which two cases differ, with their values: "numerics.spacing = 2 mm, not 1 mm".
std::string differences(const Case& found, const Case& wanted) {
    std::vector<std::string> list;
    for (const SectionKeys& section : key_table()) {
        if (section.repeated()) {
            continue;
        }
        for (const Key& key : section.keys) {
            if (key.get(found) != key.get(wanted)) {
                list.push_back(fmt::format("{} = {}, not {}", key.id(), handy_value_text(key, key.get(found)),
                                           handy_value_text(key, key.get(wanted))));
            }
        }
    }
    if (list.empty()) {
        return "other instruments";
    }
    constexpr std::size_t most = 4;
    const std::size_t more = list.size() > most ? list.size() - most : 0;
    list.resize(list.size() - more);
    return fmt::format("{}{}", fmt::join(list, "; "), more > 0 ? fmt::format("; and {} more", more) : "");
}

bool is_complete(const ResultsReader& reader) {
    const auto complete = reader.attribute("/", "complete");
    const auto* const value = complete ? std::get_if<std::int64_t>(&*complete) : nullptr;
    return value != nullptr && *value != 0;
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
        const ResultsReader reader(files.results());
        const Case found = parse_case(reader.read_string("/case/text"), files.results().string());
        if (found.text != run.flow.text) {
            return {FolderState::other, differences(found, run.flow)};
        }
        if (is_complete(reader)) {
            return {FolderState::complete, {}};
        }
        const auto failure = reader.attribute("/", "failure");
        const auto* const message = failure ? std::get_if<std::string>(&*failure) : nullptr;
        if (message != nullptr && !message->empty()) {
            return {FolderState::failed, *message};
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

}  // namespace riffle

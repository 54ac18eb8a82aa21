#include "solver/run_identity.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <map>
#include <random>
#include <span>
#include <sstream>
#include <vector>

#include "base/error.hpp"
#include "base/version.hpp"
#include "output/checksum.hpp"
#include "output/file_replace.hpp"
#include "record/field_content.hpp"
#include "record/run_fields.hpp"
#include "sph/pair_loops.hpp"

namespace riffle::inline solver {

namespace {

/// "checksum bytes" of a file, which may be larger than the memory.
std::string checksum_text(const std::filesystem::path& path) {
    constexpr std::size_t piece = std::size_t{1} << 20U;
    std::ifstream file(path, std::ios::binary);
    std::vector<char> bytes(piece);
    std::uint64_t checksum = 0;
    std::uint64_t size = 0;
    while (file) {
        file.read(bytes.data(), static_cast<std::streamsize>(piece));
        const auto count = static_cast<std::size_t>(file.gcount());
        checksum = crc64(std::as_bytes(std::span(bytes).first(count)), checksum);
        size += count;
    }
    return file.eof() ? fmt::format("{:016x} {}", checksum, size) : "- -";
}

/// By key and path: "checksum bytes".
std::map<std::string, std::string> parse_inputs(const std::string& text) {
    std::map<std::string, std::string> inputs;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string checksum;
        std::string bytes;
        words >> checksum >> bytes >> std::ws;
        std::string rest;
        std::getline(words, rest);
        inputs[rest] = fmt::format("{} {}", checksum, bytes);
    }
    return inputs;
}

std::string text_attribute(const ContentReader& file, const Field& field) {
    const auto value = file.attribute(field.group->path, field.name);
    const auto* const text = value ? std::get_if<std::string>(&*value) : nullptr;
    return text != nullptr ? *text : std::string();
}

}  // namespace

std::vector<InputFile> input_files(const Case& c) {
    std::vector<InputFile> files;
    for (std::size_t i = 0; i < c.solids.size(); ++i) {
        if (!c.solids[i].file.empty()) {
            files.push_back({fmt::format("solid[{}].file", i + 1), c.solids[i].file, true});
        }
        if (!c.solids[i].heights.empty()) {
            files.push_back({fmt::format("solid[{}].heights", i + 1), c.solids[i].heights, true});
        }
    }
    if (c.start.kind == StartKind::results || c.start.kind == StartKind::isotropic) {
        files.push_back({"start.file", c.start.file, false});
    }
    const auto add = [&files](const char* key, const std::filesystem::path& path) {
        if (!path.empty()) {
            files.push_back({key, path, true});
        }
    };
    add("inflow.discharge_file", c.inflow.discharge_file);
    add("inflow.depth_file", c.inflow.depth_file);
    add("inflow.profile_file", c.inflow.profile_file);
    add("inflow.results", c.inflow.results);
    add("outflow.depth_file", c.outflow.depth_file);
    add("outflow.rating_file", c.outflow.rating_file);
    if (!c.measured.velocity_profile.empty()) {
        files.push_back({"measured.velocity_profile", c.measured.velocity_profile, false});
    }
    return files;
}

std::string new_run_id() {
    std::random_device device;
    return fmt::format("{:08x}{:08x}", device(), device());
}

std::string input_checksums(const Case& c) {
    std::string text;
    for (const InputFile& file : input_files(c)) {
        text += fmt::format("{} {} {}\n", checksum_text(file.path), file.key, file.path.string());
    }
    return text;
}

void add_identity(Content& content, const std::string& run_id, const std::string& inputs) {
    add_field(content, fields::file.run, run_id);
    add_field(content, fields::file.build, build_description());
    add_field(content, fields::file.instruction_set, instruction_set_name(active_instruction_set()));
    content.datasets.push_back(dataset_of(fields::stored_case.inputs, 2, {}, inputs));
}

std::string run_id_of(const ContentReader& file) { return text_attribute(file, fields::file.run); }

void require_same_run(const CheckpointReader& checkpoint, const ResultsReader& results) {
    const std::string saved = run_id_of(checkpoint);
    const std::string found = run_id_of(results);
    if (saved == found && !saved.empty()) return;
    const auto shown = [](const std::string& id) {
        return id.empty() ? std::string("without a run id") : id;
    };
    const std::string folder = folder_of(results.path()).string();
    const bool from_elsewhere = folder_of(checkpoint.path()) != folder_of(results.path());
    const std::string way_on =
        from_elsewhere ? fmt::format("a run goes on from its own checkpoints alone: riffle resume {}", folder)
                       : fmt::format(
                             "files of two runs have been put into one folder. Put back those that belong "
                             "together, or start anew: riffle run CASE -o {} --force",
                             folder);
    throw FileError(fmt::format("{} is of another run ({}) than {} ({}): {}", checkpoint.path().string(),
                                shown(saved), results.path().string(), shown(found), way_on));
}

std::vector<std::string> compare_identity(const CheckpointReader& checkpoint, const Case& c) {
    std::vector<std::string> warnings;
    const std::string inputs = fields::stored_case.inputs.path();
    const auto before = parse_inputs(checkpoint.has(inputs) ? checkpoint.read_string(inputs) : "");
    for (const InputFile& file : input_files(c)) {
        const auto saved = before.find(fmt::format("{} {}", file.key, file.path.string()));
        const std::string now = checksum_text(file.path);
        if (saved == before.end() || saved->second == now) continue;
        const char* what = now == "- -" ? "that the run began with is gone"
                                        : "is not the file that it was when the run began";
        if (file.needed) {
            throw InputError(
                fmt::format("{} = \"{}\": the file {}, and what is resumed would be another flow. Put the "
                            "earlier file back, or start a new run with this one in another folder",
                            file.key, file.path.string(), what));
        }
        warnings.push_back(fmt::format("{} = \"{}\": the file {}; the run itself does not need it any more",
                                       file.key, file.path.string(), what));
    }
    const auto compare = [&](const Field& field, const char* name, const std::string& now) {
        const std::string then = text_attribute(checkpoint, field);
        if (!then.empty() && then != now) {
            warnings.push_back(fmt::format(
                "the run was begun with the {} \"{}\" and goes on with \"{}\": the flow is the same, "
                "its last bits are not",
                name, then, now));
        }
    };
    compare(fields::file.build, "build", build_description());
    compare(fields::file.instruction_set, "instruction set", instruction_set_name(active_instruction_set()));
    return warnings;
}

}  // namespace riffle::inline solver

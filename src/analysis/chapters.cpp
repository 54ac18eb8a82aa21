#include "analysis/chapters.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <vector>

#include "analysis/chapter_names.hpp"
#include "base/error.hpp"

namespace riffle::inline analysis {

std::span<const Chapter> analysis_chapters() {
    const auto uniform = [](FlowKind kind) { return kind == FlowKind::uniform_channel; };
    static const std::array chapters = {
        Chapter{chapters::course, "Course of the flow", analyse_course, is_undriven},
        Chapter{chapters::along, "Along the channel", analyse_along, varies_along},
        Chapter{chapters::statistics, "Statistics of the record", analyse_statistics, is_channel},
        Chapter{chapters::profiles, "Profiles", analyse_profiles},
        Chapter{chapters::fits, "Laws fitted to the velocity profile", analyse_fits, uniform},
        Chapter{chapters::surface, "Free surface", analyse_surface, is_channel},
        Chapter{chapters::subsurface, "Velocities below the surface", analyse_subsurface, is_channel},
        Chapter{chapters::forces, "Forces", analyse_forces},
        Chapter{chapters::energy, "Energy", analyse_energy},
        Chapter{chapters::section, "Cross-section", analyse_section},
        Chapter{chapters::secondary, "Secondary flow", analyse_secondary, is_channel},
        Chapter{chapters::bed, "Bed and side walls", analyse_bed, uniform},
        Chapter{chapters::particles, "Particles", analyse_particles},
    };
    return chapters;
}

bool applies(const Chapter& chapter, const FlowRecord& record) {
    // Of a laboratory record each chapter finds for itself what it has.
    const bool run = record.origin() == Origin::simulated && record.flow() != nullptr;
    return !run || chapter.applies == nullptr || chapter.applies(flow_kind(*record.flow()));
}

Analysis analyse(const FlowRecord& record, const std::string& chapter) {
    const std::span<const Chapter> chapters = analysis_chapters();
    const auto named = std::find_if(chapters.begin(), chapters.end(),
                                    [&](const Chapter& each) { return each.name == chapter; });
    if (!chapter.empty() && named == chapters.end()) {
        std::vector<std::string> names;
        for (const Chapter& each : chapters) names.push_back(each.name);
        throw InputError(fmt::format("--chapter {}: there is no such chapter; the chapters are {}", chapter,
                                     fmt::join(names, ", ")));
    }
    Analysis analysis;
    analysis.name = record.name();
    analysis.source = record.source();
    for (const Chapter& each : chapters) {
        if (chapter.empty() ? !applies(each, record) : each.name != chapter) continue;
        if (!applies(each, record)) {
            analysis.warnings.push_back(fmt::format(
                "the chapter {} is made for other flows than a {}: what it finds may mean nothing here",
                each.name, flow_kind_name(flow_kind(*record.flow()))));
        }
        each.analyse(record, analysis);
    }
    for (const std::string& warning : record.warnings()) analysis.warnings.push_back(warning);
    return analysis;
}

}  // namespace riffle::inline analysis

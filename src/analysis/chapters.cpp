#include "analysis/chapters.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <vector>

#include "base/error.hpp"

namespace riffle {

std::span<const Chapter> analysis_chapters() {
    static const std::array chapters = {
        Chapter{"statistics", "Statistics of the velocity", analyse_statistics},
        Chapter{"profiles", "Profiles", analyse_profiles},
        Chapter{"fits", "Laws fitted to the velocity profile", analyse_fits},
        Chapter{"surface", "Free surface", analyse_surface},
        Chapter{"subsurface", "Velocities below the surface", analyse_subsurface},
        Chapter{"forces", "Forces", analyse_forces},
        Chapter{"section", "Cross-section", analyse_section},
        Chapter{"secondary", "Secondary flow", analyse_secondary},
        Chapter{"bed", "Bed and side walls", analyse_bed},
    };
    return chapters;
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
        if (chapter.empty() || each.name == chapter) each.analyse(record, analysis);
    }
    for (const std::string& warning : record.warnings()) analysis.warnings.push_back(warning);
    return analysis;
}

}  // namespace riffle

#include "case/case_check.hpp"

#include <set>

namespace riffle::inline case_file {

void for_each_finding(const CheckList& list, const Case& c,
                      const std::function<void(const CaseCheck&, const CaseFinding&)>& take) {
    if (!list.concerns(c)) return;
    bool decided = false;
    std::set<std::size_t> decided_items;
    for (const CaseCheck& check : list.checks) {
        const bool whole = !check.condition.of_items();
        if (decided || (whole && !decided_items.empty())) continue;
        for (std::size_t item = 0; item < check.condition.count(c); ++item) {
            if (decided_items.contains(item)) continue;
            const Findings findings = check.condition.findings(c, item);
            for (const CaseFinding& finding : findings) take(check, finding);
            if (check.decides && !findings.empty()) {
                decided = whole;
                decided_items.insert(item);
            }
        }
    }
}

std::string finding_text(const std::string& detail, const CaseCheck& check, const CaseFinding& finding) {
    std::string text = detail;
    const auto add = [&](const char* separator, std::string_view part) {
        text += text.empty() || part.empty() ? "" : separator;
        text += part;
    };
    add(": ", check.why);
    add("; ", finding.cure.empty() ? check.cure : std::string_view(finding.cure));
    return text;
}

}  // namespace riffle::inline case_file

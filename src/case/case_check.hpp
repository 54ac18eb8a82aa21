#pragma once

#include <fmt/format.h>

#include <concepts>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "case/case.hpp"

namespace riffle::inline case_file {

/// What a check finds in a case.
struct CaseFinding {
    std::string detail;     ///< "spacing is 12 mm, larger than ..."; empty: the values of the check's keys
    std::string key = {};   ///< of which key, where the check looks at several; empty: of the first
    std::string cure = {};  ///< what to do, with numbers of the case; empty: what the check says
    std::size_t item = 0;   ///< in which of the sections of the key's name
    std::string name = {};  ///< of that section, where messages call it by its name
};
using Findings = std::vector<CaseFinding>;

/// One finding with this detail, or none.
template <class... Args>
[[nodiscard]] Findings found_if(bool wrong, fmt::format_string<Args...> detail, Args&&... args) {
    return wrong ? Findings{{.detail = fmt::format(detail, std::forward<Args>(args)...)}} : Findings{};
}

/// When a check finds something: a function of the case, or of the case and each of its probes, solids,
/// patches of the bed, of surfaces or of vegetation, or porous zones, that returns what it finds, or only
/// whether it finds something.
class CheckCondition {
  public:
    template <class F>
    requires(!std::same_as<F, CheckCondition>) CheckCondition(F look) {
        if constexpr (std::invocable<F, const Case&>) {
            look_ = [look](const Case& c, std::size_t) { return as_findings(look(c)); };
        } else if constexpr (std::invocable<F, const Case&, const Probe&>) {
            bind(&Case::probes, look);
        } else if constexpr (std::invocable<F, const Case&, const BedPatch&>) {
            bind(&Case::bed_patches, look);
        } else if constexpr (std::invocable<F, const Case&, const SurfacePatch&>) {
            bind(&Case::surface_patches, look);
        } else if constexpr (std::invocable<F, const Case&, const Vegetation&>) {
            bind(&Case::vegetation, look);
        } else if constexpr (std::invocable<F, const Case&, const Porous&>) {
            bind(&Case::porous, look);
        } else {
            bind(&Case::solids, look);
        }
    }

    /// Whether it looks at each section of a name, and not at the case as a whole.
    [[nodiscard]] bool of_items() const { return static_cast<bool>(count_); }
    /// How often it looks.
    [[nodiscard]] std::size_t count(const Case& c) const { return count_ ? count_(c) : 1; }
    /// What it finds, where it looks at sections in that `item`.
    [[nodiscard]] Findings findings(const Case& c, std::size_t item) const { return look_(c, item); }

  private:
    static Findings as_findings(bool wrong) { return Findings(wrong ? 1 : 0); }
    static Findings as_findings(Findings found) { return found; }

    template <class Item, class F>
    void bind(std::vector<Item> Case::*items, const F& look) {
        count_ = [items](const Case& c) { return (c.*items).size(); };
        look_ = [items, look](const Case& c, std::size_t item) {
            Findings found = as_findings(look(c, (c.*items)[item]));
            for (CaseFinding& finding : found) {
                finding.item = item;
                if constexpr (!std::same_as<Item, Probe>) {  // which messages call by their names
                    finding.name = (c.*items)[item].name;
                    if (!finding.detail.empty() && !finding.name.empty()) {
                        finding.detail.insert(0, finding.name + ": ");
                    }
                }
            }
            return found;
        };
    }

    std::function<std::size_t(const Case&)> count_;
    std::function<Findings(const Case&, std::size_t)> look_;
};

/// A check of a case: the row from which the message of a case that fails it and the reference of the case
/// file are made.
struct CaseCheck {
    std::vector<std::string> keys;  ///< that it looks at; a message points to the first one that was given
    std::string_view what;          ///< it finds, in words
    std::string_view why;           ///< why that is wrong; empty where that is plain
    std::string_view cure;          ///< what to do
    CheckCondition condition;
    bool decides =
        false;  ///< where it finds something, the checks below it in its list have nothing to look at
};

/// Checks of one subject.
struct CheckList {
    std::vector<CaseCheck> checks;
    bool (*concerns)(const Case&) = [](const Case&) {
        return true;
    };  ///< whether they look at the case at all
};

/// Calls take(check, finding) with all that the checks of a list find in a case.
void for_each_finding(const CheckList& list, const Case& c,
                      const std::function<void(const CaseCheck&, const CaseFinding&)>& take);

/// "detail: why; cure".
[[nodiscard]] std::string finding_text(const std::string& detail, const CaseCheck& check,
                                       const CaseFinding& finding);

}  // namespace riffle::inline case_file

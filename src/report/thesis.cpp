#include "report/thesis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "case/flow_conditions.hpp"

namespace riffle {

namespace {

/// The uniform flows of Table 3.1, all that the thesis simulated in two dimensions.
constexpr std::array<int, 7> conditions = {1, 2, 3, 5, 6, 7, 8};
/// Those that the thesis computed with the original SPS closure, too.
constexpr std::array<int, 2> closure_conditions = {3, 6};

/// Settings of a run with the SPS closure, which has no steady column to start from and does not settle soon.
constexpr const char* sps_settings =
    "--set turbulence.closure=sps --set start.kind=uniform --set start.velocity=0.4 "
    "--set numerics.sound_speed=12 --set run.until='\"10 s\"'";

enum class Part { condition, sps, paper, paper_sps, other };

struct Place {
    Part part = Part::other;
    int condition = 0;
};

/// The paper's bed: its spheres of 24 mm and its form of the drag.
bool is_paper(const Case& c) {
    const Case paper = builtin_case("paper-2016");
    return c.bed.drag_form == paper.bed.drag_form && c.bed.sphere_diameter == paper.bed.sphere_diameter;
}

Place place_of(const ComparedRun& compared) {
    if (!compared.run) return {};
    const Case& c = compared.run->flow;
    const bool sps = c.turbulence.closure == ClosureKind::sps;
    if (is_paper(c)) return {sps ? Part::paper_sps : Part::paper, 0};
    if (const auto number = flow_condition_of(c); number && c.stirring.acceleration == 0) {
        return {sps ? Part::sps : Part::condition, *number};
    }
    return {};
}

class Chapter {
  public:
    explicit Chapter(Comparison comparison) : comparison_(std::move(comparison)) {
        for (const ComparedRun& run : comparison_.runs) places_.push_back(place_of(run));
    }

    Comparison take() {
        comparison_.sets.clear();
        add_conditions();
        add_closures();
        add_spacings();
        add_paper();
        add_others();
        for (ComparedSet& set : comparison_.sets) set.names = names_among(comparison_.runs, set.members);
        return std::move(comparison_);
    }

  private:
    [[nodiscard]] std::vector<std::size_t> runs_of(Part part, int condition = 0) const {
        std::vector<std::size_t> members;
        for (std::size_t i = 0; i < places_.size(); ++i) {
            if (places_[i].part == part && places_[i].condition == condition) members.push_back(i);
        }
        return members;
    }

    /// Of several runs of one flow the one with the case's own spacing, else the first.
    [[nodiscard]] std::optional<std::size_t> chosen(int condition) const {
        const std::vector<std::size_t> members = runs_of(Part::condition, condition);
        if (members.empty()) return std::nullopt;
        const double usual = builtin_case(fmt::format("condition-{}", condition)).numerics.spacing;
        const auto found = std::find_if(members.begin(), members.end(), [&](std::size_t i) {
            return comparison_.runs[i].run->flow.numerics.spacing == usual;
        });
        return found == members.end() ? members.front() : *found;
    }

    void miss(std::string what, const std::string& arguments) {
        comparison_.missing.push_back({std::move(what), "riffle run " + arguments});
    }

    void add_conditions() {
        ComparedSet set;
        set.title = "The flow conditions";
        set.side_by_side = true;
        for (const int number : conditions) {
            if (const auto run = chosen(number)) {
                set.members.push_back(*run);
            } else {
                miss(fmt::format("flow condition {}", number),
                     fmt::format("cases/rough-bed-2d/condition-{}.toml", number));
            }
        }
        if (!set.members.empty()) comparison_.sets.push_back(std::move(set));
    }

    void add_closures() {
        for (const int number : conditions) {
            const std::vector<std::size_t> members = runs_of(Part::sps, number);
            if (members.empty()) {
                if (std::count(closure_conditions.begin(), closure_conditions.end(), number) > 0) {
                    miss(fmt::format("flow condition {} with the original SPS closure", number),
                         fmt::format("cases/rough-bed-2d/condition-{}.toml {}", number, sps_settings));
                }
                continue;
            }
            ComparedSet set;
            set.title = fmt::format("Condition {}: original SPS against the mixing length", number);
            set.introduction =
                "The SPS closure with its constant filter width gives far too small a stress (thesis, "
                "chapter "
                "4): the flow accelerates until the bed's drag alone balances the weight.";
            if (const auto run = chosen(number)) set.members.push_back(*run);
            set.members.insert(set.members.end(), members.begin(), members.end());
            set.chapters = {"statistics", "profiles"};
            comparison_.sets.push_back(std::move(set));
        }
    }

    void add_spacings() {
        for (const int number : conditions) {
            const std::vector<std::size_t> members = runs_of(Part::condition, number);
            if (members.size() < 2) continue;
            ComparedSet set;
            set.title = fmt::format("Condition {}: its runs compared", number);
            set.introduction =
                "Runs of the same flow that differ in particle spacing or other numerics: what changes with "
                "them is the error of the method.";
            set.members = members;
            set.chapters = {"statistics", "profiles"};
            comparison_.sets.push_back(std::move(set));
        }
    }

    void add_paper() {
        ComparedSet set;
        set.title = "The paper of 2016";
        set.introduction =
            "The case of the paper, with its mixing length of Nezu and Rodi and its bed drag, against its "
            "run "
            "with the SPS closure: its Figs 2 to 4, profiles of velocity and of shear stress.";
        set.members = runs_of(Part::paper);
        if (set.members.empty()) miss("the paper's case", "cases/paper-2016.toml");
        const std::vector<std::size_t> sps = runs_of(Part::paper_sps);
        if (sps.empty()) {
            miss("the paper's case with the SPS closure",
                 fmt::format("cases/paper-2016.toml {} --set turbulence.smagorinsky_constant=0.15",
                             sps_settings));
        }
        set.members.insert(set.members.end(), sps.begin(), sps.end());
        set.chapters = {"statistics", "profiles", "fits"};
        if (!set.members.empty()) comparison_.sets.push_back(std::move(set));
    }

    void add_others() {
        ComparedSet set;
        set.title = "Other runs and records";
        set.members = runs_of(Part::other);
        const std::vector<std::size_t> fourth = runs_of(Part::condition, 4);
        set.members.insert(set.members.end(), fourth.begin(), fourth.end());
        if (!set.members.empty()) comparison_.sets.push_back(std::move(set));
    }

    Comparison comparison_;
    std::vector<Place> places_;
};

}  // namespace

Comparison thesis_chapter(const std::vector<ReportSubject>& subjects) {
    Comparison comparison = compare(subjects);
    comparison.title = "Turbulent flow over rough beds in two dimensions";
    comparison.introduction =
        "The figures of the thesis' chapter on two-dimensional simulations, and of the paper of 2016, from "
        "the "
        "runs named below. Flow condition 4 was not uniform; the thesis dropped it.";
    return Chapter(std::move(comparison)).take();
}

}  // namespace riffle

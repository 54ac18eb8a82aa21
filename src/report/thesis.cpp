#include "report/thesis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "case/flow_conditions.hpp"

namespace riffle::inline report {

namespace {

/// The uniform flows of Table 3.1, all that the thesis simulated in two dimensions.
constexpr std::array<int, 7> conditions = {1, 2, 3, 5, 6, 7, 8};
/// Those that it simulated in three dimensions.
constexpr std::array<int, 4> space_conditions = {1, 2, 5, 8};
/// Those with two spacings (Figs 4.13, 5.18), and with the original SPS closure (Figs 4.14, 6.1).
constexpr std::array<int, 2> plane_pairs = {3, 6};
constexpr std::array<int, 2> space_pairs = {2, 5};
constexpr int space_sps = 5;
/// Those with two heights of the roughness (Fig. 5.15).
constexpr int space_heights = 1;

/// Settings of a run with the SPS closure, which has no steady flow to start from and does not settle soon.
constexpr const char* sps_settings =
    "--set turbulence.closure=sps --set start.kind=uniform --set start.velocity=0.4 "
    "--set numerics.sound_speed=12 --set run.until='\"10 s\"'";

enum class Kind { flow, sps, paper, paper_sps, other };

/// Which of the thesis' runs one is.
struct Place {
    Kind kind = Kind::other;
    int condition = 0;
    int dimensions = 2;
    bool operator==(const Place&) const = default;
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
    const bool space = c.channel.dimensions == 3;
    if (is_paper(c) && !space) return {sps ? Kind::paper_sps : Kind::paper, 0, 2};
    const auto number = flow_condition_of(c);
    const bool wide = space && c.channel.sides == Sides::periodic;
    if (!number || wide || c.stirring.acceleration != 0) return {};
    return {sps ? Kind::sps : Kind::flow, *number, c.channel.dimensions};
}

Case usual_case(int condition, int dimensions) {
    return builtin_case(fmt::format("condition-{}{}", condition, dimensions == 3 ? "-3d" : ""));
}

std::string file_of(int condition, int dimensions) {
    return fmt::format("cases/rough-bed-{}d/condition-{}.toml", dimensions, condition);
}

class Thesis {
  public:
    Thesis(Comparison comparison, std::set<ThesisPart> parts)
        : comparison_(std::move(comparison)), parts_(std::move(parts)) {
        for (const ComparedRun& run : comparison_.runs) places_.push_back(place_of(run));
        everything_ = parts_.empty();
        if (everything_) parts_ = parts_of_runs();
    }

    Comparison take() {
        comparison_.sets.clear();
        if (parts_.contains(ThesisPart::two_dimensions)) {
            add_conditions(2, conditions, "Chapter 4: the flow conditions in two dimensions");
            for (const int number : conditions) add_closures(number);
            add_spacings(2, conditions, plane_pairs);
        }
        if (parts_.contains(ThesisPart::paper)) add_paper();
        if (parts_.contains(ThesisPart::three_dimensions)) {
            add_conditions(3, space_conditions, "Chapter 5: the flow conditions in three dimensions");
            add_spacings(3, space_conditions, space_pairs);
            for (const int number : space_conditions) add_heights(number);
        }
        if (parts_.contains(ThesisPart::both)) {
            for (const int number : space_conditions) add_dimensions(number);
            add_space_closure();
        }
        if (everything_) {
            add_others();
        } else {
            leave_out_unused();
        }
        for (ComparedSet& set : comparison_.sets) set.names = names_among(comparison_.runs, set.members);
        return std::move(comparison_);
    }

  private:
    [[nodiscard]] std::set<ThesisPart> parts_of_runs() const {
        const auto any = [&](auto&& holds) { return std::any_of(places_.begin(), places_.end(), holds); };
        const auto is_flow = [](const Place& p) { return p.kind == Kind::flow || p.kind == Kind::sps; };
        const bool plane = any([&](const Place& p) { return is_flow(p) && p.dimensions == 2; });
        const bool space = any([&](const Place& p) { return is_flow(p) && p.dimensions == 3; });
        const bool paper =
            any([](const Place& p) { return p.kind == Kind::paper || p.kind == Kind::paper_sps; });
        std::set<ThesisPart> parts;
        if (plane) parts.insert({ThesisPart::two_dimensions, ThesisPart::paper});
        if (paper) parts.insert(ThesisPart::paper);
        if (space) parts.insert(ThesisPart::three_dimensions);
        if (plane && space) parts.insert(ThesisPart::both);
        if (parts.empty()) parts.insert(ThesisPart::two_dimensions);
        return parts;
    }

    [[nodiscard]] const Case& flow(std::size_t run) const { return comparison_.runs[run].run->flow; }

    [[nodiscard]] std::vector<std::size_t> runs_at(const Place& place) const {
        std::vector<std::size_t> members;
        for (std::size_t i = 0; i < places_.size(); ++i) {
            if (places_[i] == place) members.push_back(i);
        }
        return members;
    }

    /// Runs of a flow whose roughness has the case's own height, or all the others.
    [[nodiscard]] std::vector<std::size_t> flows(int condition, int dimensions, bool usual_height) const {
        std::vector<std::size_t> members = runs_at({Kind::flow, condition, dimensions});
        const double height = usual_case(condition, dimensions).bed.roughness_height;
        std::erase_if(members, [&](std::size_t i) {
            return (std::abs(flow(i).bed.roughness_height - height) < 1e-9) != usual_height;
        });
        return members;
    }

    /// Of several runs of one flow the one whose spacing is nearest to the case's own.
    [[nodiscard]] std::optional<std::size_t> chosen(int condition, int dimensions) const {
        std::vector<std::size_t> members = flows(condition, dimensions, true);
        if (members.empty()) members = flows(condition, dimensions, false);
        if (members.empty()) return std::nullopt;
        const double usual = usual_case(condition, dimensions).numerics.spacing;
        return *std::min_element(members.begin(), members.end(), [&](std::size_t a, std::size_t b) {
            return std::abs(flow(a).numerics.spacing - usual) < std::abs(flow(b).numerics.spacing - usual);
        });
    }

    void miss(std::string what, const std::string& arguments) {
        comparison_.missing.push_back({std::move(what), "riffle run " + arguments});
    }

    template <class Numbers>
    void add_conditions(int dimensions, const Numbers& numbers, const char* title) {
        ComparedSet set;
        set.title = title;
        set.side_by_side = true;
        for (const int number : numbers) {
            if (const auto run = chosen(number, dimensions)) {
                set.members.push_back(*run);
            } else {
                miss(
                    fmt::format("flow condition {}{}", number, dimensions == 3 ? " in three dimensions" : ""),
                    file_of(number, dimensions));
            }
        }
        if (!set.members.empty()) comparison_.sets.push_back(std::move(set));
    }

    void add_closures(int number) {
        const std::vector<std::size_t> members = runs_at({Kind::sps, number, 2});
        if (members.empty()) {
            if (std::count(plane_pairs.begin(), plane_pairs.end(), number) > 0) {
                miss(fmt::format("flow condition {} with the original SPS closure", number),
                     file_of(number, 2) + " " + sps_settings);
            }
            return;
        }
        ComparedSet set;
        set.title = fmt::format("Condition {}: original SPS against the mixing length", number);
        set.introduction =
            "The SPS closure with its constant filter width gives far too small a stress (thesis, chapter "
            "4): the flow accelerates until the bed's drag alone balances the weight.";
        if (const auto run = chosen(number, 2)) set.members.push_back(*run);
        set.members.insert(set.members.end(), members.begin(), members.end());
        set.chapters = {"statistics", "profiles"};
        comparison_.sets.push_back(std::move(set));
    }

    template <class Numbers, class Pairs>
    void add_spacings(int dimensions, const Numbers& numbers, const Pairs& pairs) {
        for (const int number : numbers) {
            std::vector<std::size_t> members = flows(number, dimensions, true);
            if (members.size() < 2) {
                if (std::count(pairs.begin(), pairs.end(), number) > 0) {
                    const double spacing = usual_case(number, dimensions).numerics.spacing;
                    miss(fmt::format("flow condition {}{} at a second spacing", number,
                                     dimensions == 3 ? " in three dimensions" : ""),
                         fmt::format("{} --set numerics.spacing={:.3g}mm", file_of(number, dimensions),
                                     spacing * (dimensions == 3 ? 1.2e3 : 0.8e3)));
                }
                continue;
            }
            ComparedSet set;
            set.title = fmt::format("Condition {}{}: its runs compared", number,
                                    dimensions == 3 ? " in three dimensions" : "");
            set.introduction =
                "Runs of the same flow that differ in particle spacing or other numerics: what changes with "
                "them is the error of the method.";
            set.members = std::move(members);
            set.chapters = {"statistics", "profiles"};
            comparison_.sets.push_back(std::move(set));
        }
    }

    void add_heights(int number) {
        ComparedSet set;
        set.members = flows(number, 3, false);
        const auto usual = chosen(number, 3);
        if (set.members.empty()) {
            if (number == space_heights && usual) {
                miss(fmt::format("flow condition {} in three dimensions with another height of the roughness",
                                 number),
                     file_of(number, 3) + " --set bed.roughness_height='\"0.32 D\"'");
            }
            return;
        }
        if (usual && *usual != set.members.front()) set.members.insert(set.members.begin(), *usual);
        if (set.members.size() < 2) return;
        set.title = fmt::format("Condition {} in three dimensions: heights of the roughness", number);
        set.introduction =
            "The height of the roughness decides how much of a sphere takes drag: the thesis lowered it "
            "until the velocity met the measured one.";
        set.chapters = {"statistics", "profiles"};
        comparison_.sets.push_back(std::move(set));
    }

    /// Chapter 6: one flow in two and in three dimensions.
    void add_dimensions(int number) {
        const auto plane = chosen(number, 2);
        const auto space = chosen(number, 3);
        if (!plane || !space) {
            if (plane || space) {
                miss(fmt::format("flow condition {} in {} dimensions", number, plane ? "three" : "two"),
                     file_of(number, plane ? 3 : 2));
            }
            return;
        }
        ComparedSet set;
        set.title = fmt::format("Chapter 6: condition {} in two and in three dimensions", number);
        set.introduction =
            "Of the flow in three dimensions the profiles are those of the centreline, where side walls "
            "leave the flow as it is in a wide channel.";
        set.members = {*plane, *space};
        set.chapters = {"statistics", "profiles", "surface", "subsurface"};
        comparison_.sets.push_back(std::move(set));
    }

    void add_space_closure() {
        ComparedSet set;
        for (const int number : space_conditions) {
            const std::vector<std::size_t> space = runs_at({Kind::sps, number, 3});
            if (space.empty()) continue;
            const std::vector<std::size_t> plane = runs_at({Kind::sps, number, 2});
            set.title = fmt::format(
                "Chapter 6: condition {} with the original SPS closure, in two and in three dimensions",
                number);
            set.introduction =
                "The stress of the SPS closure is a small part of the weight of the water in either: the "
                "flow is not steady, and gathers speed while the bed's drag takes over.";
            set.members = plane;
            set.members.insert(set.members.end(), space.begin(), space.end());
            set.chapters = {"statistics", "profiles"};
            comparison_.sets.push_back(set);
        }
        if (set.members.empty()) {
            miss(
                fmt::format("flow condition {} in three dimensions with the original SPS closure", space_sps),
                file_of(space_sps, 3) + " --set turbulence.closure=sps --set numerics.sound_speed=12");
        }
    }

    void add_paper() {
        ComparedSet set;
        set.title = "The paper of 2016";
        set.introduction =
            "The case of the paper, with its mixing length of Nezu and Rodi and its bed drag, against its "
            "run with the SPS closure: its Figs 2 to 4, the drag over the height, the mixing length, and "
            "the profiles of velocity and of shear stress.";
        set.members = runs_at({Kind::paper, 0, 2});
        if (set.members.empty()) miss("the paper's case", "cases/paper-2016.toml");
        const std::vector<std::size_t> sps = runs_at({Kind::paper_sps, 0, 2});
        if (sps.empty()) {
            miss("the paper's case with the SPS closure",
                 fmt::format("cases/paper-2016.toml {} --set turbulence.smagorinsky_constant=0.15",
                             sps_settings));
        }
        set.members.insert(set.members.end(), sps.begin(), sps.end());
        set.chapters = {"statistics", "profiles", "fits"};
        if (!set.members.empty()) comparison_.sets.push_back(std::move(set));
    }

    /// Runs that no set shows.
    [[nodiscard]] std::vector<std::size_t> unused() const {
        std::vector<std::size_t> members;
        for (std::size_t i = 0; i < places_.size(); ++i) {
            const bool shown =
                std::any_of(comparison_.sets.begin(), comparison_.sets.end(), [i](const ComparedSet& set) {
                    return std::count(set.members.begin(), set.members.end(), i) > 0;
                });
            if (!shown) members.push_back(i);
        }
        return members;
    }

    void add_others() {
        ComparedSet set;
        set.title = "Other runs and records";
        set.members = unused();
        if (!set.members.empty()) comparison_.sets.push_back(std::move(set));
    }

    void leave_out_unused() {
        const std::vector<std::size_t> members = unused();
        std::vector<ComparedRun> kept;
        std::vector<std::size_t> number(places_.size());
        for (std::size_t i = 0; i < places_.size(); ++i) {
            if (std::count(members.begin(), members.end(), i) > 0) continue;
            number[i] = kept.size();
            kept.push_back(std::move(comparison_.runs[i]));
        }
        if (kept.empty()) {
            throw InputError(fmt::format(
                "none of the {} runs given is of the part of the thesis asked for; leave the part out to see "
                "which parts they are of",
                places_.size()));
        }
        comparison_.runs = std::move(kept);
        comparison_.differences = differences_of(comparison_.runs);
        for (ComparedSet& set : comparison_.sets) {
            for (std::size_t& member : set.members) member = number[member];
        }
    }

    Comparison comparison_;
    std::set<ThesisPart> parts_;
    bool everything_ = false;
    std::vector<Place> places_;
};

}  // namespace

std::optional<ThesisPart> thesis_part(std::string_view word) {
    if (word == "4") return ThesisPart::two_dimensions;
    if (word == "5") return ThesisPart::three_dimensions;
    if (word == "6") return ThesisPart::both;
    if (word == "paper") return ThesisPart::paper;
    return std::nullopt;
}

Comparison thesis_figures(const std::vector<ReportSubject>& subjects, const std::set<ThesisPart>& parts) {
    Comparison comparison = compare(subjects);
    comparison.title = "Turbulent flow over rough beds in two and three dimensions";
    comparison.introduction =
        "The figures of the thesis' chapters on simulations, and of the paper of 2016, from the runs named "
        "below. Flow condition 4 was not uniform; the thesis dropped it.";
    return Thesis(std::move(comparison), parts).take();
}

}  // namespace riffle::inline report

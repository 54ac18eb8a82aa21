#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/figure_tools.hpp"
#include "sweep/study_files.hpp"

namespace riffle::inline sweep {

namespace {

constexpr const char* chapter = "sweep";

/// The key along the x axis: the first that refines, else the first number, else the first.
std::size_t main_key(const SweepStudy& sweep) {
    const auto first = [&](const auto& holds) {
        const auto found = std::find_if(sweep.keys.begin(), sweep.keys.end(), [&](const VariedKey& key) {
            return key.variation.values.size() > 1 && holds(key);
        });
        return static_cast<std::size_t>(found - sweep.keys.begin());
    };
    const std::size_t refining = first([](const VariedKey& key) { return key.refines; });
    if (refining < sweep.keys.size()) return refining;
    const std::size_t number = first([](const VariedKey& key) { return key.is_number(); });
    return number < sweep.keys.size() ? number : 0;
}

/// Runs that share the values of all keys but the main one, by increasing x.
struct Family {
    std::string name;
    std::vector<std::size_t> runs;
    std::vector<double> x;
};

std::vector<Family> families_of(const SweepStudy& sweep, std::size_t key) {
    const VariedKey& varied = sweep.keys[key];
    const std::vector<std::string>& values = varied.variation.values;
    std::vector<Family> families;
    for (std::size_t i = 0; i < sweep.runs.size(); ++i) {
        const std::string name = sweep.others(i, key);
        auto family = std::find_if(families.begin(), families.end(),
                                   [&](const Family& other) { return other.name == name; });
        if (family == families.end()) {
            families.push_back({name, {}, {}});
            family = std::prev(families.end());
        }
        family->runs.push_back(i);
    }
    for (std::size_t f = 0; f < families.size(); ++f) {
        Family& family = families[f];
        if (varied.is_number()) {
            std::stable_sort(family.runs.begin(), family.runs.end(), [&](std::size_t a, std::size_t b) {
                return varied.numbers[a] < varied.numbers[b];
            });
        }
        // Beside each other over a name, so that their intervals can be told apart.
        constexpr double apart = 0.12;
        const double aside =
            apart * (static_cast<double>(f) - 0.5 * static_cast<double>(families.size() - 1));
        for (const std::size_t run : family.runs) {
            const auto& value = sweep.runs[run].run.combination.values[key];
            const auto place = std::find(values.begin(), values.end(), value) - values.begin();
            family.x.push_back(varied.is_number() ? varied.numbers[run] : static_cast<double>(place) + aside);
        }
    }
    return families;
}

/// Points of an outcome of a family; runs without it are left out.
Curve curve_of(const SweepStudy& sweep, const Family& family, const Outcome& outcome, Mark mark, int variant,
               bool magnitude) {
    Curve curve;
    curve.name = family.name.empty() ? "simulated" : family.name;
    curve.mark = mark;
    curve.variant = variant;
    bool known = false;
    for (std::size_t i = 0; i < family.runs.size(); ++i) {
        const OutcomeValue found = sweep.runs[family.runs[i]].outcome(outcome.key);
        if (!std::isfinite(found.value) || (magnitude && found.value == 0.0)) continue;
        curve.x.push_back(family.x[i]);
        curve.y.push_back(magnitude ? std::abs(found.value) : found.value);
        curve.y_half_width.push_back(found.half_width);
        known = known || std::isfinite(found.half_width);
    }
    if (!known) curve.y_half_width.clear();
    return curve;
}

/// The twin's values: one curve where all families have the same, else one for each that differs.
std::vector<Curve> twin_curves(const SweepStudy& sweep, const std::vector<Family>& families,
                               const Outcome& outcome, bool number) {
    std::vector<Curve> twins;
    for (const Family& family : families) {
        Curve twin = make_curve("twin", Origin::column, number ? Mark::line : Mark::points, {}, {});
        for (std::size_t i = 0; i < family.runs.size(); ++i) {
            const double value = sweep.runs[family.runs[i]].outcome(outcome.key).twin;
            if (std::isfinite(value)) {
                twin.x.push_back(family.x[i]);
                twin.y.push_back(value);
            }
        }
        const bool there = std::any_of(twins.begin(), twins.end(), [&](const Curve& other) {
            return twin.x == other.x && twin.y == other.y;
        });
        if (twin.x.empty() || there) continue;
        if (!number && !twins.empty()) {
            // Over names each family has its own places, so that one name will do.
            twins.front().x.insert(twins.front().x.end(), twin.x.begin(), twin.x.end());
            twins.front().y.insert(twins.front().y.end(), twin.y.begin(), twin.y.end());
            continue;
        }
        twin.run = family.name;
        twin.variant = static_cast<int>(twins.size());
        twins.push_back(std::move(twin));
    }
    for (Curve& twin : twins) {
        if (twins.size() > 1) twin.name += ", " + twin.run;
        twin.run.clear();
    }
    return twins;
}

const RefinementStudy* find_study(const SweepStudy& sweep, const std::string& key, const std::string& outcome,
                                  const std::string& others) {
    const auto found =
        std::find_if(sweep.refinements.begin(), sweep.refinements.end(), [&](const RefinementStudy& study) {
            return study.key == key && study.outcome == outcome && study.others == others;
        });
    return found == sweep.refinements.end() ? nullptr : &*found;
}

std::string in_family(const std::string& text, const Family& family) {
    return family.name.empty() ? text : fmt::format("{}, {}", text, family.name);
}

/// Richardson's limits of the families, at size zero.
void add_limits(const SweepStudy& sweep, const VariedKey& key, const std::vector<Family>& families,
                const Outcome& outcome, Figure& figure) {
    for (std::size_t f = 0; f < families.size(); ++f) {
        const RefinementStudy* const study =
            find_study(sweep, key.variation.key, outcome.key, families[f].name);
        if (study == nullptr || !study->convergence || !study->convergence->limit) continue;
        const GridConvergence& found = *study->convergence;
        Curve limit = make_curve(in_family(fmt::format("limit, order {:.2f}", *found.order), families[f]),
                                 Origin::fit, Mark::points, {0.0}, {*found.limit}, static_cast<int>(f));
        if (found.limit_half_width) {
            limit.y_half_width = {*found.limit_half_width};
        }
        figure.curves.push_back(std::move(limit));
    }
}

Figure outcome_figure(const SweepStudy& sweep, std::size_t main, const std::vector<Family>& families,
                      const Outcome& outcome) {
    const VariedKey& key = sweep.keys[main];
    const bool number = key.is_number();
    Figure figure = make_figure(
        chapter, "sweep_" + outcome.key, fmt::format("{} against {}", outcome.label, key.label),
        number && key.refines ? "Bars: 95 % intervals, where known; at zero Richardson's limit, where the "
                                "three finest values converge monotonically."
                              : "Bars: 95 % intervals, where known.",
        "", make_axis(key.label, number ? key.unit : "1"), make_axis(outcome.label, outcome.unit));
    figure.curves = twin_curves(sweep, families, outcome, number);
    for (std::size_t f = 0; f < families.size(); ++f) {
        figure.curves.push_back(curve_of(sweep, families[f], outcome,
                                         number ? Mark::line_and_points : Mark::points, static_cast<int>(f),
                                         false));
    }
    add_limits(sweep, key, families, outcome, figure);
    return figure;
}

/// |departure| or cost on logarithmic axes with the fitted power laws.
Figure logarithmic_figure(const SweepStudy& sweep, std::size_t main, const std::vector<Family>& families,
                          const Outcome& outcome) {
    const VariedKey& key = sweep.keys[main];
    const bool cost = outcome.kind == OutcomeKind::cost;
    Figure figure =
        make_figure(chapter, "sweep_" + outcome.key + "_order",
                    fmt::format("{} against {}, on logarithmic axes", outcome.label, key.label),
                    fmt::format("The line is the power law fitted to all points; its exponent is {}.",
                                cost ? "how the cost grows" : "the order with which the departure vanishes"),
                    "", make_axis(key.label, key.unit, true), make_axis(outcome.label, outcome.unit, true));
    for (std::size_t f = 0; f < families.size(); ++f) {
        Curve points = curve_of(sweep, families[f], outcome, Mark::points, static_cast<int>(f), true);
        const RefinementStudy* const study =
            find_study(sweep, key.variation.key, outcome.key, families[f].name);
        if (study != nullptr && study->power_law && points.x.size() > 1) {
            const PowerLaw& law = *study->power_law;
            std::vector<double> x = {points.x.front(), points.x.back()};
            std::vector<double> y;
            for (const double size : x) y.push_back(law.factor * std::pow(size, law.exponent));
            figure.curves.push_back(make_curve(
                in_family(fmt::format("{} {:.2f}", cost ? "power" : "order", law.exponent), families[f]),
                Origin::simulated, Mark::line, std::move(x), std::move(y), static_cast<int>(f)));
        }
        figure.curves.push_back(std::move(points));
    }
    return figure;
}

}  // namespace

std::vector<std::string> figure_categories(const SweepStudy& sweep) {
    const VariedKey& key = sweep.keys[main_key(sweep)];
    return key.is_number() ? std::vector<std::string>() : key.variation.values;
}

Analysis sweep_figures(const SweepStudy& sweep) {
    Analysis analysis;
    analysis.name = sweep.title;
    analysis.source = sweep.case_file;
    const std::size_t main = main_key(sweep);
    const std::vector<Family> families = families_of(sweep, main);
    for (const Outcome& outcome : sweep.outcomes) {
        const bool logarithmic = sweep.keys[main].refines && outcome.kind != OutcomeKind::value;
        if (outcome.kind != OutcomeKind::cost || !logarithmic) {
            analysis.figures.push_back(outcome_figure(sweep, main, families, outcome));
        }
        if (logarithmic) {
            Figure figure = logarithmic_figure(sweep, main, families, outcome);
            const bool drawn = std::any_of(figure.curves.begin(), figure.curves.end(),
                                           [](const Curve& curve) { return !curve.x.empty(); });
            if (drawn) {  // zeros have no logarithm
                analysis.figures.push_back(std::move(figure));
            }
        }
    }
    return analysis;
}

}  // namespace riffle::inline sweep

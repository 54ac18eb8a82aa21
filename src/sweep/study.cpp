#include "sweep/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "case/overrides.hpp"
#include "particles/lattice.hpp"
#include "solver/run.hpp"

namespace riffle::inline sweep {

namespace {

/// The keys that make the solution finer as they get smaller.
constexpr std::array<std::string_view, 3> refining_keys = {"numerics.spacing", "numerics.time_step",
                                                           "numerics.courant_number"};

/// (area or volume per particle)^(1/dimensions).
double cell_size(const Case& c) {
    const Lattice lattice = lattice_of(c);
    return c.channel.dimensions == 2 ? std::sqrt(lattice.volume()) : std::cbrt(lattice.volume());
}

VariedKey varied_key(const Variation& variation, const std::vector<SweepRun>& runs) {
    VariedKey varied{variation, variation.short_name(), {}, {}, false};
    std::replace(varied.label.begin(), varied.label.end(), '_', ' ');
    const Key* key = nullptr;
    for (const SweepRun& run : runs) {
        // By its name: the sections of another file might stand in another order.
        const KeyItem found = find_option_key(run.flow, variation.key);
        key = found.key;
        if (key == nullptr) {
            return varied;  // the name of a section itself is varied
        }
        const std::optional<double> number = Key::number_of(key->get(run.flow, found.item));
        if (!number || (key->type != ValueType::number && key->type != ValueType::integer)) {
            varied.numbers.clear();
            return varied;
        }
        varied.numbers.push_back(variation.key == "numerics.spacing" ? cell_size(run.flow) : *number);
    }
    if (key == nullptr) return varied;
    varied.unit = key->dimension == Dimension::none ? "1" : std::string(si_unit(key->dimension));
    varied.refines =
        std::find(refining_keys.begin(), refining_keys.end(), variation.key) != refining_keys.end();
    return varied;
}

std::string power_law_finding(const Outcome& outcome, const PowerLaw& law) {
    const std::string exponent =
        fmt::format("{:.2f}", law.exponent) +
        (law.half_width ? fmt::format(" +- {:.2g}", *law.half_width) : std::string());
    return (outcome.kind == OutcomeKind::cost ? "fitted power " : "fitted order of its magnitude ") +
           exponent;
}

/// Orders from half to twice the formal ones of the method. In space those are 1, at the surface and where
/// the drag ends, and 2 inside; in time that of the stepping.
RefinementBounds bounds_of(const std::string& key, const Outcome& outcome, Stepping stepping) {
    double lowest = 1.0;
    double highest = 2.0;
    if (key != "numerics.spacing") {
        // The leapfrog's motion is of second order, its friction of first.
        const bool first = stepping == Stepping::semi_implicit_euler || stepping == Stepping::leapfrog;
        lowest = first ? 1.0 : stepping == Stepping::beeman ? 3.0 : 2.0;
        highest = stepping == Stepping::leapfrog ? 2.0 : lowest;
    }
    return {0.5 * lowest, 2.0 * highest, outcome.magnitude};
}

/// What a refinement shows, from its values.
void conclude(RefinementStudy& study, const Outcome& outcome, Stepping stepping) {
    if (outcome.kind != OutcomeKind::value) {
        study.power_law = fit_power_law(study.values);
        // A departure that changes its sign, or scatters, follows no power of the size.
        // Two runs do not tell whether it does.
        constexpr double widest = 1.0;
        if (outcome.kind == OutcomeKind::departure && study.power_law &&
            !(study.power_law->half_width && *study.power_law->half_width <= widest)) {
            study.power_law.reset();
        }
    }
    if (outcome.kind == OutcomeKind::cost) {
        study.finding = study.power_law ? power_law_finding(outcome, *study.power_law) : "";
        return;
    }
    if (study.values.size() < 3) {
        study.finding = fmt::format("{} complete run{}: an order of convergence needs three",
                                    study.values.size(), study.values.size() == 1 ? "" : "s");
    } else {
        study.convergence = grid_convergence(study.values, bounds_of(study.key, outcome, stepping));
        const GridConvergence& found = *study.convergence;
        study.finding = found.finding;
        const auto or_nan = [](const std::optional<double>& value) { return value.value_or(std::nan("")); };
        const std::string unit = outcome.shown_unit == "1" ? "" : " " + outcome.shown_unit;
        if (found.limit) {
            study.finding += fmt::format(
                ", limit {}{}", value_text(outcome, *found.limit, or_nan(found.limit_half_width)), unit);
        }
        if (found.finest_uncertainty && outcome.kind == OutcomeKind::value) {
            study.finding +=
                fmt::format(", grid convergence index {:.2g} %", 100.0 * found.fine_grid_index.value_or(0.0));
        }
        const bool unknown = std::none_of(study.values.begin(), study.values.end(),
                                          [](const auto& value) { return std::isfinite(value.half_width); });
        study.finding += unknown ? "; sampling error not known" : "";
    }
    if (study.power_law) {
        study.finding += "; " + power_law_finding(outcome, *study.power_law);
    }
}

/// The studies of one outcome along one key, a study for each set of values of the other keys.
void add_refinements(SweepStudy& sweep, std::size_t key, const Outcome& outcome) {
    std::vector<RefinementStudy> studies;
    for (std::size_t i = 0; i < sweep.runs.size(); ++i) {
        const OutcomeValue found = sweep.runs[i].outcome(outcome.key);
        if (!std::isfinite(found.value)) continue;
        const std::string others = sweep.others(i, key);
        auto study = std::find_if(studies.begin(), studies.end(),
                                  [&](const RefinementStudy& s) { return s.others == others; });
        if (study == studies.end()) {
            studies.push_back(
                {sweep.keys[key].variation.key, outcome.key, others, {}, {}, std::nullopt, std::nullopt, {}});
            study = std::prev(studies.end());
        }
        study->runs.push_back(i);
    }
    for (RefinementStudy& study : studies) {
        const std::vector<double>& sizes = sweep.keys[key].numbers;
        std::stable_sort(study.runs.begin(), study.runs.end(),
                         [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
        for (const std::size_t run : study.runs) {
            const OutcomeValue found = sweep.runs[run].outcome(outcome.key);
            study.values.push_back({sizes[run], found.value, found.half_width});
        }
        conclude(study, outcome, sweep.runs[study.runs.front()].run.flow.numerics.stepping);
        sweep.refinements.push_back(std::move(study));
    }
}

}  // namespace

OutcomeValue StudiedRun::outcome(const std::string& key) const {
    const auto found = outcomes.find(key);
    return found == outcomes.end() ? OutcomeValue{} : found->second;
}

std::string SweepStudy::others(std::size_t run, std::size_t but) const {
    std::string text;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (i != but) {
            text += fmt::format("{}{}={}", text.empty() ? "" : ", ", keys[i].variation.short_name(),
                                runs[run].run.combination.values[i]);
        }
    }
    return text;
}

SweepStudy study_sweep(const SweepInput& input, const std::vector<SweepRun>& runs,
                       const std::vector<RunReport>& reports, const std::vector<Outcome>& outcomes,
                       bool only_telling) {
    SweepStudy sweep;
    sweep.case_file = input.case_file.string();
    sweep.title = runs.front().flow.title.empty() ? input.case_file.stem().string() : runs.front().flow.title;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        sweep.runs.push_back({runs[i], reports[i], {}});
        if (sweep.runs.back().complete()) {
            sweep.runs.back().outcomes = read_outcomes(RunFiles{runs[i].folder}.results());
        }
    }
    for (const Variation& variation : input.variations) sweep.keys.push_back(varied_key(variation, runs));
    const auto is_there = [&](const Outcome& outcome) {
        return std::any_of(sweep.runs.begin(), sweep.runs.end(), [&](const StudiedRun& run) {
            const auto found = run.outcomes.find(outcome.key);
            return found != run.outcomes.end() && (!only_telling || found->second.value != 0.0);
        });
    };
    std::copy_if(outcomes.begin(), outcomes.end(), std::back_inserter(sweep.outcomes), is_there);
    for (std::size_t key = 0; key < sweep.keys.size(); ++key) {
        if (!sweep.keys[key].refines || sweep.keys[key].variation.values.size() < 2) continue;
        for (const Outcome& outcome : sweep.outcomes) add_refinements(sweep, key, outcome);
    }
    return sweep;
}

const char* word(RunFate fate) {
    switch (fate) {
        case RunFate::taken:
        case RunFate::done:
            return "complete";
        case RunFate::failed:
        case RunFate::failed_before:
            return "failed";
        case RunFate::stopped:
            return "stopped";
        case RunFate::waiting:
            break;
    }
    return "waiting";
}

std::string value_text(const Outcome& outcome, double value, double half_width) {
    if (!std::isfinite(value)) return "-";
    const double shown = outcome.factor * value;
    const double half = outcome.factor * half_width;
    if (!std::isfinite(half) || half <= 0.0) {
        return fmt::format("{:.4g}", shown);
    }
    if (std::max(std::abs(shown), half) < 1e-3) {
        return fmt::format("{:.2g} +- {:.2g}", shown, half);
    }
    // Two digits of the half-width, and the value to the same place.
    const int place = std::clamp(1 - static_cast<int>(std::floor(std::log10(half))), 0, 12);
    return fmt::format("{:.{}f} +- {:.{}f}", shown, place, half, place);
}

}  // namespace riffle::inline sweep

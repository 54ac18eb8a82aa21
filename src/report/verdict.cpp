#include "report/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace riffle {

namespace {

/// A difference in words: "0.31 % above", "equal to (within 0.05 %)".
std::string against(double value, double reference) {
    const double share = 100 * (value / reference - 1);
    if (std::abs(share) < 0.05) return "within 0.05 % of";
    return fmt::format("{:.{}f} % {}", std::abs(share), std::abs(share) < 10 ? 1 : 0,
                       share > 0 ? "above" : "below");
}

std::string velocity_sentence(const Quantity& mean) {
    const SummaryValue& simulated = *mean.simulated;
    std::string text = fmt::format("The depth-mean velocity above the datum is {:.4g}", simulated.value);
    if (simulated.half_width) text += fmt::format(" ± {:.2g}", *simulated.half_width);
    text += " m/s";
    if (simulated.half_width) text += " (95 % interval)";
    std::string joint = ": ";
    if (mean.measured && mean.measured->value != 0) {
        text += fmt::format("{}{} the measured {:.3g} m/s", joint,
                            against(simulated.value, mean.measured->value), mean.measured->value);
        joint = ", ";
    }
    if (mean.column && mean.column->value != 0) {
        text += fmt::format("{}{} the column twin's {:.4g} m/s", joint,
                            against(simulated.value, mean.column->value), mean.column->value);
    }
    return text + ".";
}

void add_friction(std::vector<std::string>& sentences, const std::vector<Quantity>& quantities) {
    const Quantity* const friction = find_quantity(quantities, "friction_velocity");
    if (friction == nullptr || !friction->simulated) return;
    std::string text = fmt::format("The friction velocity is {:.3g} m/s", friction->simulated->value);
    if (friction->measured) {
        text += fmt::format(", {} the measured {:.3g} m/s",
                            against(friction->simulated->value, friction->measured->value),
                            friction->measured->value);
    }
    const Quantity* const roughness = find_quantity(quantities, "equivalent_roughness");
    if (roughness != nullptr && roughness->simulated) {
        text += fmt::format("; the bed acts with an equivalent roughness of {:.1f} mm",
                            1000 * roughness->simulated->value);
        if (roughness->measured)
            text += fmt::format(" (measured {:.0f} mm)", 1000 * roughness->measured->value);
    }
    sentences.push_back(text + ".");
}

std::string health_sentence(const std::vector<Diagnostic>& diagnostics, Health worst) {
    const auto checks = std::count_if(diagnostics.begin(), diagnostics.end(),
                                      [](const Diagnostic& d) { return d.mark != Health::none; });
    if (worst == Health::good) return fmt::format("All health checks ({}) are in their ranges.", checks);
    std::string list;
    for (const Diagnostic& row : diagnostics) {
        if (row.mark != Health::caution && row.mark != Health::bad) continue;
        std::string label = row.label;
        std::transform(label.begin(), label.begin() + 1, label.begin(),
                       [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
        list +=
            fmt::format("{}{} ({}; healthy: {})", list.empty() ? "" : "; ", label, row.value, row.healthy);
    }
    return "Outside the healthy range: " + list + ".";
}

std::string steady_headline(bool converged, Health worst) {
    const std::string state = converged ? "The run has converged" : "The run has not converged";
    switch (worst) {
        case Health::none:
            return state + "; it was not checked for health.";
        case Health::good:
            return state + (converged ? " and is healthy." : ", but is healthy so far.");
        case Health::caution:
            return state + "; something should be watched.";
        case Health::bad:
            break;
    }
    return state + (converged ? ", but it is not healthy." : " and is not healthy.");
}

}  // namespace

Verdict judge(const ReportData& data, const std::vector<Quantity>& quantities,
              const std::vector<Diagnostic>& diagnostics) {
    Verdict verdict;
    const Quantity* const mean = find_quantity(quantities, "depth_mean_velocity");
    const bool averaged = mean != nullptr && mean->simulated.has_value();
    const double time = has_column(data.series, "time") ? data.series.at("time").back() : 0.0;
    if (!averaged) {
        verdict.headline =
            data.complete ? "The run ended without time averages." : "The run has no time averages yet.";
        if (time > 0)
            verdict.sentences.push_back(fmt::format("It has reached {:.2f} s of simulated time.", time));
        verdict.sentences.emplace_back("What the results file holds so far is shown below.");
        return verdict;
    }

    Health worst = Health::none;
    for (const Diagnostic& row : diagnostics) {
        if (row.mark == Health::none) continue;
        worst = worst == Health::none ? row.mark : std::max(worst, row.mark);
    }
    verdict.mark = worst;
    if (data.flow.channel.slope > 0) {
        const bool converged = find_value(data.summary, "converged").value_or(0.0) != 0.0;
        if (!converged && verdict.mark == Health::good) verdict.mark = Health::caution;
        verdict.headline = steady_headline(converged, worst);
        verdict.sentences.push_back(velocity_sentence(*mean));
        add_friction(verdict.sentences, quantities);
    } else {
        verdict.headline = std::string(data.complete ? "The run is complete" : "The run has not ended") +
                           (worst == Health::bad       ? ", but it is not healthy."
                            : worst == Health::caution ? "; something should be watched."
                                                       : ".");
        verdict.sentences.emplace_back("The bed has no slope, so nothing drives a mean flow in this case.");
    }
    if (worst != Health::none) verdict.sentences.push_back(health_sentence(diagnostics, worst));
    if (!data.flow.measured.uniform) {
        verdict.sentences.emplace_back(
            "The measured flow was not uniform, so the comparison with it is only an indication.");
    }
    if (!data.complete) {
        verdict.sentences.push_back(
            fmt::format("The run had not ended when this report was made ({:.2f} s so far).", time));
    }
    return verdict;
}

}  // namespace riffle

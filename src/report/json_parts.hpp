#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "analysis/figure.hpp"
#include "report/diagnostics.hpp"
#include "report/quantities.hpp"
#include "report/references.hpp"
#include "report/verdict.hpp"

namespace riffle::inline report {

// Parts that the JSON of the pages and of the summaries share. SI; a value that is not finite is null.

using Json = nlohmann::ordered_json;

/// Six significant digits: finer than any figure, and half the size of the page.
[[nodiscard]] Json rounded(double value);

/// All digits.
[[nodiscard]] Json exact(double value);

/// Every `stride`-th value, rounded.
[[nodiscard]] Json array_of(const std::vector<double>& values, std::size_t stride = 1);

/// "good", "caution", "bad" or "none".
[[nodiscard]] const char* word(Health mark);

/// The summary table as rows for the page, with labels, units and digits.
[[nodiscard]] Json quantity_rows(const std::vector<SummaryRow>& quantities);

/// The summary table by key, for machines.
[[nodiscard]] Json quantities_by_key(const std::vector<SummaryRow>& quantities);

[[nodiscard]] Json diagnostics_json(const std::vector<Diagnostic>& diagnostics);

[[nodiscard]] Json verdict_json(const Verdict& verdict);

/// The publications that a page refers to.
[[nodiscard]] Json references_json(const std::vector<Reference>& references);

/// The findings of an analysis, as analysis_to_json writes them.
[[nodiscard]] Json findings_json(const Analysis& analysis);

/// As text; bytes that are no UTF-8 are replaced.
[[nodiscard]] std::string json_text(const Json& json, int indent);

}  // namespace riffle::inline report

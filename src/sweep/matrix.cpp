#include "sweep/matrix.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "base/error.hpp"
#include "column/velocity_measurements.hpp"
#include "solver/run.hpp"

namespace riffle::inline sweep {

namespace {

constexpr const char* form =
    "--vary expects KEY=V1,V2,..., for example --vary numerics.spacing=2mm,1.5mm,1mm";
constexpr std::size_t longest_name = 200;  // file systems allow 255 bytes

std::string trimmed(const std::string& text) {
    const std::size_t from = text.find_first_not_of(" \t");
    return from == std::string::npos ? "" : text.substr(from, text.find_last_not_of(" \t") - from + 1);
}

/// Split at the commas outside quotes and brackets.
std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> parts(1);
    int depth = 0;
    char quote = 0;
    for (const char letter : text) {
        if (quote != 0) {
            quote = letter == quote ? char{0} : quote;
        } else if (letter == '"' || letter == '\'') {
            quote = letter;
        } else if (letter == '[' || letter == ']') {
            depth += letter == '[' ? 1 : -1;
        } else if (letter == ',' && depth == 0) {
            parts.emplace_back();
            continue;
        }
        parts.back() += letter;
    }
    std::transform(parts.begin(), parts.end(), parts.begin(), trimmed);
    return parts;
}

/// A value as part of a folder's name: no quotes, spaces or characters that a shell or file system takes
/// amiss.
std::string in_name(const std::string& value) {
    std::string name;
    for (const char letter : value) {
        const bool plain = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                           (letter >= '0' && letter <= '9') || letter == '.' || letter == '+' ||
                           letter == '-' || letter == '_';
        if (plain) {
            name += letter;
        } else if (letter != '"' && letter != '\'' && letter != ' ') {
            name += '-';
        }
    }
    return name;
}

/// Names of the variations, with their sections where two of them share the rest.
std::vector<std::string> names_of(const std::vector<Variation>& variations) {
    std::map<std::string, int> count;
    for (const Variation& variation : variations) ++count[variation.short_name()];
    std::vector<std::string> names;
    names.reserve(variations.size());
    for (const Variation& variation : variations) {
        names.push_back(count[variation.short_name()] > 1 ? variation.key : variation.short_name());
    }
    return names;
}

void require_different_keys(const std::vector<Variation>& variations) {
    std::set<std::string> keys;
    for (const Variation& variation : variations) {
        if (!keys.insert(variation.key).second) {
            throw InputError(
                fmt::format("--vary {0}: the key is varied twice; give all its values in one --vary {0}=...",
                            variation.key));
        }
    }
}

/// The options of a combination: what holds for all runs, then the values of its own.
std::vector<Override> overrides_of(const SweepInput& input, const Combination& combination) {
    std::vector<Override> overrides = input.settings;
    for (std::size_t i = 0; i < input.variations.size(); ++i) {
        overrides.push_back({input.variations[i].key, combination.values[i]});
    }
    return overrides;
}

/// The messages of reading name options as `--set`; those of varied keys were given otherwise.
std::string as_given(std::string message, const std::vector<Variation>& variations) {
    for (const Variation& variation : variations) {
        for (const std::string& value : variation.values) {
            const std::string wrong = fmt::format("--set {}={}", variation.key, value);
            for (std::size_t at = message.find(wrong); at != std::string::npos;
                 at = message.find(wrong, at + 1)) {
                message.replace(at, 5, "--vary");
            }
        }
    }
    return message;
}

/// What is wrong with which combinations, one paragraph for each message.
class Refusals {
  public:
    void add(const std::string& message, const std::string& name) {
        const auto found = std::find_if(list_.begin(), list_.end(),
                                        [&](const Refusal& refusal) { return refusal.message == message; });
        if (found == list_.end()) {
            list_.push_back({message, {name}});
        } else {
            found->names.push_back(name);
        }
    }
    void raise_if_any(std::size_t combinations) const {
        if (list_.empty()) return;
        std::set<std::string> names;
        std::string text;
        for (const Refusal& refusal : list_) {
            names.insert(refusal.names.begin(), refusal.names.end());
            const std::size_t more = refusal.names.size() - 1;
            text += fmt::format(
                "\n{}{}:\n  {}", refusal.names.front(),
                more == 0 ? "" : fmt::format(" and {} more combination{}", more, more == 1 ? "" : "s"),
                refusal.message);
        }
        throw InputError(fmt::format("{} of the {} combinations cannot be run; none was started{}",
                                     names.size(), combinations, text));
    }

  private:
    struct Refusal {
        std::string message;
        std::vector<std::string> names;
    };
    std::vector<Refusal> list_;
};

void require_different_cases(const std::vector<SweepRun>& runs) {
    std::map<std::string, std::string> names;
    for (const SweepRun& run : runs) {
        const auto [first, is_new] = names.emplace(run.flow.text, run.combination.name);
        if (!is_new) {
            throw InputError(fmt::format(
                "{} and {} are the same case: two values of --vary mean the same, or the varied key has no "
                "effect; leave one out",
                first->second, run.combination.name));
        }
    }
}

}  // namespace

std::string Variation::short_name() const {
    const std::size_t dot = key.rfind('.');
    return dot == std::string::npos ? key : key.substr(dot + 1);
}

Variation read_variation(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
        throw InputError(fmt::format("--vary {}: {}", text, form));
    }
    Variation variation{trimmed(text.substr(0, equals)), split(text.substr(equals + 1))};
    std::set<std::string> seen;
    for (const std::string& value : variation.values) {
        if (value.empty()) {
            throw InputError(fmt::format("--vary {}: a value is missing; {}", text, form));
        }
        if (!seen.insert(value).second) {
            throw InputError(fmt::format("--vary {}: the value {} stands twice; leave one out", text, value));
        }
    }
    return variation;
}

std::vector<Combination> combinations_of(const std::vector<Variation>& variations) {
    require_different_keys(variations);
    const std::vector<std::string> names = names_of(variations);
    std::vector<Combination> all(1);
    for (std::size_t i = 0; i < variations.size(); ++i) {
        std::vector<Combination> longer;
        for (const Combination& start : all) {
            for (const std::string& value : variations[i].values) {
                Combination combination = start;
                combination.values.push_back(value);
                combination.name += fmt::format("{}{}={}", i == 0 ? "" : "_", names[i], in_name(value));
                longer.push_back(std::move(combination));
            }
        }
        all = std::move(longer);
    }
    std::map<std::string, const Combination*> by_name;
    for (const Combination& combination : all) {
        const auto [first, is_new] = by_name.emplace(combination.name, &combination);
        if (!is_new) {
            throw InputError(fmt::format(
                "two combinations would share the folder {}: their values ({} and {}) differ only in "
                "characters that a folder's name cannot have; write them otherwise",
                combination.name, fmt::join(first->second->values, " "), fmt::join(combination.values, " ")));
        }
        if (combination.name.size() > longest_name) {
            throw InputError(
                fmt::format("the name of a run would be too long for a folder ({} letters): {}; vary fewer "
                            "keys in one sweep",
                            combination.name.size(), combination.name));
        }
    }
    return all;
}

std::vector<SweepRun> read_matrix(const SweepInput& input) {
    for (const Variation& variation : input.variations) {
        for (const Override& setting : input.settings) {
            if (setting.key == variation.key) {
                throw InputError(
                    fmt::format("{0} is both set for all runs (--set {0}={1}) and varied (--vary); leave out "
                                "one of the two",
                                setting.key, setting.value));
            }
        }
    }
    const std::vector<Combination> combinations = combinations_of(input.variations);
    std::vector<SweepRun> runs;
    Refusals refusals;
    for (const Combination& combination : combinations) {
        try {
            Case c = read_case(input.case_file, overrides_of(input, combination));
            check_velocity_measurements(c);
            check_runnable(c);
            runs.push_back({combination, std::move(c), input.folder / combination.name});
        } catch (const InputError& error) {
            refusals.add(as_given(error.what(), input.variations), combination.name);
        }
    }
    refusals.raise_if_any(combinations.size());
    require_different_cases(runs);
    return runs;
}

}  // namespace riffle::inline sweep

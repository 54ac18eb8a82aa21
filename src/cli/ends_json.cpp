#include "cli/ends_json.hpp"

#include <optional>

#include "cli/printed_number.hpp"
#include "ends/flow_at_ends.hpp"

namespace riffle::inline cli {

namespace {

using nlohmann::ordered_json;

ordered_json range_json(const std::optional<Extremes>& range) {
    return range ? ordered_json{range->least, range->largest} : ordered_json();
}

const char* source_word(DepthSource source) {
    switch (source) {
        case DepthSource::given:
            return "given";
        case DepthSource::backwater:
            return "backwater";
        case DepthSource::uniform:
            return "uniform";
        case DepthSource::steady:
            return "steady";
        case DepthSource::start:
            return "start";
        case DepthSource::full:
            return "full";
        case DepthSource::unknown:
            break;
    }
    return "unknown";
}

ordered_json end_json(const FlowAtEnd& end) {
    return {{"depth", range_json(end.depth)},
            {"depth_from", source_word(end.source)},
            {"floor", end.floor},
            {"velocity", range_json(end.velocity)},
            {"froude", range_json(end.froude)},
            {"critical_depth", range_json(end.critical_depth)},
            {"normal_depth", range_json(end.normal_depth)}};
}

}  // namespace

ordered_json ends_json(const Forecast& f) {
    if (!f.ends) return nullptr;
    const FlowAtEnds& states = *f.ends;
    ordered_json facts = ordered_json::array();
    for (const EndFact& fact : f.end_facts) facts.push_back(fact.label + ": " + fact.text);
    return {{"unit_discharge", range_json(states.unit_discharge)},
            {"gives_discharge", states.gives_discharge},
            {"inflow", end_json(states.inflow)},
            {"outflow", end_json(states.outflow)},
            {"held_depth", range_json(states.held_depth)},
            {"reynolds", optional_number(states.reynolds)},
            {"in_words", facts}};
}

}  // namespace riffle::inline cli

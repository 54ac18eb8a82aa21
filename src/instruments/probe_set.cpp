#include "instruments/probe_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include "base/due_times.hpp"
#include "base/error.hpp"
#include "case/words.hpp"
#include "instruments/standard_probes.hpp"
#include "record/probe_fields.hpp"

namespace riffle::inline instruments {

namespace {

std::string group_of(const Instrument& instrument) { return probe_group(instrument.probe().name); }

/// Dataset of a probe's state in the checkpoint.
std::string saved_path(const Instrument& instrument) { return "/recorder" + group_of(instrument); }

void check_frequencies(const Case& c, double largest_step) {
    std::string faults;
    for (std::size_t i = 0; i < c.probes.size(); ++i) {
        const Probe& p = c.probes[i];
        const double limit = 0.5 / largest_step;
        if (p.sampling_frequency > limit) {
            faults += fmt::format(
                "{}{}: [[probe]] sampling_frequency of \"{}\" is {} Hz, but the time step of this case is "
                "up to {:.3g} s: expected at most {:.4g} Hz, every second step; sample less often or make "
                "the step smaller (numerics.courant_number)",
                faults.empty() ? "" : "\n", i < c.probe_places.size() ? c.probe_places[i] : c.path.string(),
                p.name, p.sampling_frequency, largest_step, limit);
        }
    }
    if (!faults.empty()) throw InputError(faults);
}

Dataset rows_of(const std::string& group, InstrumentRecord record, std::size_t rows) {
    std::vector<std::size_t> shape = {rows};
    shape.insert(shape.end(), record.row_shape.begin(), record.row_shape.end());
    Dataset dataset{.path = group + "/" + record.name,
                    .shape = std::move(shape),
                    .values = {},
                    .unit = std::move(record.unit),
                    .long_name = std::move(record.long_name),
                    .append = true};
    std::visit([&](auto& values) { dataset.values = std::move(values); }, record.values);
    return dataset;
}

void add_description(Content& content, const ProbeSet::Member& member) {
    const Instrument& instrument = *member.instrument;
    const Probe& probe = instrument.probe();
    const std::string group = group_of(instrument);
    const auto attribute = [&](const Field& field, AttributeValue value) {
        content.attributes.push_back({.path = group, .name = field.name, .value = std::move(value)});
    };
    attribute(fields::probe.kind, std::string(word(probe.kind)));
    attribute(fields::probe.sampling_frequency, probe.sampling_frequency);
    attribute(fields::probe.standard, std::int64_t{member.standard ? 1 : 0});
    for (const InstrumentAxis& axis : instrument.axes()) {
        content.datasets.push_back({.path = group + "/" + axis.name,
                                    .shape = {axis.values.size()},
                                    .values = axis.values,
                                    .unit = axis.unit,
                                    .long_name = axis.long_name});
    }
}

}  // namespace

double recorded_rows(const Instrument& instrument, double end) {
    const double rows = instrument.row_frequency();
    return std::max(0.0, whole_intervals(end * rows) - whole_intervals(instrument.probe().start * rows));
}

ProbeSet::ProbeSet(const Case& c, double largest_step) {
    check_frequencies(c, largest_step);
    const auto add = [&](const Probe& probe, bool standard) {
        Member member;
        member.instrument = make_instrument(probe, c);
        member.standard = standard;
        member.due = due_after_at_frequency(probe.start, probe.sampling_frequency);
        members_.push_back(std::move(member));
    };
    for (const Probe& probe : c.probes) add(probe, false);
    StandardProbes standard = standard_probes(c, largest_step);
    for (const Probe& probe : standard.probes) add(probe, true);
    notes_ = std::move(standard.notes);
}

bool ProbeSet::Member::is_due(double time) const { return has_come(time, due, interval()); }

double ProbeSet::Member::interval() const { return 1.0 / instrument->probe().sampling_frequency; }

bool ProbeSet::due_for_fluid(double time) const {
    return std::any_of(members_.begin(), members_.end(),
                       [&](const Member& m) { return m.is_due(time) && m.instrument->looks_at_fluid(); });
}

bool ProbeSet::due_for_fields_in_fluid(double time) const {
    return std::any_of(members_.begin(), members_.end(), [&](const Member& m) {
        return m.is_due(time) && m.instrument->looks_at_fluid() && m.instrument->needs_fields();
    });
}

double ProbeSet::forces_due() const {
    double due = std::numeric_limits<double>::infinity();
    for (const Member& m : members_) {
        if (m.instrument->needs_fields()) due = std::min(due, earliest_of(m.due, m.interval()));
    }
    return due;
}

void ProbeSet::record(const FlowState& state, bool looks_at_fluid) {
    for (Member& m : members_) {
        if (m.is_due(state.time) && m.instrument->looks_at_fluid() == looks_at_fluid) {
            m.instrument->sample(state);
            m.due =
                due_after_at_frequency(std::max(state.time, m.due), m.instrument->probe().sampling_frequency);
        }
    }
}

std::size_t ProbeSet::pending_bytes() const {
    std::size_t bytes = 0;
    for (const Member& m : members_) bytes += m.instrument->rows() * m.instrument->row_bytes();
    return bytes;
}

Content ProbeSet::take_new_rows() {
    Content content;
    for (Member& m : members_) {
        if (m.taken == 0) add_description(content, m);
        const std::size_t rows = m.instrument->rows();
        for (InstrumentRecord& record : m.instrument->take()) {
            content.datasets.push_back(rows_of(group_of(*m.instrument), std::move(record), rows));
        }
        m.taken += rows;
    }
    return content;
}

std::map<std::string, std::size_t> ProbeSet::rows() const {
    std::map<std::string, std::size_t> rows;
    for (const Member& m : members_) {
        for (const InstrumentRecord& record : m.instrument->records()) {
            rows[group_of(*m.instrument) + "/" + record.name] = m.taken;
        }
    }
    return rows;
}

void ProbeSet::save(Content& checkpoint) const {
    for (const Member& m : members_) {
        std::vector<double> saved = {m.due, static_cast<double>(m.taken)};
        const std::vector<double> unfinished = m.instrument->unfinished();
        saved.insert(saved.end(), unfinished.begin(), unfinished.end());
        checkpoint.datasets.push_back({.path = saved_path(*m.instrument),
                                       .shape = {saved.size()},
                                       .values = std::move(saved),
                                       .unit = "1",
                                       .long_name = "next sample, rows, sums of the unfinished window"});
    }
}

void ProbeSet::restore(const CheckpointReader& checkpoint) {
    for (Member& m : members_) {
        const std::string path = saved_path(*m.instrument);
        if (!checkpoint.has(path)) {
            throw FileError(
                fmt::format("the checkpoint lacks the probe \"{}\": the run was begun without it; "
                            "start the run again, or resume with the probes that it began with",
                            m.instrument->probe().name));
        }
        const std::vector<double> saved = checkpoint.doubles(path, 2 + m.instrument->unfinished().size());
        m.due = saved[0];
        m.taken = static_cast<std::size_t>(saved[1]);
        m.instrument->restore_unfinished({saved.begin() + 2, saved.end()});
    }
}

}  // namespace riffle::inline instruments

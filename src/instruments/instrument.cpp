#include "instruments/instrument.hpp"

#include <numeric>
#include <stdexcept>
#include <utility>

namespace riffle::inline instruments {

namespace {

template <class T>
std::size_t row_size(const InstrumentRecord& record, const std::vector<T>&) {
    return std::accumulate(record.row_shape.begin(), record.row_shape.end(), sizeof(T), std::multiplies<>());
}

}  // namespace

std::size_t InstrumentRecord::row_bytes() const {
    return std::visit([&](const auto& list) { return row_size(*this, list); }, values);
}

void InstrumentRecord::add(double value) {
    std::visit([&]<class T>(std::vector<T>& list) { list.push_back(static_cast<T>(value)); }, values);
}

std::size_t Instrument::row_bytes() const {
    return std::accumulate(records_.begin(), records_.end(), std::size_t{0},
                           [](std::size_t sum, const auto& record) { return sum + record.row_bytes(); });
}

std::vector<InstrumentRecord> Instrument::take() {
    std::vector<InstrumentRecord> taken = records_;
    for (InstrumentRecord& record : records_) {
        std::visit([](auto& list) { list.clear(); }, record.values);
    }
    rows_ = 0;
    return taken;
}

void Instrument::add_axis(const Field& field, std::vector<double> values) {
    if (!has(field)) return;
    axes_.push_back(
        {field.name, field.unit.in(dimensions_), field.meaning.in(dimensions_), std::move(values)});
}

void Instrument::add_record(const Field& field, std::vector<std::size_t> row_shape, bool in_double) {
    if (!has(field)) return;
    InstrumentRecord record{
        field.name, field.unit.in(dimensions_), field.meaning.in(dimensions_), std::move(row_shape), {}};
    if (in_double) record.values = std::vector<double>();
    records_.push_back(std::move(record));
}

void Instrument::add_record_of_solid(const Field& field, std::size_t number, const std::string& solid) {
    if (!has(field)) return;
    add_record(field, {}, true);
    InstrumentRecord& record = records_.back();
    record.name = numbered_name(field, number);
    const std::string meant = "the solid";
    record.long_name.replace(record.long_name.find(meant), meant.size(), meant + " \"" + solid + "\"");
}

std::vector<double> across(const Probe& probe, const Case& c, std::size_t points) {
    std::vector<double> y(points, c.channel.centreline());
    for (std::size_t i = 0; i < points && !probe.y.empty(); ++i) {
        y[i] = probe.y.size() == 1 ? probe.y.front() : probe.y[i];
    }
    return y;
}

std::unique_ptr<Instrument> make_instrument(const Probe& probe, const Case& c) {
    switch (probe.kind) {
        case ProbeKind::velocity:
            return make_velocity_points(probe, c);
        case ProbeKind::wave:
            return make_wave_probes(probe, c);
        case ProbeKind::surface_line:
            return make_surface_line(probe, c);
        case ProbeKind::grid:
            return probe.averaging_time > 0.0 ? make_velocity_grid(probe, c) : make_velocity_plane(probe, c);
        case ProbeKind::flow_rate:
            return make_flow_rate_sections(probe, c);
        case ProbeKind::pressure:
            return make_pressure_gauges(probe, c);
        case ProbeKind::force:
            return make_bed_force(probe, c);
    }
    throw std::logic_error("an instrument that instrument.cpp does not list");
}

}  // namespace riffle::inline instruments

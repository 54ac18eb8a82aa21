#include "solver/mean_field.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "base/due_times.hpp"
#include "base/not_a_number.hpp"
#include "base/parallel.hpp"
#include "particles/lattice.hpp"
#include "record/field_content.hpp"
#include "record/flow_fields.hpp"
#include "solver/averaging_rows.hpp"
#include "solver/content.hpp"
#include "solver/recorder.hpp"

namespace riffle::inline solver {

namespace {

/// A field of the file and what it is made from.
struct CellField {
    Field field;
    CellQuantity quantity;
};

const std::vector<CellField>& cell_fields() {
    using Q = CellQuantity;
    const auto& f = fields::mean_field;
    static const std::vector<CellField> all = {
        {f.count, Q::count},
        {f.velocity, Q::u},
        {f.spanwise_velocity, Q::v},
        {f.vertical_velocity, Q::w},
        {f.velocity_variance, Q::uu},
        {f.spanwise_velocity_variance, Q::vv},
        {f.vertical_velocity_variance, Q::ww},
        {f.velocity_covariance, Q::uw},
        {f.velocity_spanwise_covariance, Q::uv},
        {f.spanwise_vertical_covariance, Q::vw},
        {f.shear_stress, Q::shear_stress},
        {f.lateral_shear_stress, Q::lateral_shear_stress},
        {f.pressure, Q::pressure},
        {f.eddy_viscosity, Q::eddy_viscosity},
        {f.drag, Q::drag_force},
        {f.spanwise_drag, Q::spanwise_drag_force},
        {f.side_wall_drag, Q::side_wall_force},
    };
    return all;
}

/// The value of a field in a cell. `volume`: of the cell, m3.
double value_of(const CellField& field, const CellSums& sums, const CellPlace& cell, double samples,
                double volume) {
    const double value = sums.get(cell, field.quantity);
    if (field.quantity == CellQuantity::count) return value / samples;
    if (field.field.averaging == Averaging::by_samples) return value / (samples * volume);  // a force
    return sums.get(cell, CellQuantity::count) > 0.0 ? value : not_a_number;
}

}  // namespace

MeanField::MeanField(const Case& c) {
    if (c.channel.dimensions == 2 || c.output.mean_field_interval <= 0.0) return;
    interval_ = c.output.mean_field_interval;
    open_ends_ = c.channel.ends == Ends::open;
    const Lattice lattice = lattice_of(c);
    const double spacing = c.output.mean_field_spacing.value_or(c.numerics.spacing);
    const double extent[] = {c.channel.length, c.channel.simulated_width()};
    for (std::size_t k = 0; k < 2; ++k) {
        count_[k] = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(extent[k] / spacing)));
        edge_[k] = extent[k] / static_cast<double>(count_[k]);
    }
    count_[2] = static_cast<std::size_t>(averaging_rows(c));
    edge_[2] = lattice.dz;
    sums_ = CellSums(count_);
    window_end_ = due_after(0.0, interval_);
    new_fields_.resize(cell_fields().size());
}

std::vector<double> MeanField::centres(std::size_t axis) const {
    std::vector<double> centres(count_[axis]);
    for (std::size_t i = 0; i < centres.size(); ++i) {
        centres[i] = (static_cast<double>(i) + 0.5) * edge_[axis];
    }
    return centres;
}

std::vector<double> MeanField::edges(std::size_t axis) const {
    std::vector<double> edges(count_[axis] + 1);
    for (std::size_t i = 0; i < edges.size(); ++i) edges[i] = static_cast<double>(i) * edge_[axis];
    return edges;
}

CellPlace MeanField::cell_of(const Particles<3>& particles, std::size_t particle) const {
    CellPlace cell{};
    for (std::size_t k = 0; k < 3; ++k) {
        cell[k] = static_cast<std::size_t>(std::clamp(particles.position[k][particle] / edge_[k], 0.0,
                                                      static_cast<double>(count_[k]) - 0.5));
    }
    return cell;
}

void MeanField::sample(const SimulationIn<3>& simulation) {
    if (closed_) open_window();
    const Particles<3>& p = simulation.particles();
    const ParticleFields& f = simulation.fields();
    const std::size_t n = p.size();
    // Sorted by slices across the channel, each of which has its own cells: the slices can be summed in
    // parallel, and each sum has its order from that of the particles.
    std::vector<std::size_t> begin_of(count_[0] + 1, 0);
    const auto counts = [&](std::size_t i) {
        return !open_ends_ ||
               (p.position[0][i] >= 0.0 && p.position[0][i] < edge_[0] * static_cast<double>(count_[0]));
    };
    for (std::size_t i = 0; i < n; ++i) {
        if (counts(i)) ++begin_of[cell_of(p, i)[0] + 1];
    }
    std::partial_sum(begin_of.begin(), begin_of.end(), begin_of.begin());
    order_.resize(n);
    std::vector<std::size_t> next(begin_of.begin(), begin_of.end() - 1);
    for (std::size_t i = 0; i < n; ++i) {
        if (counts(i)) order_[next[cell_of(p, i)[0]]++] = static_cast<std::uint32_t>(i);
    }
    parallel_blocks(count_[0], 1, [&](std::size_t slice, std::size_t) {
        for (std::size_t k = begin_of[slice]; k < begin_of[slice + 1]; ++k) {
            const std::size_t i = order_[k];
            const double mass = p.mass[i];
            sums_.add(cell_of(p, i), {.velocity = {p.velocity[0][i], p.velocity[1][i], p.velocity[2][i]},
                                      .shear_stress = f.shear_stress[i],
                                      .lateral_shear_stress = f.lateral_shear_stress[i],
                                      .pressure = f.pressure[i],
                                      .eddy_viscosity = f.eddy_viscosity[i],
                                      .drag_force = mass * f.drag_acceleration_x[i],
                                      .spanwise_drag_force = mass * f.drag_acceleration_y[i],
                                      .side_wall_force = mass * f.side_wall_acceleration_x[i]});
        }
    });
    std::vector<std::uint32_t>().swap(order_);
    samples_ += 1.0;
    if (has_come(simulation.clock().time, window_end_, interval_)) {
        ends_.push_back(window_end_);
        closed_ = true;
        closed_taken_ = false;
        window_end_ = due_next(simulation.clock().time, window_end_, interval_);
    }
}

void MeanField::open_window() {
    if (!closed_taken_) keep_closed_window();
    closed_ = false;
    samples_ = 0.0;
    sums_.clear();
}

void MeanField::keep_closed_window() {
    for (std::size_t k = 0; k < cell_fields().size(); ++k) {
        std::vector<float>& values = new_fields_[k];
        values.resize(values.size() + cells());
        fill(k, 0, std::span(values).last(cells()));
    }
    new_samples_.push_back(samples_);
    closed_taken_ = true;
}

void MeanField::fill(std::size_t field, std::size_t first, std::span<float> values) const {
    constexpr std::size_t block = std::size_t{1} << 13U;
    const double volume = edge_[0] * edge_[1] * edge_[2];
    const CellField& of = cell_fields()[field];
    parallel_blocks(values.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const std::size_t place = first + k;  // along x first, then y, then z
            const CellPlace cell = {place % count_[0], place / count_[0] % count_[1],
                                    place / (count_[0] * count_[1])};
            values[k] = static_cast<float>(value_of(of, sums_, cell, samples_, volume));
        }
    });
}

std::size_t MeanField::row_bytes() const {
    return on() ? cells() * cell_fields().size() * sizeof(float) + 16 : 0;
}

std::size_t MeanField::pending_bytes() const { return new_samples_.size() * row_bytes(); }

Content MeanField::take_new_rows() {
    Content content;
    if (!on()) return content;
    const bool streamed = has_closed_window() && new_samples_.empty();
    if (has_closed_window() && !streamed) keep_closed_window();
    if (streamed) {
        new_samples_.push_back(samples_);
        closed_taken_ = true;
    }
    const std::size_t rows = new_samples_.size();
    const auto add = [&](const Field& field, std::vector<std::size_t> shape, Dataset::Values values) {
        content.datasets.push_back(dataset_of(field, 3, std::move(shape), std::move(values), true));
    };
    const auto& axes = fields::mean_field_axes;
    const auto first_new = ends_.begin() + static_cast<std::ptrdiff_t>(taken_);
    add(axes.time, {rows}, std::vector<double>(first_new, ends_.end()));
    add(axes.samples, {rows}, std::exchange(new_samples_, {}));
    for (std::size_t k = 0; k < cell_fields().size(); ++k) {
        Dataset::Values values = std::exchange(new_fields_[k], {});
        if (streamed) {
            values = StreamedValues<float>{
                cells(), [this, k](std::size_t first, std::span<float> block) { fill(k, first, block); }};
        }
        add(cell_fields()[k].field, {rows, count_[2], count_[1], count_[0]}, std::move(values));
    }
    if (taken_ == 0) {
        add_field(content, axes.x, 3, centres(0));
        add_field(content, axes.y, 3, centres(1));
        add_field(content, axes.z, 3, centres(2));
    }
    taken_ += rows;
    return content;
}

void MeanField::add_rows(std::map<std::string, std::size_t>& rows) const {
    if (on()) {
        rows[fields::mean_field_axes.time.path()] = taken_;
        rows[fields::mean_field_axes.samples.path()] = taken_;
        for (const CellField& of : cell_fields()) rows[of.field.path()] = taken_;
    }
}

void MeanField::save(Content& checkpoint) const {
    if (!on()) return;
    // A closed window is in the results; the sums of the next one are zero.
    add_array(checkpoint, "/recorder/mean_field", {window_end_, closed_ ? 0.0 : samples_}, "1",
              "end and samples of the window that is being averaged");
    const auto add = [&](const char* path, std::size_t size, auto value, const char* long_name) {
        const auto values = [this, value](std::size_t first, std::span<double> block) {
            for (std::size_t i = 0; i < block.size(); ++i) block[i] = closed_ ? 0.0 : value(first + i);
        };
        checkpoint.datasets.push_back({.path = path,
                                       .shape = {size},
                                       .values = StreamedValues<double>{size, values},
                                       .unit = "1",
                                       .long_name = long_name});
    };
    add(
        "/recorder/mean_field_sums", sums_.dense().size(),
        [this](std::size_t i) { return static_cast<double>(sums_.dense()[i]); },
        "its statistics, by cell and quantity");
    add(
        "/recorder/mean_field_forces", 3 * cells(), [this](std::size_t i) { return sums_.force(i); },
        "its sums of the forces, by cell and quantity");
    add_array(checkpoint, "/recorder/mean_field_ends", ends_, "s", "ends of the windows so far");
}

void MeanField::restore(const CheckpointReader& checkpoint) {
    if (!on()) return;
    const std::vector<double> window = checkpoint.doubles("/recorder/mean_field", 2);
    window_end_ = window[0];
    samples_ = window[1];
    closed_ = false;
    sums_.set_dense(checkpoint.doubles("/recorder/mean_field_sums", sums_.dense().size()));
    sums_.set_forces(checkpoint.doubles("/recorder/mean_field_forces", 3 * cells()));
    const std::vector<std::size_t> ends = checkpoint.shape("/recorder/mean_field_ends");
    ends_ = checkpoint.doubles("/recorder/mean_field_ends", ends.empty() ? 0 : ends[0]);
    taken_ = ends_.size();
}

std::vector<std::string> MeanField::field_names() {
    std::vector<std::string> names;
    for (const CellField& of : cell_fields()) names.emplace_back(of.field.name);
    return names;
}

}  // namespace riffle::inline solver

// Means and second moments of the velocity on a grid, window by window, as particle image velocimetry gives
// them, and the means of pressure and shear stress, which it does not.

#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "base/due_times.hpp"
#include "base/parallel.hpp"
#include "instruments/instrument.hpp"
#include "record/probe_fields.hpp"

namespace riffle::inline instruments {

namespace {

/// Points from `from` to `to`, `to` included where the spacing meets it.
std::vector<double> line(double from, double to, double spacing) {
    std::vector<double> points;
    const auto n = static_cast<std::size_t>(std::floor((to - from) / spacing + 1e-9)) + 1;
    for (std::size_t i = 0; i < n; ++i) points.push_back(from + static_cast<double>(i) * spacing);
    return points;
}

class VelocityGrid final : public Instrument {
  public:
    VelocityGrid(const Probe& probe, const Case& c, GridAxes axes)
        : Instrument(probe, c),
          x_(std::move(axes.x)),
          y_(across(probe, c, 1).front()),
          z_(std::move(axes.z)),
          sums_(x_.size() * z_.size()),
          space_(c.channel.dimensions == 3) {
        const std::vector<std::size_t> shape = {z_.size(), x_.size()};
        window_end_ = due_after(probe.start, probe.averaging_time);
        const auto& of = fields::velocity_grid;
        add_axis(of.x, x_);
        add_axis(of.y, {y_});
        add_axis(of.z, z_);
        add_record(of.time, {}, true);
        add_record(of.samples, {}, true);
        add_record(of.velocity, shape);
        add_record(of.vertical_velocity, shape);
        add_record(of.velocity_variance, shape);
        add_record(of.vertical_velocity_variance, shape);
        add_record(of.velocity_covariance, shape);
        add_record(of.spanwise_velocity, shape);
        add_record(of.spanwise_velocity_variance, shape);
        add_record(of.pressure, shape);
        if (c.turbulence.closure != ClosureKind::none) add_record(of.shear_stress, shape);
    }

    void sample(const FlowState& state) override {
        const std::size_t width = x_.size();
        parallel_blocks(sums_.size(), 64, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                sums_[i].add(state.fluid->flow_at({x_[i % width], y_, z_[i / width]}, *state.pressure,
                                                  state.shear_stress));
            }
        });
        samples_ += 1.0;
        if (has_come(state.time, window_end_, probe().averaging_time)) {
            finish_window();
            window_end_ = due_next(state.time, window_end_, probe().averaging_time);
        }
    }
    [[nodiscard]] bool needs_fields() const override { return true; }
    [[nodiscard]] std::size_t points() const override { return sums_.size(); }
    [[nodiscard]] double row_frequency() const override { return 1.0 / probe().averaging_time; }

    [[nodiscard]] std::vector<double> unfinished() const override {
        std::vector<double> saved = {window_end_, samples_};
        for (const Sums& s : sums_) {
            for (double Sums::*const sum : saved_sums()) saved.push_back(s.*sum);
        }
        return saved;
    }
    void restore_unfinished(const std::vector<double>& saved) override {
        auto next = saved.begin();
        window_end_ = *next++;
        samples_ = *next++;
        for (Sums& s : sums_) {
            for (double Sums::*const sum : saved_sums()) s.*sum = *next++;
        }
    }

  private:
    /// Sums over the wet samples of a point.
    struct Sums {
        double wet = 0.0, u = 0.0, w = 0.0, uu = 0.0, ww = 0.0, uw = 0.0, p = 0.0, tau = 0.0, v = 0.0,
               vv = 0.0;

        void add(const FluidView::Flow& flow) {
            const FluidView::Velocity& velocity = flow.velocity;
            if (std::isfinite(velocity.u)) {
                wet += 1.0;
                u += velocity.u;
                w += velocity.w;
                uu += velocity.u * velocity.u;
                ww += velocity.w * velocity.w;
                uw += velocity.u * velocity.w;
                v += velocity.v;
                vv += velocity.v * velocity.v;
                p += flow.pressure;
                tau += flow.shear_stress;
            }
        }
    };
    /// The sums that an unfinished window is saved as.
    [[nodiscard]] std::span<double Sums::*const> saved_sums() const {
        static constexpr std::array<double Sums::*, 10> all = {&Sums::wet, &Sums::u,  &Sums::w, &Sums::uu,
                                                               &Sums::ww,  &Sums::uw, &Sums::p, &Sums::tau,
                                                               &Sums::v,   &Sums::vv};
        return std::span(all).first(space_ ? all.size() : all.size() - 2);
    }

    /// Windows end at multiples of their length.
    void finish_window() {
        record(0).add(window_end_);
        record(1).add(samples_);
        for (Sums& s : sums_) {
            // Means over few samples would be those of the wave crests alone.
            const bool usable = s.wet > 0.0 && s.wet >= 0.5 * samples_;
            const double n = usable ? s.wet : std::numeric_limits<double>::quiet_NaN();
            const double u = s.u / n;
            const double w = s.w / n;
            const double v = s.v / n;
            std::vector<double> row = {u, w, s.uu / n - u * u, s.ww / n - w * w, s.uw / n - u * w};
            if (space_) {
                row.insert(row.end(), {v, s.vv / n - v * v});
            }
            row.insert(row.end(), {s.p / n, s.tau / n});
            for (std::size_t k = 0; 2 + k < records().size(); ++k) record(2 + k).add(row[k]);
            s = {};
        }
        samples_ = 0.0;
        end_row();
    }

    std::vector<double> x_;
    double y_;
    std::vector<double> z_;
    std::vector<Sums> sums_;  ///< by row, then column
    bool space_;              ///< three dimensions
    double samples_ = 0.0;
    double window_end_ = 0.0;
};

}  // namespace

GridAxes grid_axes(const Probe& probe, const Case& c) {
    const double spacing = probe.spacing.value_or(2.0 * c.numerics.spacing);
    const double x_from = probe.x_from.value_or(0.0);
    double x_to = probe.x_to.value_or(c.channel.length);
    if (!probe.x_to && !probe.x_from && c.channel.ends == Ends::periodic) {
        x_to -= 1e-6 * c.channel.length;  // the end of a periodic channel is its start
    }
    return {line(x_from, x_to, spacing),
            line(probe.z_from.value_or(0.5 * spacing), probe.z_to.value_or(c.total_depth()), spacing)};
}

std::unique_ptr<Instrument> make_velocity_grid(const Probe& probe, const Case& c) {
    return std::make_unique<VelocityGrid>(probe, c, grid_axes(probe, c));
}

}  // namespace riffle::inline instruments

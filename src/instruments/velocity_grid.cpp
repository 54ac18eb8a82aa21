// Means and second moments of the velocity on a grid, window by window, as particle image velocimetry gives
// them.

#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "instruments/instrument.hpp"

namespace riffle {

namespace {

/// Points from `from` to `to`, `to` included where the spacing meets it.
std::vector<double> line(double from, double to, double spacing) {
    std::vector<double> points;
    const auto n = static_cast<std::size_t>(std::floor((to - from) / spacing + 1e-9)) + 1;
    for (std::size_t i = 0; i < n; ++i) {
        points.push_back(from + static_cast<double>(i) * spacing);
    }
    return points;
}

class VelocityGrid final : public Instrument {
  public:
    VelocityGrid(const Probe& probe, std::vector<double> x, std::vector<double> z)
        : Instrument(probe), x_(std::move(x)), z_(std::move(z)), sums_(x_.size() * z_.size()) {
        const std::vector<std::size_t> shape = {z_.size(), x_.size()};
        window_end_ = window_after(probe.start);
        add_axis("x", "distance along the channel", x_);
        add_axis("z", "height above the bed level", z_);
        add_record("time", "s", "end of the averaging window", {}, true);
        add_record("samples", "1", "samples in the window", {}, true);
        add_record("velocity", "m/s", "mean streamwise velocity of the window", shape);
        add_record("vertical_velocity", "m/s", "mean vertical velocity of the window", shape);
        add_record("velocity_variance", "m2/s2", "mean square of u'", shape);
        add_record("vertical_velocity_variance", "m2/s2", "mean square of w'", shape);
        add_record("velocity_covariance", "m2/s2", "mean of u'w'", shape);
    }

    void sample(const FlowState& state) override {
        const std::size_t width = x_.size();
        parallel_blocks(sums_.size(), 64, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                sums_[i].add(state.fluid->velocity_at(x_[i % width], z_[i / width]));
            }
        });
        samples_ += 1.0;
        if (state.time >= window_end_) {
            finish_window();
            window_end_ = window_after(state.time);
        }
    }
    [[nodiscard]] std::size_t points() const override { return sums_.size(); }
    [[nodiscard]] double row_frequency() const override { return 1.0 / probe().averaging_time; }

    [[nodiscard]] std::vector<double> unfinished() const override {
        std::vector<double> saved = {window_end_, samples_};
        for (const Sums& s : sums_) {
            saved.insert(saved.end(), {s.wet, s.u, s.w, s.uu, s.ww, s.uw});
        }
        return saved;
    }
    void restore_unfinished(const std::vector<double>& saved) override {
        auto next = saved.begin();
        window_end_ = *next++;
        samples_ = *next++;
        for (Sums& s : sums_) {
            for (double* const sum : {&s.wet, &s.u, &s.w, &s.uu, &s.ww, &s.uw}) {
                *sum = *next++;
            }
        }
    }

  private:
    /// Sums over the wet samples of a point.
    struct Sums {
        double wet = 0.0, u = 0.0, w = 0.0, uu = 0.0, ww = 0.0, uw = 0.0;

        void add(const FluidView::Velocity& v) {
            if (std::isfinite(v.u)) {
                wet += 1.0;
                u += v.u;
                w += v.w;
                uu += v.u * v.u;
                ww += v.w * v.w;
                uw += v.u * v.w;
            }
        }
    };

    /// Windows end at multiples of their length.
    [[nodiscard]] double window_after(double time) const {
        const double length = probe().averaging_time;
        return (std::floor(time / length + 1e-9) + 1.0) * length;
    }

    void finish_window() {
        record(0).add(window_end_);
        record(1).add(samples_);
        for (Sums& s : sums_) {
            // Means over few samples would be those of the wave crests alone.
            const bool usable = s.wet > 0.0 && s.wet >= 0.5 * samples_;
            const double n = usable ? s.wet : std::numeric_limits<double>::quiet_NaN();
            const double u = s.u / n;
            const double w = s.w / n;
            const double row[] = {u, w, s.uu / n - u * u, s.ww / n - w * w, s.uw / n - u * w};
            for (std::size_t k = 0; k < std::size(row); ++k) {
                record(2 + k).add(row[k]);
            }
            s = {};
        }
        samples_ = 0.0;
        end_row();
    }

    std::vector<double> x_;
    std::vector<double> z_;
    std::vector<Sums> sums_;  ///< by row, then column
    double samples_ = 0.0;
    double window_end_ = 0.0;
};

}  // namespace

std::unique_ptr<Instrument> make_velocity_grid(const Probe& probe, const Case& c) {
    const double spacing = probe.spacing.value_or(2.0 * c.numerics.spacing);
    const double x_from = probe.x_from.value_or(0.0);
    double x_to = probe.x_to.value_or(c.channel.length);
    if (!probe.x_to && !probe.x_from && c.channel.ends == Ends::periodic) {
        x_to -= 1e-6 * c.channel.length;  // the end of a periodic channel is its start
    }
    return std::make_unique<VelocityGrid>(
        probe, line(x_from, x_to, spacing),
        line(probe.z_from.value_or(0.5 * spacing), probe.z_to.value_or(c.total_depth()), spacing));
}

}  // namespace riffle

#include "turbulence/closure.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <utility>

#include "turbulence/czernuszenko_rylov.hpp"
#include "turbulence/nezu_rodi.hpp"
#include "turbulence/nikuradse.hpp"
#include "turbulence/ramp.hpp"
#include "turbulence/resolved.hpp"
#include "turbulence/sps.hpp"
#include "turbulence/wall_law.hpp"
#include "turbulence/wall_layer.hpp"

namespace riffle::inline turbulence {

namespace {

/// A closure made from a mixing length that is a function of height and depth.
template <class Law>
class HeightClosure final : public Closure {
  public:
    HeightClosure(double depth, Law law) : depth_(depth), law_(law) {}

    [[nodiscard]] double mixing_length(double z) const override { return law_(z, depth_); }
    [[nodiscard]] double mixing_length_in(double z, double depth) const override { return law_(z, depth); }

    void mixing_lengths(std::span<const double> z, std::span<double> result) const override {
        assert(result.size() == z.size());
        for (std::size_t i = 0; i < z.size(); ++i) result[i] = law_(z[i], depth_);
    }

  private:
    double depth_;
    Law law_;
};

/// Czernuszenko & Rylov (2000): Nezu & Rodi's mixing length over the height, smaller beside side walls and in
/// the spanwise direction.
class CzernuszenkoRylov final : public Closure {
  public:
    explicit CzernuszenkoRylov(const Case& c)
        : t_(c.turbulence),
          depth_(c.total_depth()),
          width_(c.channel.width),
          edge_zone_(c.turbulence.edge_zone * 0.5 * depth_),
          walls_(c.has_side_walls()) {}

    [[nodiscard]] double mixing_length(double z) const override { return mixing_length_in(z, depth_); }
    [[nodiscard]] double mixing_length_in(double z, double depth) const override {
        return nezu_rodi_mixing_length(z, t_.zero, depth, t_.kappa, t_.wake());
    }
    void mixing_lengths(std::span<const double> z, std::span<double> result) const override {
        assert(result.size() == z.size());
        for (std::size_t i = 0; i < z.size(); ++i) result[i] = mixing_length(z[i]);
    }
    [[nodiscard]] bool varies_across() const override { return walls_; }
    [[nodiscard]] double side_factor(double y) const override {
        return walls_ ? edge_zone_factor(std::min(y, width_ - y), edge_zone_) : 1.0;
    }
    [[nodiscard]] double spanwise_ratio() const override { return t_.spanwise_ratio; }

  private:
    Turbulence t_;
    double depth_, width_, edge_zone_;
    bool walls_;
};

/// Smagorinsky's model for eddies that the particles resolve, its length damped over the bed's zero plane and
/// beside side walls.
class SmagorinskyClosure final : public Closure {
  public:
    explicit SmagorinskyClosure(const Case& c)
        : t_(c.turbulence),
          filter_width_(c.turbulence.filter_width.value_or(c.numerics.spacing)),
          width_(c.channel.width),
          walls_(c.has_side_walls()) {}

    [[nodiscard]] double mixing_length(double z) const override { return beside(z - t_.zero); }
    [[nodiscard]] double mixing_length_in(double z, double /*depth*/) const override {
        return mixing_length(z);
    }
    void mixing_lengths(std::span<const double> z, std::span<double> result) const override {
        assert(result.size() == z.size());
        for (std::size_t i = 0; i < z.size(); ++i) result[i] = mixing_length(z[i]);
    }
    [[nodiscard]] bool varies_across() const override { return walls_; }
    [[nodiscard]] double side_factor(double y) const override {
        return walls_ ? beside(std::min(y, width_ - y)) / (t_.smagorinsky_constant * filter_width_) : 1.0;
    }

  private:
    [[nodiscard]] double beside(double distance) const {
        return smagorinsky_length(t_.smagorinsky_constant, filter_width_, t_.kappa, distance);
    }

    Turbulence t_;
    double filter_width_, width_;
    bool walls_;
};

/// A closure with the mixing length of a wall at the bed: `law` makes it of the closure, height and depth.
template <class Law>
class ClosureOverWall final : public Closure {
  public:
    ClosureOverWall(std::unique_ptr<const Closure> closure, double depth, Law law)
        : closure_(std::move(closure)), depth_(depth), law_(std::move(law)) {}

    [[nodiscard]] double mixing_length(double z) const override { return law_(*closure_, z, depth_); }
    [[nodiscard]] double mixing_length_in(double z, double depth) const override {
        return law_(*closure_, z, depth);
    }
    void mixing_lengths(std::span<const double> z, std::span<double> result) const override {
        for (std::size_t i = 0; i < z.size(); ++i) result[i] = law_(*closure_, z[i], depth_);
    }
    [[nodiscard]] bool varies_across() const override { return closure_->varies_across(); }
    [[nodiscard]] double side_factor(double y) const override { return closure_->side_factor(y); }
    [[nodiscard]] double spanwise_ratio() const override { return closure_->spanwise_ratio(); }

  private:
    std::unique_ptr<const Closure> closure_;
    double depth_;
    Law law_;
};

template <class Law>
std::unique_ptr<const Closure> closure_over_wall(std::unique_ptr<const Closure> closure, double depth,
                                                 Law law) {
    return std::make_unique<ClosureOverWall<Law>>(std::move(closure), depth, std::move(law));
}

template <class Law>
std::unique_ptr<const Closure> height_closure(const Case& c, Law law) {
    return std::make_unique<HeightClosure<Law>>(c.total_depth(), law);
}

using Factory = std::unique_ptr<const Closure> (*)(const Case&);

struct Registration {
    ClosureKind kind;
    Factory make;
};

std::unique_ptr<const Closure> make_ramp(const Case& c) {
    return height_closure(c, [t = c.turbulence](double z, double depth) {
        return ramp_mixing_length(z, t.zero, depth, t.kappa, t.lambda);
    });
}

std::unique_ptr<const Closure> make_nezu_rodi(const Case& c) {
    return height_closure(c, [t = c.turbulence](double z, double depth) {
        return nezu_rodi_mixing_length(z, t.zero, depth, t.kappa, t.wake());
    });
}

std::unique_ptr<const Closure> make_nikuradse(const Case& c) {
    return height_closure(c, [zero = c.turbulence.zero](double z, double depth) {
        return nikuradse_mixing_length(z, zero, depth);
    });
}

/// One length everywhere.
std::unique_ptr<const Closure> uniform_closure(const Case& c, double length) {
    return height_closure(c, [length](double, double) { return length; });
}

std::unique_ptr<const Closure> make_sps(const Case& c) {
    const double filter_width = c.turbulence.filter_width.value_or(sps_filter_width(c.numerics.spacing));
    return uniform_closure(c, sps_mixing_length(c.turbulence.smagorinsky_constant, filter_width));
}

std::unique_ptr<const Closure> make_wale(const Case& c) {
    return uniform_closure(c, wale_length(c.turbulence.smagorinsky_constant,
                                          c.turbulence.filter_width.value_or(c.numerics.spacing)));
}

std::unique_ptr<const Closure> make_vreman(const Case& c) {
    return uniform_closure(c, vreman_length(c.turbulence.smagorinsky_constant,
                                            c.turbulence.filter_width.value_or(c.numerics.spacing)));
}

std::unique_ptr<const Closure> make_smagorinsky(const Case& c) {
    return std::make_unique<SmagorinskyClosure>(c);
}

std::unique_ptr<const Closure> make_none(const Case&) { return nullptr; }

std::unique_ptr<const Closure> make_czernuszenko_rylov(const Case& c) {
    return std::make_unique<CzernuszenkoRylov>(c);
}

/// A new closure is one new file with its pure function and one line here.
constexpr std::array registry{
    Registration{ClosureKind::none, make_none},
    Registration{ClosureKind::ramp, make_ramp},
    Registration{ClosureKind::nezu_rodi, make_nezu_rodi},
    Registration{ClosureKind::nikuradse, make_nikuradse},
    Registration{ClosureKind::sps, make_sps},
    Registration{ClosureKind::czernuszenko_rylov, make_czernuszenko_rylov},
    Registration{ClosureKind::wale, make_wale},
    Registration{ClosureKind::vreman, make_vreman},
    Registration{ClosureKind::smagorinsky, make_smagorinsky},
};

/// The closure without the wall's part.
std::unique_ptr<const Closure> make_plain_closure(const Case& c) {
    const auto* const entry = std::find_if(registry.begin(), registry.end(), [&c](const Registration& r) {
        return r.kind == c.turbulence.closure;
    });
    assert(entry != registry.end());
    return entry->make(c);
}

}  // namespace

std::unique_ptr<const Closure> make_closure(const Case& c) {
    const auto law = bed_wall_law(c);
    return law ? make_wall_closure(c, *law) : make_plain_closure(c);
}

std::unique_ptr<const Closure> make_wall_closure(const Case& c, const WallLaw& law) {
    return closure_over_wall(make_plain_closure(c), c.total_depth(),
                             [law](const Closure& closure, double z, double depth) {
                                 return law.mixing_length(z, closure.mixing_length_in(z, depth));
                             });
}

std::unique_ptr<const Closure> make_particle_closure(const Case& c, double row_height) {
    auto over_wall = make_closure(c);
    if (!has_wall_law(c)) return over_wall;
    const double case_depth = c.total_depth();
    const WallLayer wall_layer(c, row_height);
    const double at_top = over_wall->mixing_length(wall_layer.height());
    return closure_over_wall(
        std::move(over_wall), case_depth,
        [wall_layer, at_top, case_depth](const Closure& closure, double z, double depth) {
            const double top = wall_layer.height();
            if (z >= top) return closure.mixing_length_in(z, depth);
            // In water of another depth the layer joins the closure as well.
            const double length = wall_layer.mixing_length(z);
            return depth == case_depth ? length : length * closure.mixing_length_in(top, depth) / at_top;
        });
}

}  // namespace riffle::inline turbulence

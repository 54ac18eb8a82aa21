#include "turbulence/closure.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>

#include "turbulence/czernuszenko_rylov.hpp"
#include "turbulence/nezu_rodi.hpp"
#include "turbulence/nikuradse.hpp"
#include "turbulence/ramp.hpp"
#include "turbulence/resolved.hpp"
#include "turbulence/sps.hpp"

namespace riffle {

namespace {

/// A closure made from a mixing length that is a function of the height alone.
template <class Law>
class HeightClosure final : public Closure {
  public:
    explicit HeightClosure(Law law) : law_(law) {}

    [[nodiscard]] double mixing_length(double z) const override { return law_(z); }

    void mixing_lengths(std::span<const double> z, std::span<double> result) const override {
        assert(result.size() == z.size());
        for (std::size_t i = 0; i < z.size(); ++i) result[i] = law_(z[i]);
    }

  private:
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

    [[nodiscard]] double mixing_length(double z) const override {
        return nezu_rodi_mixing_length(z, t_.zero, depth_, t_.kappa, t_.wake());
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

template <class Law>
std::unique_ptr<const Closure> height_closure(Law law) {
    return std::make_unique<HeightClosure<Law>>(law);
}

using Factory = std::unique_ptr<const Closure> (*)(const Case&);

struct Registration {
    ClosureKind kind;
    Factory make;
};

std::unique_ptr<const Closure> make_ramp(const Case& c) {
    return height_closure([t = c.turbulence, depth = c.total_depth()](double z) {
        return ramp_mixing_length(z, t.zero, depth, t.kappa, t.lambda);
    });
}

std::unique_ptr<const Closure> make_nezu_rodi(const Case& c) {
    return height_closure([t = c.turbulence, depth = c.total_depth()](double z) {
        return nezu_rodi_mixing_length(z, t.zero, depth, t.kappa, t.wake());
    });
}

std::unique_ptr<const Closure> make_nikuradse(const Case& c) {
    return height_closure([zero = c.turbulence.zero, depth = c.total_depth()](double z) {
        return nikuradse_mixing_length(z, zero, depth);
    });
}

/// One length everywhere.
std::unique_ptr<const Closure> uniform_closure(double length) {
    return height_closure([length](double) { return length; });
}

std::unique_ptr<const Closure> make_sps(const Case& c) {
    const double filter_width = c.turbulence.filter_width.value_or(sps_filter_width(c.numerics.spacing));
    return uniform_closure(sps_mixing_length(c.turbulence.smagorinsky_constant, filter_width));
}

std::unique_ptr<const Closure> make_wale(const Case& c) {
    return uniform_closure(wale_length(c.turbulence.smagorinsky_constant,
                                       c.turbulence.filter_width.value_or(c.numerics.spacing)));
}

std::unique_ptr<const Closure> make_vreman(const Case& c) {
    return uniform_closure(vreman_length(c.turbulence.smagorinsky_constant,
                                         c.turbulence.filter_width.value_or(c.numerics.spacing)));
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
};

}  // namespace

std::unique_ptr<const Closure> make_closure(const Case& c) {
    const auto* const entry = std::find_if(registry.begin(), registry.end(), [&c](const Registration& r) {
        return r.kind == c.turbulence.closure;
    });
    assert(entry != registry.end());
    return entry->make(c);
}

}  // namespace riffle

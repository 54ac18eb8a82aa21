#include "sph/particle_loops.hpp"
#include "sph/spray.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "particle_set.hpp"

namespace riffle::particle_loops_test {
namespace {

/// Rounding of a result of up to twenty operations in `Real`, relative to the size of its terms.
template <class Real>
constexpr double rounding = 20.0 * static_cast<double>(std::numeric_limits<Real>::epsilon());

/// Tests for both dimensions and precisions of a set. Clouds of 5 and 300 particles: the first leaves its
/// only clusters partly empty, the second has full ones too.
class ParticleLoopsTest : public testing::TestWithParam<InstructionSet> {
  protected:
    void SetUp() override {
        if (!instruction_set_available(GetParam())) {
            GTEST_SKIP() << "this processor does not offer " << instruction_set_name(GetParam());
        }
    }
    template <class F>
    void for_all(const F& f) {
        for (const std::size_t count : {std::size_t{5}, std::size_t{300}}) {
            f(particle_loops<2, float>(GetParam()), std::make_unique<ParticleSet<2, float>>(count, 1));
            f(particle_loops<2, double>(GetParam()), std::make_unique<ParticleSet<2, double>>(count, 2));
            f(particle_loops<3, float>(GetParam()), std::make_unique<ParticleSet<3, float>>(count, 3));
            f(particle_loops<3, double>(GetParam()), std::make_unique<ParticleSet<3, double>>(count, 4));
        }
    }
};

/// What the stress loop may be asked for.
struct StressOptions {
    bool corrected = true;
    bool tensor = true;  ///< gradients are known
    bool closure = true;
    bool two_point = true;
    bool shear_only = false;
    StrainMeasure measure = StrainMeasure::strain_rate;
    bool continued = false;
    EquationOfState state = EquationOfState::linear;
    double spanwise_ratio = 1.0;  ///< l_y/l_x in the tensor, three dimensions
    double bulk_viscosity = 0.0;
};

/// Viscosity and stress of one particle, plainly.
template <int D>
struct PlainStress {
    double eddy_viscosity = 0.0;
    double viscosity_root = 0.0;
    double weight = 0.0;
    double pressure = 0.0;  ///< p/rho0, over (1 + s)^2 in the symmetric form
    std::array<double, static_cast<std::size_t>(D* D)> stress{};
    double largest = 0.0;  ///< of the terms of the stress
};

template <int D, class Real>
PlainStress<D> plain_stress(const ParticleSet<D, Real>& set, const StressOptions& o, std::size_t i,
                            std::size_t lane, double s, double pressure) {
    const auto value = [&](const auto& lanes) { return static_cast<double>(lanes[lane]); };
    const auto g = [&](std::size_t k, std::size_t l) {
        return value(set.sums->gradient.velocity_gradient[D * k + l]);
    };
    PlainStress<D> plain;
    if (o.tensor && o.closure) {
        double strain_squared = 0.0;    // 2 S_kl S_kl
        double rotation_squared = 0.0;  // 2 W_kl W_kl
        for (std::size_t k = 0; k < D; ++k) {
            for (std::size_t l = 0; l < D; ++l) {
                const double strain = 0.5 * (g(k, l) + g(l, k));
                const double rotation = 0.5 * (g(k, l) - g(l, k));
                strain_squared += 2.0 * strain * strain;
                rotation_squared += 2.0 * rotation * rotation;
            }
        }
        const double length = set.work->mixing_length[i];
        double rate = std::sqrt(strain_squared);
        if (o.measure == StrainMeasure::rotation) rate = std::sqrt(rotation_squared);
        if (o.measure == StrainMeasure::strain_and_rotation) {
            rate = std::sqrt(std::sqrt(strain_squared * rotation_squared));
        }
        plain.eddy_viscosity = length * length * (o.shear_only ? std::abs(g(0, D - 1)) : rate);
    }
    const double ratio = 1.0 + s;
    double nu = set.particles.viscosity + (o.two_point ? plain.eddy_viscosity : 0.0);
    nu *= o.tensor ? value(set.sums->gradient.viscosity_factor) : 1.0;
    plain.viscosity_root = std::sqrt(0.5 * (o.corrected ? nu * ratio : nu / ratio));
    plain.weight = set.mass[i] / set.particles.density / (o.corrected ? ratio : 1.0);
    const double scale = o.corrected ? 1.0 : 1.0 / (ratio * ratio);
    plain.pressure = scale * pressure;
    for (std::size_t k = 0; k < D; ++k) {
        for (std::size_t l = 0; l < D; ++l) {
            const double of_pressure = plain.pressure * value(set.sums->gradient.correction[D * k + l]);
            double friction = 0.0;
            if (!o.two_point) {
                const bool shear = k != l && k + l == D - 1;
                const double twice = o.shear_only ? (shear ? g(0, D - 1) : 0.0) : g(k, l) + g(l, k);
                friction = plain.eddy_viscosity * ratio * scale * twice;
                if (D == 3) {
                    const double q = o.spanwise_ratio * o.spanwise_ratio;
                    friction *= 0.5 * ((k == 1 ? q : 1.0) + (l == 1 ? q : 1.0));
                }
            }
            plain.stress[D * k + l] = of_pressure - friction;
            plain.largest = std::max(plain.largest, std::abs(of_pressure) + std::abs(friction));
        }
    }
    return plain;
}

template <int D, class Real>
void check_stress(const ParticleLoops<D, Real>& loops, ParticleSet<D, Real>& set, const StressOptions& o) {
    set.particles.corrected = o.corrected;
    set.particles.closure = o.closure;
    set.particles.two_point = o.two_point;
    set.particles.shear_only = o.shear_only;
    set.particles.strain_measure = o.measure;
    set.particles.state.kind = o.state;
    set.particles.bulk_viscosity = o.bulk_viscosity;
    set.particles.sound_rate = 100.0;
    set.particles.shear_weight_across = 0.5 * (1.0 + o.spanwise_ratio * o.spanwise_ratio);
    set.particles.normal_weight_across = o.spanwise_ratio * o.spanwise_ratio;
    const std::size_t slots = set.cloud.clusters.slots() + 1;
    set.records.stress.resize(o.tensor ? slots : 0);
    set.records.pressure.resize(o.tensor ? 0 : slots);
    for (auto& component : set.records.correction) component.assign(o.continued ? slots : 0, Real(0));
    for (std::size_t cluster = 0; o.continued && cluster < set.cloud.clusters.size(); ++cluster) {
        set.records.correction_lane.push_back(static_cast<std::int32_t>(cluster * cluster_size));
    }
    const std::vector<double> before = set.density_deviation;
    constexpr double step = 1e-3;
    loops.stress(set.particles, set.records, *set.sums, *set.work, step, 0, set.end);

    const double c2 = 400.0;
    set.for_particles([&](std::size_t i, std::size_t slot, std::size_t lane) {
        const auto compression = static_cast<double>(set.sums->gradient.density_rate[lane]);
        // Spray bears no suction, and its density fades to that of the air's pressure.
        const double water =
            o.tensor ? static_cast<double>(share_of_water<Real>(set.sums->gradient.regularity[lane])) : 1.0;
        const double rate = (1.0 + before[i]) * compression +
                            static_cast<double>(set.sums->gradient.diffusion[lane]) -
                            (1.0 - water) * set.particles.sound_rate * before[i];
        const double s = before[i] + step * rate;
        EXPECT_NEAR(set.work->density_rate[lane], rate, 1e-14);
        EXPECT_NEAR(set.density_deviation[i], s, 1e-16);
        const double of_state = o.state == EquationOfState::linear
                                    ? c2 * s
                                    : c2 / 7.0 * (std::pow(1.0 + s, 7.0) - 1.0);  // rounding of 1: 1e-13
        const double pressure =
            (of_state < 0.0 ? water : 1.0) * of_state + o.bulk_viscosity * water * compression;
        EXPECT_NEAR(static_cast<double>(set.work->pressure[lane]), pressure,
                    rounding<Real> * std::abs(pressure) + 1e-12);
        const PlainStress<D> plain = plain_stress(set, o, i, lane, s, pressure);
        const auto expect = [&](Real value, double exact, double size, const char* what) {
            EXPECT_NEAR(static_cast<double>(value), exact, rounding<Real> * size + 1e-12)
                << what << " of " << i;
        };
        expect(set.work->eddy_viscosity[lane], plain.eddy_viscosity, plain.eddy_viscosity, "nu_t");
        const auto expect_common = [&](const auto& record) {
            expect(record.viscosity_root, plain.viscosity_root, plain.viscosity_root, "viscosity root");
            expect(record.weight, plain.weight, plain.weight, "weight");
            expect(record.pressure, plain.pressure, std::abs(plain.pressure), "pressure");
        };
        if (!o.tensor) {
            expect_common(set.records.pressure[slot]);
            EXPECT_EQ(set.records.pressure[slot].stress[0], set.records.pressure[slot].pressure);
            return;
        }
        expect_common(set.records.stress[slot]);
        for (std::size_t k = 0; k < D * D; ++k) {
            expect(set.records.stress[slot].stress[k], plain.stress[k], plain.largest, "stress");
            if (o.continued) {
                EXPECT_EQ(set.records.correction[k][slot], set.sums->gradient.correction[k][lane]);
            }
        }
    });
    // Empty slots have no weight.
    for (std::size_t slot = 0; slot < set.end * cluster_size; ++slot) {
        if (set.cloud.clusters.particle_of(slot) < 0) {
            EXPECT_EQ(o.tensor ? set.records.stress[slot].weight : set.records.pressure[slot].weight,
                      Real(0));
        }
    }
}

TEST_P(ParticleLoopsTest, StressFollowsTheFormulas) {
    const StressOptions options[] = {{},
                                     {.continued = true},
                                     {.closure = false},
                                     {.two_point = false},
                                     {.two_point = false, .spanwise_ratio = 0.5},
                                     {.shear_only = true},
                                     {.two_point = false, .shear_only = true},
                                     {.measure = StrainMeasure::rotation},
                                     {.two_point = false, .measure = StrainMeasure::strain_and_rotation},
                                     {.corrected = false},
                                     {.corrected = false, .two_point = false},
                                     {.corrected = false, .tensor = false, .closure = false},
                                     {.tensor = false, .closure = false},
                                     {.state = EquationOfState::tait},
                                     {.bulk_viscosity = 0.3}};
    for (const StressOptions& o : options) {
        for_all([&](const auto& loops, const auto& set) { check_stress(loops, *set, o); });
    }
}

/// Coefficients of the drags on a particle's component k.
struct DragSum {
    double bed = 0.0;
    double side = 0.0;
};
template <int D, class Real>
DragSum drag_sum(const ParticleSet<D, Real>& set, const AdvanceOptions& options, std::size_t i,
                 std::size_t lane, std::size_t k) {
    DragSum sum;
    if (options.drag && k + 1 < D && (set.work->drag_clusters >> lane / cluster_size & 1U) != 0) {
        sum.bed = set.work->drag[i];
    }
    const double y = set.start[1][i];
    if (D == 3 && k != 1 && (y < set.particles.layer_below || y > set.particles.layer_above)) {
        sum.side = options.side_drag;
    }
    return sum;
}

/// The accelerations that the drags report for component k.
template <int D, class Real>
void expect_drag(const ParticleSet<D, Real>& set, std::size_t k, std::size_t lane, double bed, double side,
                 double bound) {
    const ParticleWork<D, Real>& work = *set.work;
    if (k + 1 < D) {
        EXPECT_NEAR((k == 0 ? work.drag_force : work.drag_force_across)[lane], bed, bound);
    }
    if (D == 3 && k != 1) {
        EXPECT_NEAR((k == 0 ? work.side_force : work.side_force_vertical)[lane], side, bound);
    }
}

/// The sums over the drags.
template <int D, class Real>
void expect_sums(const ParticleSet<D, Real>& set, const AdvanceOptions& options,
                 const AdvanceResult<D>& result) {
    double bed = 0.0;
    double layers = 0.0;
    double largest = 0.0;
    if (D == 3 && options.sum_of_drags) {
        set.for_particles([&](std::size_t i, std::size_t, std::size_t lane) {
            const double square = set.mass[i] * set.velocity[0][i] * std::abs(set.velocity[0][i]);
            const bool side = drag_sum(set, options, i, lane, 0).side > 0.0;
            bed += drag_sum(set, options, i, lane, 0).bed * square;
            layers += side ? square : 0.0;
            largest += std::abs(square);
        });
        EXPECT_NE(layers, 0.0);
    }
    EXPECT_NEAR(result.bed_drag, bed, 1e-13 * 5.0 * largest);
    EXPECT_NEAR(result.side_layer, layers, 1e-13 * largest);
}

/// Positions before and after a step, and everything that advance() changes.
template <int D, class Real>
void check_advance(const ParticleLoops<D, Real>& loops, ParticleSet<D, Real>& set, bool corrected,
                   const AdvanceOptions& options) {
    set.particles.corrected = corrected;
    const auto position = set.position;
    const auto velocity = set.velocity;
    set.start = position;
    const AdvanceResult<D> result = loops.advance(set.particles, *set.sums, *set.work, options, 0, set.end);
    EXPECT_FALSE(result.fault);
    double largest = 0.0;
    Vec<D> slowest;
    Vec<D> fastest;
    slowest.fill(1e300);
    fastest.fill(-1e300);
    Vec<D> slowest_free = slowest;  // without drags
    Vec<D> fastest_free = fastest;
    set.for_particles([&](std::size_t i, std::size_t, std::size_t lane) {
        const double dt = options.step;
        const double factor = corrected ? 1.0 / (1.0 + set.density_deviation[i]) : 1.0;
        double squared = 0.0;
        for (std::size_t k = 0; k < D; ++k) {
            const double pairs = static_cast<double>(set.sums->force.tensor[k][lane]) +
                                 static_cast<double>(set.sums->force.viscous[k][lane]);
            double a = factor * pairs + set.particles.gravity[k];
            a += options.acceleration ? set.work->acceleration[k][lane] : 0.0;
            squared += a * a;
            double u = velocity[k][i] + dt * a;
            const double bound = dt * rounding<Real> * 20.0 + 1e-14;  // the pair sums are up to 20 m/s2
            const DragSum drag = drag_sum(set, options, i, lane, k);
            if (drag.bed + drag.side > 0.0) {
                const double free = u;
                u = set.velocity[k][i];
                const double residual = u + dt * (drag.bed + drag.side) * u * std::abs(u) - free;
                EXPECT_NEAR(residual, 0.0, bound);
                expect_drag(set, k, lane, -drag.bed * u * std::abs(u), -drag.side * u * std::abs(u),
                            bound / dt);
            }
            EXPECT_NEAR(set.velocity[k][i], u, bound);
            const double drift = options.transport ? set.work->transport[k][lane] : 0.0;
            const double free = velocity[k][i] + dt * a + drift;
            slowest_free[k] = std::min(slowest_free[k], free - bound);
            fastest_free[k] = std::max(fastest_free[k], free + bound);
            u = set.velocity[k][i] + drift;
            slowest[k] = std::min(slowest[k], u);
            fastest[k] = std::max(fastest[k], u);
            double x = position[k][i] + dt * u;
            if (set.cloud.domain.periodic[k]) {
                const double extent = set.cloud.domain.extent(static_cast<int>(k));
                x -= extent * std::floor((x - set.cloud.domain.lower[k]) / extent);
                EXPECT_GE(set.position[k][i], set.cloud.domain.lower[k]);
                EXPECT_LT(set.position[k][i], set.cloud.domain.upper[k]);
            }
            EXPECT_NEAR(set.position[k][i], x, dt * bound + 1e-14);
        }
        largest = std::max(largest, squared);
    });
    // The empty lanes repeat the last particle, without the bed's drag.
    for (std::size_t k = 0; k < D; ++k) {
        EXPECT_LE(result.slowest[k], slowest[k]);
        EXPECT_GE(result.slowest[k], std::min(slowest[k], slowest_free[k]));
        EXPECT_GE(result.fastest[k], fastest[k]);
        EXPECT_LE(result.fastest[k], std::max(fastest[k], fastest_free[k]));
    }
    if (!options.drag) {
        EXPECT_EQ(result.slowest, slowest);
        EXPECT_EQ(result.fastest, fastest);
    }
    expect_sums(set, options, result);
    // a^2 of about 30 m/s2 with pair sums rounded in Real.
    EXPECT_NEAR(result.largest, largest, 2.0 * 30.0 * 20.0 * rounding<Real> + 1e-9);
}

TEST_P(ParticleLoopsTest, AdvanceFollowsTheFormulas) {
    // Up to 0.2 m at this step: a good part of the particles crosses a periodic seam.
    constexpr double step = 0.1;
    for (const bool corrected : {true, false}) {
        for (const AdvanceOptions& options :
             {AdvanceOptions{.step = step}, AdvanceOptions{.step = step, .drag = true},
              AdvanceOptions{.step = step, .drag = true, .acceleration = true, .transport = true},
              AdvanceOptions{.step = step, .drag = true, .side_drag = 2.0, .sum_of_drags = true},
              AdvanceOptions{.step = step, .side_drag = 2.0}}) {
            for_all([&](const auto& loops, const auto& set) {
                set->particles.layer_below = 0.2;
                set->particles.layer_above = 0.6;
                // Away from the ends of the axis that is not periodic.
                auto& z = set->position[set->axes - 1];
                for (double& height : z) height = 0.15 + 0.01 * height;
                for (std::size_t k = 0; k < set->axes; ++k) set->particles.gravity[k] *= 0.1;
                check_advance(loops, *set, corrected, options);
            });
        }
    }
}

TEST_P(ParticleLoopsTest, AdvanceStaysInsideThePeriod) {
    for_all([&](const auto& loops, const auto& set) {
        *set->sums = {};
        set->particles.gravity = {};
        // At the seams and moving over them by less than a rounding of the position.
        for (std::size_t i = 0; i < set->position[0].size(); ++i) {
            const bool low = i % 2 == 0;
            set->position[0][i] = low ? 0.0 : std::nextafter(1.0, 0.0);
            set->velocity[0][i] = low ? -1e-20 : 1e-10;
        }
        EXPECT_FALSE(
            loops.advance(set->particles, *set->sums, *set->work, {.step = 1e-3}, 0, set->end).fault);
        loops.pack(set->particles, set->records, &set->moved, 0, set->end);
        set->for_particles([&](std::size_t i, std::size_t slot, std::size_t) {
            EXPECT_GE(set->position[0][i], 0.0);
            EXPECT_LT(set->position[0][i], 1.0);
            EXPECT_EQ(set->records.motion[slot].x[0], set->cloud.fixed_point.encode(set->position[0][i], 0));
        });
    });
}

TEST_P(ParticleLoopsTest, AdvanceFindsFaults) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for_all([&](const auto& loops, const auto& set) {
        constexpr double step = 1e-3;
        const std::size_t vertical = set->axes - 1;
        const auto fault = [&] {
            return loops.advance(set->particles, *set->sums, *set->work, {.step = step}, 0, set->end).fault;
        };
        // Each value in turn in the first, the last and a middle particle, and put back. Sums of a size that
        // moves nothing far.
        for (double& height : set->position[vertical]) height = 0.15 + 0.01 * height;
        const auto last = static_cast<std::size_t>(set->cloud.clusters.begin[set->end]) - 1;
        ASSERT_FALSE(fault());
        const auto expect_fault = [&](std::vector<double>& values, std::size_t i, double bad) {
            const auto position = set->position;
            const auto velocity = set->velocity;
            const double good = values[i];
            values[i] = bad;
            EXPECT_TRUE(fault()) << bad << " in particle " << i;
            set->position = position;
            set->velocity = velocity;
            values[i] = good;
            for (std::size_t k = 0; k < set->axes; ++k) {
                set->particles.position[k] = set->position[k].data();
                set->particles.velocity[k] = set->velocity[k].data();
            }
            EXPECT_FALSE(fault());
        };
        for (const std::size_t i : {std::size_t{0}, last / 2, last}) {
            for (const double bad : {nan, infinity, -infinity}) {
                expect_fault(set->density_deviation, i, bad);
                for (std::size_t k = 0; k < set->axes; ++k) {
                    expect_fault(set->velocity[k], i, bad);
                    expect_fault(set->position[k], i, bad);
                }
            }
            // Outside along z, by the step itself too; more than a period away along x.
            expect_fault(set->position[vertical], i, set->cloud.domain.upper[vertical] + 0.01);
            expect_fault(set->position[vertical], i, set->cloud.domain.lower[vertical] - 0.01);
            expect_fault(set->velocity[vertical], i, 2.0 / step);
            expect_fault(set->velocity[0], i, 3.0 / step);
        }
    });
}

TEST_P(ParticleLoopsTest, PackFollowsTheFormulas) {
    for_all([&](const auto& loops, const auto& set) {
        // Moved since the build of the clusters, over the seams too.
        for (std::size_t k = 0; k < set->axes; ++k) {
            for (double& x : set->position[k]) {
                x += set->uniform(-0.02, 0.02);
                if (set->cloud.domain.periodic[k]) {
                    const double extent = set->cloud.domain.extent(static_cast<int>(k));
                    x -= extent * std::floor(x / extent);
                }
            }
        }
        loops.pack(set->particles, set->records, &set->moved, 0, set->end);
        std::vector<std::array<std::int32_t, 3>> low(set->end, {0x7fffffff, 0x7fffffff, 0x7fffffff});
        std::vector<std::array<std::int32_t, 3>> high(set->end, {-0x7fffffff, -0x7fffffff, -0x7fffffff});
        set->for_particles([&](std::size_t i, std::size_t slot, std::size_t) {
            const auto& record = set->records.motion[slot];
            using Real = std::decay_t<decltype(record.s)>;
            const std::size_t cluster = slot / cluster_size;
            for (std::size_t k = 0; k < set->axes; ++k) {
                const std::int32_t code = set->cloud.fixed_point.encode(set->position[k][i], k);
                EXPECT_EQ(record.x[k], code);
                EXPECT_EQ(record.u[k], static_cast<Real>(set->velocity[k][i]));
                const std::int32_t moved =
                    wrapped_difference(code, set->cloud.clusters.slot_position[k][slot]);
                // About 0.02 m, whatever seam lies between.
                EXPECT_LT(std::abs(moved * set->cloud.fixed_point.unit(k)), 0.0201);
                low[cluster][k] = std::min(low[cluster][k], moved);
                high[cluster][k] = std::max(high[cluster][k], moved);
            }
            EXPECT_EQ(record.s, static_cast<Real>(set->density_deviation[i]));
            const double volume = set->mass[i] / 1000.0 / (1.0 + set->density_deviation[i]);
            EXPECT_NEAR(static_cast<double>(record.volume), volume, rounding<Real> * volume);
        });
        for (std::size_t cluster = 0; cluster < set->end; ++cluster) {
            for (std::size_t k = 0; k < set->axes; ++k) {
                EXPECT_EQ(set->moved.low[k][cluster], low[cluster][k]);
                EXPECT_EQ(set->moved.high[k][cluster], high[cluster][k]);
            }
        }
        for (std::size_t slot = 0; slot < set->end * cluster_size; ++slot) {
            if (set->cloud.clusters.particle_of(slot) < 0) {
                EXPECT_EQ(static_cast<double>(set->records.motion[slot].volume), 0.0);
            }
        }
    });
}

TEST_P(ParticleLoopsTest, OneMassForAllGivesTheSameBits) {
    for_all([&](const auto& loops, const auto& set) {
        std::fill(set->mass.begin(), set->mass.end(), 987.0);
        const auto volumes = [&](double uniform_mass) {
            set->particles.uniform_mass = uniform_mass;
            loops.pack(set->particles, set->records, nullptr, 0, set->end);
            std::vector<double> result;
            set->for_particles([&](std::size_t, std::size_t slot, std::size_t) {
                result.push_back(static_cast<double>(set->records.motion[slot].volume));
            });
            return result;
        };
        EXPECT_EQ(volumes(0.0), volumes(987.0));
        EXPECT_NE(volumes(0.0), volumes(988.0));
    });
}

TEST_P(ParticleLoopsTest, StandingBelowNamesTheClustersThatReachDown) {
    for_all([&](const auto& loops, const auto& set) {
        const auto& height = set->position[set->axes - 1];
        // Below all, at the particles themselves, above all.
        for (const double level : {-10.0, height[0], height[3], 0.25, 10.0}) {
            std::uint32_t expected = 0;
            set->for_particles([&](std::size_t i, std::size_t slot, std::size_t) {
                expected |= (height[i] <= level ? 1U : 0U) << slot / cluster_size;
            });
            EXPECT_EQ(loops.standing_below(set->particles, level, 0, set->end), expected);
        }
    });
}

INSTANTIATE_TEST_SUITE_P(All, ParticleLoopsTest,
                         testing::Values(InstructionSet::baseline, InstructionSet::avx2,
                                         InstructionSet::avx512),
                         [](const auto& instance) { return instruction_set_name(instance.param); });

}  // namespace
}  // namespace riffle::particle_loops_test

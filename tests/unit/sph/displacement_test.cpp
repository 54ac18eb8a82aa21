// When the neighbour lists still hold: the displacements of the clusters since the lists were built.

#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "particle_set.hpp"
#include "sph/neighbour_list.hpp"

namespace riffle::displacement_test {
namespace {

constexpr double support = 0.2;  // 2h, m
constexpr double skin = 0.03;

/// Lists of a set, wall particles included if wanted, and the test whether they hold.
template <int D>
struct ListedSet {
    ParticleSet<D, float> set;
    NeighbourList list;
    NeighbourList walls;
    ParticleLoops<D, float> loops = particle_loops<D, float>();

    explicit ListedSet(std::size_t count, std::uint64_t seed) : set(count, seed) {
        list = build_neighbour_list<D>(set.cloud.clusters, set.cloud.clusters, set.cloud.fixed_point,
                                       support + skin);
        set.records.fluid_fluid = &list;
    }

    /// Move each particle by `displacement(i, axis)` from where it was listed.
    template <class F>
    void move(const F& displacement) {
        for (std::size_t k = 0; k < D; ++k) {
            for (std::size_t i = 0; i < set.position[k].size(); ++i) {
                double x = set.cloud.position[k][i] + displacement(i, k);
                if (set.cloud.domain.periodic[k]) {
                    const double extent = set.cloud.domain.extent(static_cast<int>(k));
                    x -= extent * std::floor(x / extent);
                }
                set.position[k][i] = x;
            }
        }
    }

    /// Largest squared relative displacement of listed clusters, over all blocks.
    double displaced() {
        double worst = 0.0;
        const std::size_t clusters = set.cloud.clusters.size();
        for (std::size_t begin = 0; begin < clusters; begin += block_clusters) {
            loops.pack(set.particles, set.records, &set.moved, begin,
                       std::min(clusters, begin + block_clusters));
        }
        for (std::size_t begin = 0; begin < clusters; begin += 5) {
            worst = std::max(worst, loops.displaced(set.records, set.cloud.fixed_point, set.moved, begin,
                                                    std::min(clusters, begin + 5)));
        }
        return worst;
    }

    /// The clusters in the list of each cluster, those between them too.
    [[nodiscard]] std::vector<std::size_t> clusters_near(std::size_t cluster) const {
        std::vector<std::size_t> result;
        for (std::size_t r = list.run_begin[cluster]; r < list.run_begin[cluster + 1]; ++r) {
            for (std::int32_t c = 0; c < list.runs[r].count; ++c) {
                result.push_back(static_cast<std::size_t>(list.runs[r].first + c));
            }
        }
        return result;
    }

    [[nodiscard]] std::vector<std::size_t> members(std::size_t cluster) const {
        std::vector<std::size_t> result;
        for (std::int32_t i = set.cloud.clusters.begin[cluster]; i < set.cloud.clusters.begin[cluster + 1];
             ++i) {
            result.push_back(static_cast<std::size_t>(i));
        }
        return result;
    }

    /// Pairs of particles within the support now that do not stand in the lists.
    [[nodiscard]] std::size_t missing_pairs() const {
        Cloud<D> now = set.cloud;
        now.position = set.position;
        std::size_t missing = 0;
        for (std::size_t cluster = 0; cluster < list.size(); ++cluster) {
            std::vector<std::int32_t> slots(list.buffer_size());
            const std::size_t count = list.spell(cluster, slots.data());
            std::set<std::size_t> listed;
            for (std::size_t n = 0; n < count; ++n) {
                listed.insert(static_cast<std::size_t>(
                    set.cloud.clusters.particle_of(static_cast<std::size_t>(slots[n]))));
            }
            for (const std::size_t i : members(cluster)) {
                for (std::size_t j = 0; j < now.size(); ++j) {
                    missing += now.distance_squared(i, j) < support * support && listed.count(j) == 0 ? 1 : 0;
                }
            }
        }
        return missing;
    }
};

/// Displacements that are uniform, random by particle, by a linear and by a wavy field, each of random size.
template <int D>
std::function<double(std::size_t, std::size_t)> random_displacement(ListedSet<D>& listed) {
    ParticleSet<D, float>& set = listed.set;
    // Any drift along x, over the seam and round the period; less along the other axes.
    Vec<D> drift{};
    std::array<double, static_cast<std::size_t>(D * D)> gradient{};
    for (std::size_t k = 0; k < D; ++k) {
        drift[k] = k == 0 ? set.uniform(-3.0, 3.0) : (k + 1 < D ? set.uniform(-0.3, 0.3) : 0.0);
    }
    const double strain = std::pow(10.0, set.uniform(-3.0, -0.5));
    for (double& g : gradient) g = strain * set.uniform(-1.0, 1.0);
    const double noise = std::pow(10.0, set.uniform(-4.0, -1.5));
    std::vector<Vec<D>> own(set.position[0].size());
    for (Vec<D>& v : own) {
        for (double& component : v) component = noise * set.uniform(-1.0, 1.0);
    }
    return [=, &set](std::size_t i, std::size_t k) {
        double d = drift[k] + own[i][k];
        for (std::size_t l = 0; l < D; ++l) {
            // A periodic field of that strain.
            const double x = set.cloud.position[l][i];
            const double extent = set.cloud.domain.extent(static_cast<int>(l));
            d += gradient[k * D + l] * (l + 1 < D ? std::sin(6.283185307179586 * x / extent) / 6.28 : x);
        }
        return d;
    };
}

template <int D>
void check_moves(int& valid, int& invalid) {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    const auto count = *rc::gen::inRange<std::size_t>(20, D == 2 ? 400 : 900);
    ListedSet<D> listed(count, seed);
    listed.move(random_displacement(listed));
    const double worst = listed.displaced();

    // It is the distance of the boxes' far corners, of listed clusters...
    const auto& set = listed.set;
    double of_boxes = 0.0;
    for (std::size_t i = 0; i < listed.list.size(); ++i) {
        for (const std::size_t j : listed.clusters_near(i)) {
            double squared = 0.0;
            for (std::size_t k = 0; k < D; ++k) {
                const double up = wrapped_difference(set.moved.high[k][i], set.moved.low[k][j]);
                const double down = wrapped_difference(set.moved.high[k][j], set.moved.low[k][i]);
                squared += std::pow(std::max(up, down) * set.cloud.fixed_point.unit(k), 2);
            }
            of_boxes = std::max(of_boxes, squared);
        }
    }
    RC_ASSERT(std::abs(worst - of_boxes) <= 1e-6 * of_boxes);  // single precision
    // ... and while it is within the skin the lists are complete.
    (worst <= skin * skin ? valid : invalid) += 1;
    RC_ASSERT(worst > skin * skin || listed.missing_pairs() == 0);
}

template <int D>
void check_many_moves() {
    int valid = 0;
    int invalid = 0;
    EXPECT_TRUE(
        rc::check("lists that are called valid are complete", [&] { check_moves<D>(valid, invalid); }));
    // Both answers were given, or the property says nothing.
    EXPECT_GT(valid, 10);
    EXPECT_GT(invalid, 10);
}

TEST(Displacement, ValidListsAreComplete2D) { check_many_moves<2>(); }
TEST(Displacement, ValidListsAreComplete3D) { check_many_moves<3>(); }

// Only relative motion counts: a current of any speed carries its lists along, round the period too.
template <int D>
void check_uniform_drift() {
    ListedSet<D> listed(300, 5);
    for (const double drift : {0.0, 0.1, 0.25, 0.49999, 0.5, 0.50001, 0.75, 1.0, 7.3}) {
        listed.move([&](std::size_t, std::size_t k) { return k == 0 ? drift : 0.0; });
        // The codes round to a unit.
        const double unit = listed.set.cloud.fixed_point.unit(0);
        EXPECT_LE(listed.displaced(), 4.0 * unit * unit) << "drift " << drift;
        EXPECT_EQ(listed.missing_pairs(), 0U);
    }
}

TEST(Displacement, UniformDriftKeepsTheLists2D) { check_uniform_drift<2>(); }
TEST(Displacement, UniformDriftKeepsTheLists3D) { check_uniform_drift<3>(); }

// One particle alone that moves against the others by more than the skin is noticed, whichever it is.
template <int D>
void check_single_mover() {
    ListedSet<D> listed(D == 2 ? 120 : 300, 8);
    for (std::size_t mover = 0; mover < listed.set.position[0].size(); ++mover) {
        for (std::size_t axis = 0; axis < D; ++axis) {
            const auto move = [&](double distance) {
                listed.move(
                    [&](std::size_t i, std::size_t k) { return i == mover && k == axis ? distance : 0.0; });
                return listed.displaced();
            };
            EXPECT_GT(move(1.001 * skin), skin * skin);
            EXPECT_GT(move(-1.001 * skin), skin * skin);
            EXPECT_LT(move(0.999 * skin), skin * skin);
        }
    }
}

TEST(Displacement, NoticesASingleMover2D) { check_single_mover<2>(); }
TEST(Displacement, NoticesASingleMover3D) { check_single_mover<3>(); }

// Walls do not move: the absolute displacement of the clusters near them counts, and of no others.
template <int D>
void check_walls() {
    ListedSet<D> listed(300, 21);
    // Wall particles at the lower end of the box.
    Cloud<D> wall = random_cloud<D>(listed.set.cloud.domain, 40, 0.3, 4);
    for (double& z : wall.position[D - 1]) z = listed.set.cloud.domain.lower[D - 1] + 0.001;
    wall.clusters = build_clusters<D>(wall.domain, wall.fixed_point, wall.view(), 0.3);
    listed.walls = build_neighbour_list<D>(listed.set.cloud.clusters, wall.clusters,
                                           listed.set.cloud.fixed_point, support + skin);
    listed.set.records.fluid_wall = &listed.walls;
    const double drift = 1.5 * skin;
    const auto move = [&](bool near) {
        std::size_t moved = 0;
        // All particles alike, or all clusters but those near walls left where they are: then only the
        // clusters between see a difference.
        listed.move([&](std::size_t, std::size_t k) { return near && k == 0 ? drift : 0.0; });
        for (std::size_t c = 0; c < listed.list.size(); ++c) {
            moved += listed.walls.run_begin[c] < listed.walls.run_begin[c + 1] ? 1 : 0;
        }
        EXPECT_GT(moved, 0U);
        EXPECT_LT(moved, listed.list.size());
        return listed.displaced();
    };
    EXPECT_LT(move(false), 1e-12);
    EXPECT_NEAR(move(true), drift * drift, 1e-6);
    listed.set.records.fluid_wall = nullptr;
    EXPECT_LT(listed.displaced(), 1e-12);
}

TEST(Displacement, CountsAgainstWalls2D) { check_walls<2>(); }
TEST(Displacement, CountsAgainstWalls3D) { check_walls<3>(); }

}  // namespace
}  // namespace riffle::displacement_test

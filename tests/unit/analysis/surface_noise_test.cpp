// A surface that only noise moves has no celerity.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "analysis/chapters.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/surface_parts.hpp"
#include "simulated_record.hpp"

namespace riffle::surface_noise_test {
namespace {

/// White noise along a periodic line, and at the default places of wave probes.
class Noise : public test::SimulatedRecord {
  public:
    Noise() : SimulatedRecord({0.0, 6.0}, Case{}) {
        flow_->channel.depth = 0.05;
        flow_->channel.length = 0.16;
        flow_->channel.slope = 0.004;
        flow_->numerics.spacing = 0.002;
        flow_->measured.depth_mean_velocity = 0.45;
        std::mt19937_64 generator(5);
        std::normal_distribution<double> normal;
        surface_.spacing = 0.002;
        surface_.first_x = 0.001;
        surface_.columns = 80;
        surface_.periodic = true;
        for (int j = 0; j < 600; ++j) {
            surface_.times.push_back(0.01 * j);
            for (std::size_t i = 0; i < surface_.columns; ++i) {
                surface_.values.push_back(0.05 + 3e-4 * normal(generator));
            }
        }
        for (const double x : {0.0, 0.028, 0.12}) {
            ElevationProbe probe;
            probe.name = "wave";
            probe.x = x;
            probes_.push_back(std::move(probe));
        }
    }
    [[nodiscard]] const SpaceTime& surface() const override { return surface_; }
    [[nodiscard]] const std::vector<ElevationProbe>& elevation_probes() const override { return probes_; }

  private:
    SpaceTime surface_;
    std::vector<ElevationProbe> probes_;
};

TEST(SurfaceNoise, HasNoCelerity) {
    const Noise record;
    Analysis analysis;
    analyse_surface(record, analysis);
    ASSERT_NE(find_finding(analysis, "surface_standard_deviation"), nullptr);
    EXPECT_NEAR(find_finding(analysis, "surface_standard_deviation")->value, 3e-4, 1e-5);
    for (const Finding& finding : analysis.findings) {
        EXPECT_THAT(finding.key, ::testing::Not(::testing::StartsWith("celerity")))
            << finding.value << ' ' << finding.remark;
    }
}

// The place of a probe at x = 0 lies half a spacing before the first middle of a cell, that at the end of a
// periodic line is the same place, and one beyond the cells of an open line is none.
TEST(SurfaceNoise, PlacesAtTheEndsOfALineHaveAColumn) {
    const Noise record;
    SpaceTime line = record.surface();
    std::vector<ElevationProbe> probes = record.elevation_probes();
    const std::vector<SurfaceStation> all = stations_of_line(line, probes);
    ASSERT_EQ(all.size(), 3U);
    EXPECT_NEAR(all[0].x, 0.001, 1e-9);
    EXPECT_NEAR(all[1].x, 0.029, 1e-9);
    probes[2].x = 0.16;
    EXPECT_EQ(stations_of_line(line, probes).size(), 2U);
    line.periodic = false;
    const std::vector<SurfaceStation> open = stations_of_line(line, probes);
    ASSERT_EQ(open.size(), 3U);
    EXPECT_NEAR(open[2].x, 0.159, 1e-9);
    probes[2].x = 0.1613;
    EXPECT_EQ(stations_of_line(line, probes).size(), 2U);
}

}  // namespace
}  // namespace riffle::surface_noise_test

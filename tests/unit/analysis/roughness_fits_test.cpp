// Laws fitted to the flow over a bed by its roughness.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "analysis/chapters.hpp"
#include "analysis/figure_tools.hpp"
#include "simulated_record.hpp"

namespace riffle::roughness_fits_test {
namespace {

/// A log profile over a plane bed.
class OverPlaneBed : public test::SimulatedRecord {
  public:
    explicit OverPlaneBed(BedKind kind) : SimulatedRecord({0.0, 1.0}, Case{}) {
        flow_->channel.depth = 0.08;
        flow_->channel.length = 0.2;
        flow_->channel.slope = 0.003;
        flow_->bed.kind = kind;
        flow_->bed.datum_below_crest = 0.0;
        flow_->numerics.spacing = 0.004;
        flow_->measured.depth_mean_velocity = 0.5;
        if (kind == BedKind::roughness) flow_->bed.equivalent_roughness = roughness;
        for (int i = 0; i < 20; ++i) {
            profiles_.z.push_back(0.004 * (i + 0.5));
            profiles_.velocity.push_back(friction_velocity *
                                         (std::log(profiles_.z.back() / roughness) / 0.41 + 8.5));
        }
    }
    [[nodiscard]] const Profiles& profiles() const override { return profiles_; }

    static constexpr double roughness = 0.012;
    static constexpr double friction_velocity = 0.048;

  private:
    Profiles profiles_;
};

TEST(RoughnessFits, StandBesideTheRoughnessOfTheBed) {
    Analysis analysis;
    analyse_fits(OverPlaneBed(BedKind::roughness), analysis);
    const Finding* const roughness = find_finding(analysis, "equivalent_roughness");
    ASSERT_NE(roughness, nullptr);
    EXPECT_NEAR(roughness->value, OverPlaneBed::roughness, 1e-6);
    EXPECT_EQ(roughness->reference, OverPlaneBed::roughness);
    EXPECT_EQ(roughness->reference_name, "of the bed");
    EXPECT_NEAR(find_finding(analysis, "log_law_friction_velocity")->value, OverPlaneBed::friction_velocity,
                1e-6);
    ASSERT_NE(find_finding(analysis, "manning"), nullptr);
}

// A smooth bed has no roughness to fit, but the numbers of a channel.
TEST(RoughnessFits, ASmoothBedHasTheNumbersOfAChannelAlone) {
    Analysis analysis;
    analyse_fits(OverPlaneBed(BedKind::smooth), analysis);
    EXPECT_EQ(find_finding(analysis, "equivalent_roughness"), nullptr);
    ASSERT_NE(find_finding(analysis, "friction_factor"), nullptr);
    // Waves run by the part of gravity across the bed, and the energy falls by the sine of its slope.
    const double cosine = 1.0 / std::sqrt(1.0 + 0.003 * 0.003);
    EXPECT_NEAR(find_finding(analysis, "froude")->value, 0.5 / std::sqrt(9.81 * cosine * 0.08), 1e-9);
    EXPECT_NEAR(find_finding(analysis, "chezy")->value, 0.5 / std::sqrt(0.08 * 0.003 * cosine), 1e-9);
}

// Between two walls the hydraulic radius is half of their distance, and there is no surface to have waves.
TEST(RoughnessFits, BetweenTwoWallsTheRadiusIsHalf) {
    OverPlaneBed plates(BedKind::no_slip);
    plates.flow_->channel.top = Top::wall;
    Analysis analysis;
    analyse_fits(plates, analysis);
    ASSERT_NE(find_finding(analysis, "friction_factor"), nullptr);
    EXPECT_NEAR(find_finding(analysis, "friction_factor")->value,
                8.0 * plates.flow_->streamwise_gravity() * 0.04 / 0.25, 1e-9);
    for (const char* const key : {"manning", "chezy", "froude"}) {
        EXPECT_EQ(find_finding(analysis, key), nullptr) << key;
    }
}

TEST(RoughnessFits, ASlipBedHasNone) {
    Analysis analysis;
    analyse_fits(OverPlaneBed(BedKind::slip), analysis);
    EXPECT_TRUE(analysis.findings.empty());
}

}  // namespace
}  // namespace riffle::roughness_fits_test

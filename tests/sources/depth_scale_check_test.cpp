#include "depth_scale_check.h"

#include <gmock/gmock.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <array>

namespace wardslam::sources {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Optional;

class DepthScale : public ::testing::Test {
 protected:
  /// What is said of images in which each column of 4 pixels is so far away (metres, 0 = nothing measured).
  static std::optional<std::string> saidOf(const std::array<double, 20>& depths_m, double unitsPerMetre = 5000.0) {
    mrpt::obs::CObservation3DRangeScan scan;
    scan.rangeUnits = static_cast<float>(1.0 / unitsPerMetre);
    scan.rangeImage_setSize(8, 80);
    for (int y = 0; y < 8; ++y) {
      for (int x = 0; x < 80; ++x) {
        const double units = depths_m.at(static_cast<std::size_t>(x) / 4) * unitsPerMetre;
        scan.rangeImage(y, x) = static_cast<std::uint16_t>(units);
      }
    }
    DepthScaleCheck check;
    std::optional<std::string> said;
    for (int i = 0; i < 20; ++i) {
      const auto now = check.add(scan);
      EXPECT_FALSE(said && now) << "said twice";
      if (now) said = now;
    }
    return said;
  }

  static std::array<double, 20> filled(double most_m, double last_m = 0.0, std::size_t lastCount = 0) {
    std::array<double, 20> depths{};
    depths.fill(most_m);
    for (std::size_t i = 0; i < lastCount; ++i) depths[19 - i] = last_m;
    return depths;
  }
};

TEST_F(DepthScale, RoomsAndDesksPassWithoutAWord) {
  EXPECT_EQ(saidOf(filled(2.0, 6.0, 5)), std::nullopt);
  EXPECT_EQ(saidOf(filled(0.9, 0.45, 1)), std::nullopt) << "a desk";
  EXPECT_EQ(saidOf(filled(2.2, 0.4, 5)), std::nullopt) << "something is held close to the camera";
  EXPECT_EQ(saidOf(filled(4.0, 12.0, 1)), std::nullopt) << "a door that is open";
  EXPECT_EQ(saidOf(filled(0.0)), std::nullopt) << "nothing was measured";
}

TEST_F(DepthScale, MostlyTooNearOrTooFarIsSaid) {
  EXPECT_THAT(saidOf(filled(0.4)), Optional(AllOf(HasSubstr("nearer than 0.5 m"), HasSubstr("5000 units"))));
  EXPECT_THAT(saidOf(filled(9.0), 1000.0), Optional(AllOf(HasSubstr("farther than 8 m"), HasSubstr("1000 units"))));
}

// Millimetres of a room of 6 m, read as 5000 a metre: nothing is 0.5 m away for most pixels, nor farther than 1.2 m.
TEST_F(DepthScale, ARoomThatShrankIsSaid) {
  EXPECT_THAT(saidOf(filled(0.9, 0.35, 6)), Optional(HasSubstr("hardly any depth lies farther than 1.5 m")));
}

// 5000 a metre, read as millimetres: a desk at 4.5 m, and the wall behind it at 16 m.
TEST_F(DepthScale, ARoomThatGrewIsSaid) {
  EXPECT_THAT(saidOf(filled(4.5, 16.0, 3), 1000.0), Optional(HasSubstr("farther than 10 m")));
}

}  // namespace
}  // namespace wardslam::sources

#include "merged_zones.h"

#include <gmock/gmock.h>

namespace wardslam::merging {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

mapping::Zone square(const std::string& name, double x_m, double y_m) {
  return {name, {{x_m, y_m}, {x_m + 1, y_m}, {x_m + 1, y_m + 1}, {x_m, y_m + 1}}};
}

/// Two maps of one keyframe each, in (0, 0, 1) of its own frame; the second was found to lie 10 m along x and turned to
/// the left by 90 degrees.
class MergedZonesTest : public testing::Test {
 protected:
  MergedZonesTest() : runs_(2) {
    const Eigen::Isometry3d T_first_second =
        Eigen::Translation3d(10, 0, 0) * Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ());
    for (std::uint32_t i = 0; i < 2; ++i) {
      runs_[i].name = i == 0 ? "a.wardmap" : "b.wardmap";
      runs_[i].map.semantic.piece = i + 1;
      auto& keyframe = runs_[i].map.semantic.keyframes[i + 1];
      keyframe.piece = i + 1;
      keyframe.T_map_cam.translation().z() = 1.0;
      joined_.T_joined_cam[i + 1] = i == 0 ? keyframe.T_map_cam : T_first_second * keyframe.T_map_cam;
      joined_.pieces.add(i + 1, i + 1);
    }
    joined_.map = 1;
  }
  void join() { joined_.pieces.join({2, 1}); }
  auto& zonesOf(std::size_t run) { return runs_[run].map.semantic.zones; }

  std::vector<merging::Run> runs_;
  JoinedRuns joined_;
};

TEST_F(MergedZonesTest, ZonesGoWithTheirKeyframes) {
  join();
  zonesOf(0) = {square("a", 0, 0)};
  zonesOf(1) = {square("b", 2, 0)};
  const auto merged = mergeZones(runs_, joined_);
  EXPECT_THAT(merged.notes, IsEmpty());
  ASSERT_EQ(merged.zones.size(), 2U);
  EXPECT_EQ(merged.zones[0].polygon_m[2], Eigen::Vector2d(1, 1)) << "to the bit";
  EXPECT_EQ(merged.zones[1].name, "b");
  EXPECT_TRUE(merged.zones[1].polygon_m[0].isApprox(Eigen::Vector2d(10, 2), 1e-9)) << "(2, 0), turned";
  EXPECT_TRUE(merged.zones[1].polygon_m[1].isApprox(Eigen::Vector2d(10, 3), 1e-9)) << "(3, 0), turned";
}

TEST_F(MergedZonesTest, OneZoneDrawnInBothMapsIsOne) {
  join();
  zonesOf(0) = {square("ward", 9, 0)};
  zonesOf(1) = {square("ward", 0.02, 0)};  // turned: x from 9 to 10, y from 0.02 to 1.02
  const auto merged = mergeZones(runs_, joined_);
  EXPECT_THAT(merged.notes, IsEmpty());
  ASSERT_EQ(merged.zones.size(), 1U);
  EXPECT_EQ(merged.zones[0].polygon_m[0], Eigen::Vector2d(9, 0)) << "as it was drawn first";
}

TEST_F(MergedZonesTest, OfTwoOfOneNameTheLaterStaysAndItIsSaid) {
  join();
  zonesOf(0) = {square("ward", 9, 0)};
  zonesOf(1) = {square("ward", 0.3, 0)};  // 0.7 of 1.3 in common
  const auto merged = mergeZones(runs_, joined_);
  ASSERT_EQ(merged.zones.size(), 1U);
  EXPECT_NEAR(merged.zones[0].polygon_m[0].y(), 0.3, 1e-9);
  EXPECT_THAT(merged.notes, ElementsAre(HasSubstr("zone 'ward' is elsewhere in a.wardmap than in b.wardmap")));
}

TEST_F(MergedZonesTest, ADirectionTurnsWithItsMap) {
  join();
  zonesOf(1) = {square("b", 2, 0)};
  zonesOf(1)[0].type = mapping::ZoneType::OneWay;
  zonesOf(1)[0].direction_rad = 0.5;
  const auto merged = mergeZones(runs_, joined_);
  ASSERT_EQ(merged.zones.size(), 1U);
  EXPECT_NEAR(merged.zones[0].direction_rad, 0.5 + M_PI / 2.0, 1e-9);
}

TEST_F(MergedZonesTest, OfTwoThatAskForSomethingElseTheLaterStaysAndItIsSaid) {
  join();
  zonesOf(0) = {square("ward", 9, 0)};
  zonesOf(1) = {square("ward", 0.02, 0)};
  zonesOf(1)[0].type = mapping::ZoneType::Forbidden;
  const auto merged = mergeZones(runs_, joined_);
  ASSERT_EQ(merged.zones.size(), 1U);
  EXPECT_EQ(merged.zones[0].type, mapping::ZoneType::Forbidden);
  EXPECT_THAT(merged.notes, ElementsAre(HasSubstr("zone 'ward' asks for something else in a.wardmap")));
}

TEST_F(MergedZonesTest, ZonesOfAMapThatNothingConnectsAreLeftOutAndItIsSaid) {
  zonesOf(1) = {square("ward", 0, 0)};
  const auto merged = mergeZones(runs_, joined_);
  EXPECT_THAT(merged.zones, IsEmpty());
  EXPECT_THAT(merged.notes, ElementsAre(HasSubstr("zone 'ward' of b.wardmap is left out")));
}

}  // namespace
}  // namespace wardslam::merging

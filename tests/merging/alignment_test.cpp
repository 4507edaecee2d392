#include "wardslam/merging/alignment.h"

#include <gtest/gtest.h>

#include "merging/meeting_maps.h"

namespace wardslam::merging {
namespace {

void goOn(const Progress& /*progress*/) {}

TEST(AlignmentTest, IsWhereTheOtherMapBegan) {
  const test::MeetingMaps maps;
  const Eigen::Isometry3d T_a_b = maps.runs().walk.T_first_cam(17);  // each map begins in its first keyframe
  const auto found = align(maps.a(), maps.b(), {}, goOn);
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->haveOneFrame);
  EXPECT_LT(test::distance_m(found->T_a_b, T_a_b), 0.02);
  EXPECT_LT(test::angle_rad(found->T_a_b, T_a_b), 0.01);
  EXPECT_GE(found->looks, 2U);
  EXPECT_GT(found->covariance(0, 0), 0.0);

  const auto back = align(maps.b(), maps.a(), {}, goOn);
  ASSERT_TRUE(back);
  EXPECT_LT(test::distance_m(back->T_a_b, T_a_b.inverse()), 0.02) << "and the other way round";
}

TEST(AlignmentTest, IsUnknownWhereNoPlaceIsInCommon) {
  const test::MeetingMaps maps(false);
  EXPECT_FALSE(align(maps.a(), maps.b(), {}, goOn));
}

TEST(AlignmentTest, AMapAndItselfHaveOneFrame) {
  const test::MeetingMaps maps;
  std::filesystem::copy_file(maps.a(), maps.file("grown.wardmap"));
  const auto found = align(maps.a(), maps.file("grown.wardmap"), {}, goOn);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->haveOneFrame);
  EXPECT_TRUE(found->T_a_b.isApprox(Eigen::Isometry3d::Identity()));
}

}  // namespace
}  // namespace wardslam::merging

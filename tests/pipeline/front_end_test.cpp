#include "wardslam/pipeline/front_end.h"

#include <gtest/gtest.h>

#include "support/textured_room_scan.h"
#include "wardslam/core/errors.h"

namespace wardslam::pipeline {
namespace {

SlamOptions withoutFilters() {
  SlamOptions options;
  options.filters = SlamOptions::noFilters();
  return options;
}

TEST(FrontEnd, TracksWithoutAMap) {
  const test::TexturedRoom room;
  SlamOptions options = withoutFilters();
  options.map_frame.start_pose = "0 0 0 0 0 0 1";
  FrontEnd frontEnd(options);
  FrontEnd::Result result;
  for (int image = 0; image < 5; ++image) result = frontEnd.process(test::observe(room, image));
  EXPECT_EQ(result.frame.index, 4U);
  EXPECT_GT(result.frame.features.size(), 100U);
  ASSERT_TRUE(result.odometry.hasPose());
  const Eigen::Isometry3d T_first_last =
      test::TexturedRoom::T_room_cam(0).inverse() * test::TexturedRoom::T_room_cam(4);
  EXPECT_LT((result.odometry.T_map_cam.translation() - T_first_last.translation()).norm(), 0.01);
}

TEST(FrontEnd, KnowsWhoMovesWithoutASegmenter) {
  const FrontEnd frontEnd(withoutFilters());
  EXPECT_TRUE(frontEnd.movers()[1]);    // person
  EXPECT_FALSE(frontEnd.movers()[57]);  // chair
  EXPECT_EQ(frontEnd.labelSpace().name(1), "person");
}

TEST(FrontEnd, RefusesAStartPoseThatIsNone) {
  SlamOptions options = withoutFilters();
  options.map_frame.start_pose = "somewhere";
  EXPECT_THROW(FrontEnd{options}, core::InputError);
}

}  // namespace
}  // namespace wardslam::pipeline

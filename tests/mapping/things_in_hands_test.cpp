#include "things_in_hands.h"

#include <gtest/gtest.h>

#include "mapping/scene.h"

namespace wardslam::mapping {
namespace {

knowledge::ClassSet moving() {
  knowledge::ClassSet classes;
  classes.set(scene::kPerson);
  return classes;
}

View view() {
  return scene::render({scene::wall(),
                        scene::chair(2, 0.6, 1),
                        scene::chair(2, -0.6, 2),
                        {scene::box({1.8, 0, 0.9}, {0.2, 0.3, 1.8}), scene::kPerson, 3, {}}},
                       scene::cameraAt({0, 0, 1}), 1.0);
}

TEST(ThingsInHandsTest, IsTheThingMostOfWhichMayMove) {
  View v = view();
  v.mayMove = (v.segmentation.instanceIds == 1) | (v.segmentation.instanceIds == 3);
  const auto things = thingsInHands(v, moving());
  ASSERT_EQ(things.size(), 1U);
  EXPECT_EQ(things[0].classId, scene::kChair);
  EXPECT_NEAR(things[0].p_cam_m.x(), -0.6, 0.1);  // to the left
  EXPECT_NEAR(things[0].p_cam_m.z(), 1.75, 0.1);
}

TEST(ThingsInHandsTest, ATouchedCornerDoesNotMakeAThingHandled) {
  View v = view();
  v.mayMove = v.segmentation.instanceIds == 1;
  v.mayMove.rowRange(0, 7 * v.mayMove.rows / 8).setTo(0);
  EXPECT_TRUE(thingsInHands(v, moving()).empty());
}

TEST(ThingsInHandsTest, WithoutMasksNothingIsKnown) {
  EXPECT_TRUE(thingsInHands(view(), moving()).empty());
  View v = view();
  v.mayMove = cv::Mat(v.depth_m.size(), CV_8UC1, cv::Scalar(255));
  v.segmentation = {};
  EXPECT_TRUE(thingsInHands(v, moving()).empty());
}

}  // namespace
}  // namespace wardslam::mapping

#include "wardslam/change/moving_regions.h"

#include <gtest/gtest.h>

#include "change/moving_scene.h"
#include "wardslam/change/scene_motion.h"

namespace wardslam::change {
namespace {

using test::camera;
using test::kFrameTime_s;
using test::Scene;

const cv::Mat kNothing = cv::Mat::zeros(test::kHeight, test::kWidth, CV_8UC1);

cv::Mat regionsOf(const Eigen::Vector3d& cameraVelocity, const Eigen::Vector3d& personVelocity, cv::Mat& person,
                  const cv::Mat& explained = kNothing) {
  Scene scene;
  scene.add(test::person());
  SceneMotion motion{SceneMotionOptions{}};
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  for (int i = 0; i < 20; ++i) {
    const core::Frame frame = scene.frame(i * kFrameTime_s, position);
    motion.update(frame);
    person = frame.depth_m < 2.0;
    position += cameraVelocity * kFrameTime_s;
    scene.board(0).p_map_m += personVelocity * kFrameTime_s;
  }
  return movingRegions(motion, camera(), explained, {});
}

double share(const cv::Mat& regions, const cv::Mat& of) {
  return static_cast<double>(cv::countNonZero(regions & of)) / cv::countNonZero(of);
}

TEST(MovingRegions, CoverTheWholePersonAndNothingElse) {
  cv::Mat person;
  const cv::Mat regions = regionsOf({0, 0, 0}, {0.5, 0, 0}, person);
  EXPECT_GT(share(regions, person), 0.9);
  EXPECT_LT(share(regions, ~person), 0.05);
}

TEST(MovingRegions, CoverHimFromAMovingCameraToo) {
  cv::Mat person;
  const cv::Mat regions = regionsOf({0.2, 0, 0.1}, {-0.2, 0, -0.4}, person);
  EXPECT_GT(share(regions, person), 0.9);
  EXPECT_LT(share(regions, ~person), 0.05);
}

TEST(MovingRegions, StartFromWhatIsNotExplained) {
  cv::Mat person;
  EXPECT_EQ(cv::countNonZero(regionsOf({0, 0, 0}, {0.5, 0, 0}, person, kNothing == 0)), 0);

  cv::Mat lowerHalf = kNothing.clone();
  lowerHalf.rowRange(test::kHeight / 2, test::kHeight).setTo(255);
  const cv::Mat regions = regionsOf({0, 0, 0}, {0.5, 0, 0}, person, lowerHalf);
  EXPECT_GT(share(regions, person & ~lowerHalf), 0.9);
  EXPECT_LT(share(regions, ~person), 0.05);
}

TEST(MovingRegions, AreEmptyWhenNothingMoves) {
  cv::Mat person;
  EXPECT_LT(cv::countNonZero(regionsOf({0.3, 0, 0.2}, {0, 0, 0}, person)), 640 * 480 / 200);
}

TEST(MovingRegions, AreEmptyAtTheFirstImage) {
  SceneMotion motion{SceneMotionOptions{}};
  motion.update(Scene().frame(0, {0, 0, 0}));
  EXPECT_EQ(cv::countNonZero(movingRegions(motion, camera(), kNothing, {})), 0);
}

}  // namespace
}  // namespace wardslam::change

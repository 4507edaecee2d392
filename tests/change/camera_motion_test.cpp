#include "camera_motion.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "change/moving_scene.h"
#include "wardslam/core/depth_noise.h"

namespace wardslam::change {
namespace {

using test::camera;

Eigen::Isometry3d motionOf(double turn_rad, const Eigen::Vector3d& translation_m) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = Eigen::AngleAxisd(turn_rad, Eigen::Vector3d(0.2, 1.0, 0.1).normalized()).toRotationMatrix();
  T.translation() = translation_m;
  return T;
}

PointMatch matchOf(const Eigen::Vector3d& p_a_m, const Eigen::Isometry3d& T_b_a, cv::RNG& random, double weight = 0.5) {
  PointMatch match;
  const Eigen::Vector3d p_b = T_b_a * p_a_m;
  match.p_a_m = p_a_m;
  match.b_px = camera().project(p_b) + Eigen::Vector2d(random.gaussian(0.5), random.gaussian(0.5));
  match.bDepth_m = p_b.z() + random.gaussian(core::DepthNoise().sigma_m(p_b.z()));
  match.weight = weight;
  return match;
}

/// Points seen within a part of image a.
void add(std::vector<PointMatch>& matches, int count, cv::Rect part_px, double near_m, double far_m,
         const Eigen::Isometry3d& T_b_a, cv::RNG& random, double weight = 0.5) {
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector2d px(random.uniform(part_px.x, part_px.br().x), random.uniform(part_px.y, part_px.br().y));
    matches.push_back(matchOf(camera().unproject(px, random.uniform(near_m, far_m)), T_b_a, random, weight));
  }
}

double angle_rad(const Eigen::Isometry3d& T) { return Eigen::AngleAxisd(T.linear()).angle(); }

void expectNear(const Eigen::Isometry3d& found, const Eigen::Isometry3d& truth) {
  const Eigen::Isometry3d off = truth.inverse() * found;
  EXPECT_LT(off.translation().norm(), 0.01);
  EXPECT_LT(angle_rad(off), 0.004);
}

const cv::Rect kImage(40, 40, 560, 400);
const cv::Rect kMiddle(220, 120, 200, 300);

TEST(SquaredError, IsInUnitsOfNoise) {
  PointMatch match;
  match.p_a_m = {0, 0, 2};
  match.b_px = {320 + 3, 240 + 4};
  const Eigen::Isometry3d still = Eigen::Isometry3d::Identity();
  EXPECT_NEAR(squaredError(match, still, camera()), 25.0, 1e-9) << "five pixels, no depth";
  match.sigma_px = 2.0;
  EXPECT_NEAR(squaredError(match, still, camera()), 6.25, 1e-9);

  match.b_px = {320, 240};
  match.sigma_px = 1.0;
  match.bDepth_m = 2.1;
  const double s2 = 0.0012 + 0.0019 * 1.6 * 1.6;
  const double s21 = 0.0012 + 0.0019 * 1.7 * 1.7;
  const double variance = s2 * s2 + s21 * s21 + 0.021 * 0.021 + std::pow(1.7 / 500 * 2.1, 2);
  EXPECT_NEAR(squaredError(match, still, camera()), 0.1 * 0.1 / variance, 1e-9);

  EXPECT_TRUE(std::isinf(squaredError(match, motionOf(0, {0, 0, -3}), camera()))) << "behind the camera";
}

TEST(CameraMotion, IsFoundFromAFarGuess) {
  cv::RNG random(1);
  const auto truth = motionOf(0.3, {0.1, 0.05, -0.2});
  std::vector<PointMatch> matches;
  add(matches, 100, kImage, 1.0, 4.0, truth, random);
  const auto motion = CameraMotionEstimator({}).estimate(matches, camera(), {Eigen::Isometry3d::Identity()});
  EXPECT_TRUE(motion.isTrusted);
  EXPECT_LT(motion.noiseScale, 1.2);
  expectNear(motion.T_b_a, truth);
}

TEST(CameraMotion, IsThatOfTheSceneNotOfAMoverRichInTexture) {
  cv::RNG random(2);
  const auto truth = motionOf(0.05, {0.02, 0, 0});
  const auto mover = motionOf(0.05, {0.15, 0, 0.05});
  std::vector<PointMatch> matches;
  add(matches, 80, kImage, 2.0, 4.0, truth, random);
  add(matches, 160, kMiddle, 1.2, 1.4, mover, random);
  const auto motion = CameraMotionEstimator({}).estimate(matches, camera(), {Eigen::Isometry3d::Identity()});
  EXPECT_TRUE(motion.isTrusted);
  expectNear(motion.T_b_a, truth);
}

TEST(CameraMotion, WhatIsKnownToRestDecidesEvenWhenItIsTheLesserPart) {
  cv::RNG random(3);
  const auto truth = motionOf(0.05, {0.02, 0, 0});
  const auto mover = motionOf(0.02, {0.15, 0, 0.05});
  std::vector<PointMatch> matches;
  add(matches, 40, {40, 40, 560, 100}, 2.0, 4.0, truth, random, 0.95);
  add(matches, 300, {40, 150, 560, 300}, 1.2, 1.4, mover, random, 0.5);
  const auto motion = CameraMotionEstimator({}).estimate(matches, camera(), {mover});
  EXPECT_TRUE(motion.isTrusted);
  expectNear(motion.T_b_a, truth);
}

TEST(CameraMotion, AConsensusOfMoversIsNotTrusted) {
  cv::RNG random(4);
  std::vector<PointMatch> matches;
  add(matches, 200, kImage, 1.2, 1.4, motionOf(0.02, {0.15, 0, 0.05}), random, 0.15);
  EXPECT_FALSE(CameraMotionEstimator({}).estimate(matches, camera(), {}).isTrusted);
}

TEST(CameraMotion, NeedsPointsAllOverTheImage) {
  cv::RNG random(5);
  const auto truth = motionOf(0.05, {0.02, 0, 0});
  std::vector<PointMatch> few;
  add(few, 10, kImage, 1.0, 4.0, truth, random);
  EXPECT_FALSE(CameraMotionEstimator({}).estimate(few, camera(), {}).isTrusted);
  EXPECT_FALSE(CameraMotionEstimator({}).estimate({}, camera(), {}).isTrusted);

  std::vector<PointMatch> corner;
  add(corner, 100, {40, 40, 60, 60}, 1.0, 4.0, truth, random);
  EXPECT_FALSE(CameraMotionEstimator({}).estimate(corner, camera(), {}).isTrusted) << "two by two of 48 cells";
}

TEST(CameraMotion, InAFastTurnAMoverDoesNotBlendWithTheScene) {
  cv::RNG random(8);
  const auto truth = motionOf(0.1, {0, 0, 0});
  const auto mover = motionOf(0.1, {0.05, 0, 0});
  std::vector<PointMatch> matches;
  add(matches, 150, kImage, 2.5, 3.5, truth, random);
  add(matches, 80, kMiddle, 1.4, 1.6, mover, random);
  for (PointMatch& match : matches) match.sigma_px = 5.0;  // as it would be were the images blurred
  const auto motion = CameraMotionEstimator({}).estimate(matches, camera(), {Eigen::Isometry3d::Identity()});
  EXPECT_TRUE(motion.isTrusted);
  expectNear(motion.T_b_a, truth);
}

TEST(CameraMotion, TellsWhenTheSceneIsNoisierThanExpected) {
  cv::RNG random(6);
  const auto truth = motionOf(0.02, {0.05, 0, 0});
  std::vector<PointMatch> matches;
  add(matches, 200, kImage, 2.0, 4.0, truth, random, 0.9);
  for (PointMatch& match : matches) match.b_px += Eigen::Vector2d(random.gaussian(3.0), random.gaussian(3.0));
  const auto motion = CameraMotionEstimator({}).estimate(matches, camera(), {truth});
  EXPECT_GT(motion.noiseScale, 1.5);
}

TEST(CameraMotion, RepeatsExactly) {
  cv::RNG random(7);
  std::vector<PointMatch> matches;
  add(matches, 60, kImage, 1.0, 4.0, motionOf(0.3, {0.1, 0.05, -0.2}), random);
  add(matches, 60, kImage, 1.0, 4.0, motionOf(0.1, {0.0, 0.3, -0.2}), random);
  const auto first = CameraMotionEstimator({}).estimate(matches, camera(), {});
  const auto second = CameraMotionEstimator({}).estimate(matches, camera(), {});
  EXPECT_EQ(first.T_b_a.matrix(), second.T_b_a.matrix());
}

}  // namespace
}  // namespace wardslam::change

#include "wardslam/odometry/map_update.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "odometry/odometry_fixture.h"
#include "wardslam/odometry/map_point.h"

namespace wardslam::odometry {
namespace {

// Two keyframes ahead of a mapper that lags: whichever is the newest it knows, the other one follows.
TEST(MapUpdate, WhatFollowsCorrectionsForLongStaysRigid) {
  const Eigen::Isometry3d turn(Eigen::AngleAxisd(1e-3, Eigen::Vector3d(1, 2, 2) / 3));
  Eigen::Isometry3d T_map_newest(Eigen::AngleAxisd(2.5, Eigen::Vector3d::UnitX()));
  Eigen::Isometry3d T_map_younger(Eigen::AngleAxisd(-1.2, Eigen::Vector3d::UnitY()));
  for (int i = 0; i < 200; ++i) {
    MapUpdate update;
    update.newestKeyframe = 1;
    update.T_map_cam[1] = turn * T_map_newest;
    T_map_younger = correctionOf(update, T_map_newest) * T_map_younger;
    T_map_newest = update.T_map_cam[1];
    std::swap(T_map_newest, T_map_younger);
  }
  const Eigen::Matrix3d R = T_map_newest.linear();
  EXPECT_LT((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), 1e-12);
}

/// Two cameras that see the same; the map tells one of them that it all lies elsewhere.
class OdometryCorrected : public OdometryTest {
 protected:
  struct Both {
    OdometryResult corrected;
    OdometryResult untouched;
  };

  /// No image: both are where they believed to be.
  Both trackBoth(int image) {
    stamp_s_ += 1.0 / 30;
    const auto features =
        image < 0 ? core::Features{} : world_.look(SyntheticWorld::T_world_cam(image, kImages), kNoise);
    Both both{odometry_.track(stamp_s_, SyntheticWorld::camera(), features),
              untouched_.track(stamp_s_, SyntheticWorld::camera(), features)};
    if (both.corrected.keyframe) keyframes_.push_back(both.corrected.keyframe);
    return both;
  }
  Both trackUntilKeyframes(std::size_t count) {
    Both both;
    while (keyframes_.size() < count) both = trackBoth(image_++);
    return both;
  }

  /// What a mapper says that has worked in so many keyframes, has closed a loop, and finds all it knows elsewhere.
  [[nodiscard]] MapUpdate correctionUpTo(std::size_t count, const Eigen::Isometry3d& correction) const {
    MapUpdate update;
    update.movesTheMap = true;
    for (std::size_t k = 0; k < count; ++k) {
      const Keyframe& keyframe = *keyframes_[k];
      update.newestKeyframe = keyframe.id;
      update.T_map_cam[keyframe.id] = correction * keyframe.T_map_cam;
      for (const Sighting& sighting : keyframe.sightings) {
        const auto& keypoint = keyframe.features.keypoints[sighting.keypoint];
        const MapPoint point = makeMapPoint(keypoint, {}, keyframe.camera, keyframe.T_map_cam);
        update.p_map_m.try_emplace(sighting.point, correction * point.p_map_m);
      }
    }
    return update;
  }

  Odometry untouched_{options()};
  std::vector<std::shared_ptr<const Keyframe>> keyframes_;
  int image_ = 0;
  const Eigen::Isometry3d correction_ =
      Eigen::Translation3d(0.5, -0.2, 0.1) * Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY());
};

TEST_F(OdometryCorrected, TheCameraMovesAlongWithItsKeyframe) {
  trackUntilKeyframes(1);
  trackBoth(image_++);
  EXPECT_TRUE(odometry_.apply(correctionUpTo(1, correction_)).isApprox(correction_, 1e-9));
  const auto [corrected, untouched] = trackBoth(-1);
  EXPECT_TRUE(corrected.T_map_cam.isApprox(correction_ * untouched.T_map_cam, 1e-9));
  EXPECT_TRUE(corrected.T_keyframe_cam.isApprox(untouched.T_keyframe_cam, 1e-9));
}

TEST_F(OdometryCorrected, WhatTheMapperDidNotKnowYetFollowsTheNewestKeyframeItKnew) {
  trackUntilKeyframes(4);
  trackBoth(image_++);
  odometry_.apply(correctionUpTo(2, correction_));
  for (int i = 0; i < 3; ++i) {
    const auto [corrected, untouched] = trackBoth(image_++);
    ASSERT_EQ(corrected.state, State::Ok);
    EXPECT_LT(distance_m(corrected.T_map_cam, correction_ * untouched.T_map_cam), 0.003);
    EXPECT_LT(distance_m(corrected.T_keyframe_cam, untouched.T_keyframe_cam), 0.003) << "no step in the trajectory";
    EXPECT_GT(corrected.inliers, untouched.inliers * 4 / 5) << "points of younger keyframes are where they belong";
  }
}

/// Where a piece joins the map its frame may be turned any way round.
TEST_F(OdometryCorrected, GoesOnWhereTheMapTurnsRound) {
  trackUntilKeyframes(2);
  trackBoth(image_++);
  const Eigen::Isometry3d turned = correction_ * Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitY());
  odometry_.apply(correctionUpTo(2, turned));
  const auto [corrected, untouched] = trackBoth(image_++);
  ASSERT_EQ(corrected.state, State::Ok);
  EXPECT_LT(distance_m(corrected.T_map_cam, turned * untouched.T_map_cam), 0.003);
  EXPECT_GT(corrected.inliers, untouched.inliers * 4 / 5);
}

TEST_F(OdometryCorrected, WhatIsYoungerStaysWhereOnlyAFewKeyframesWereAdjusted) {
  trackUntilKeyframes(4);
  trackBoth(image_++);
  MapUpdate adjustment = correctionUpTo(2, correction_);
  adjustment.movesTheMap = false;
  adjustment.p_map_m.clear();
  EXPECT_TRUE(odometry_.apply(adjustment).isApprox(Eigen::Isometry3d::Identity(), 1e-12));
  const auto [corrected, untouched] = trackBoth(image_++);
  EXPECT_TRUE(corrected.T_map_cam.isApprox(untouched.T_map_cam, 1e-9));
  EXPECT_TRUE(corrected.T_keyframe_cam.isApprox(untouched.T_keyframe_cam, 1e-9));
}

TEST_F(OdometryCorrected, ACorrectionIsNotAppliedTwice) {
  trackUntilKeyframes(3);
  trackBoth(image_++);
  odometry_.apply(correctionUpTo(1, correction_));
  EXPECT_TRUE(odometry_.apply(correctionUpTo(2, correction_)).isApprox(Eigen::Isometry3d::Identity(), 1e-9))
      << "the mapper places a keyframe by the one before, too";
  const auto [corrected, untouched] = trackBoth(-1);
  EXPECT_TRUE(corrected.T_map_cam.isApprox(correction_ * untouched.T_map_cam, 1e-9));
}

TEST_F(OdometryCorrected, ALateUpdateOfASubmapThatWasLeftChangesNothing) {
  trackUntilKeyframes(2);
  const MapUpdate late = correctionUpTo(2, correction_);
  for (int i = 0; i <= options().max_lost_frames; ++i) trackBoth(-1);
  const auto begun = trackBoth(image_++).corrected;
  ASSERT_NE(begun.keyframe, nullptr);
  ASSERT_EQ(begun.keyframe->submap, 1U);
  MapUpdate recalling = late;
  recalling.recalledKeyframes[1] = {1};
  recalling.recalledPoints[1] = MapPoint();
  EXPECT_TRUE(odometry_.apply(recalling).isApprox(Eigen::Isometry3d::Identity(), 1e-9));
  for (int i = 0; i < 3; ++i) {
    const auto [corrected, untouched] = trackBoth(image_++);
    EXPECT_EQ(corrected.T_map_cam.matrix(), untouched.T_map_cam.matrix());
    EXPECT_EQ(corrected.matches, untouched.matches);
  }
}

}  // namespace
}  // namespace wardslam::odometry

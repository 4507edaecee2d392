#include "wardslam/odometry/odometry.h"

#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "odometry/odometry_fixture.h"
#include "wardslam/odometry/map_point.h"

namespace wardslam::odometry {
namespace {

TEST_F(OdometryTest, FollowsTheTruthWithinMillimetres) {
  double squares_m2 = 0;
  for (int image = 0; image < kImages; ++image) {
    const auto result = trackImage(image);
    ASSERT_EQ(result.state, State::Ok) << image;
    EXPECT_LT(distance_m(result.T_map_cam, truth(image)), 0.01) << image;
    EXPECT_LT(angle_deg(result.T_map_cam, truth(image)), 0.2) << image;
    EXPECT_GT(result.inliers, image > 0 ? 200 : -1) << image;
    EXPECT_LE(result.inliers, result.matches) << image;
    squares_m2 += std::pow(distance_m(result.T_map_cam, truth(image)), 2);
  }
  EXPECT_LT(std::sqrt(squares_m2 / kImages), 0.004);
}

TEST_F(OdometryTest, WithoutNoiseItIsExact) {
  for (int image = 0; image < kImages; ++image) {
    const auto result = trackImage(image, {});
    ASSERT_TRUE(result.hasPose());
    EXPECT_LT(distance_m(result.T_map_cam, truth(image)), 1e-4) << image;
  }
}

TEST_F(OdometryTest, TheFirstCameraIsTheMapFrame) {
  const auto result = trackImage(0);
  EXPECT_EQ(result.state, State::Ok);
  EXPECT_TRUE(result.T_map_cam.isApprox(Eigen::Isometry3d::Identity()));
  ASSERT_NE(result.keyframe, nullptr);
  EXPECT_EQ(result.keyframe->id, 1U);
  EXPECT_EQ(result.referenceKeyframe, 1U);
}

TEST_F(OdometryTest, StartsWhereItIsTold) {
  Eigen::Isometry3d T_map_start(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
  T_map_start.translation() = Eigen::Vector3d(4, -5, 1.2);
  odometry_.startFrom(T_map_start);
  EXPECT_FALSE(odometry_.hasStarted());
  for (int image = 0; image < 5; ++image) {
    const auto result = trackImage(image, {});
    EXPECT_LT(distance_m(result.T_map_cam, T_map_start * truth(image)), 1e-4) << image;
  }
  EXPECT_TRUE(odometry_.hasStarted());
  odometry_.startFrom(Eigen::Isometry3d::Identity());
  EXPECT_LT(distance_m(trackImage(5, {}).T_map_cam, T_map_start * truth(5)), 1e-4) << "too late to be moved";
}

TEST_F(OdometryTest, NumbersGoOnBehindAnEarlierRun) {
  odometry_ = Odometry(options(), {40, 5000, 3, {}});
  const auto result = trackImage(0);
  ASSERT_NE(result.keyframe, nullptr);
  EXPECT_EQ(result.keyframe->id, 41U);
  EXPECT_EQ(result.keyframe->submap, 3U);
  for (const Sighting& sighting : result.keyframe->sightings) EXPECT_GT(sighting.point, 5000U);
}

TEST_F(OdometryTest, KeyframesComeWhenThereIsSomethingNew) {
  std::set<KeyframeId> ids;
  for (int image = 0; image < kImages; ++image) {
    const auto result = trackImage(image);
    const Eigen::Isometry3d& T_map_cam = result.T_map_cam;
    if (!result.keyframe) continue;
    ids.insert(result.keyframe->id);
    EXPECT_TRUE(result.keyframe->T_map_cam.isApprox(T_map_cam));
    EXPECT_TRUE(result.T_keyframe_cam.isApprox(Eigen::Isometry3d::Identity(), 1e-9));
    ASSERT_FALSE(result.keyframe->sightings.empty());
    for (const Sighting& sighting : result.keyframe->sightings) {
      EXPECT_LT(sighting.keypoint, result.keyframe->features.size());
    }
  }
  EXPECT_GE(ids.size(), 3U);
  EXPECT_LE(ids.size(), 30U);
  EXPECT_EQ(*ids.rbegin(), ids.size()) << "they count up by one";

  Odometry still{options()};
  int keyframesOfAStillCamera = 0;
  for (int i = 0; i < 20; ++i) {
    const auto features = world_.look(SyntheticWorld::T_world_cam(0, kImages));
    if (still.track(i, SyntheticWorld::camera(), features).keyframe) ++keyframesOfAStillCamera;
  }
  EXPECT_EQ(keyframesOfAStillCamera, 1);
}

/// What a keyframe adds to the drift stays, until a place is seen again.
TEST_F(OdometryTest, TheDriftOfTheMapGrowsFromKeyframeToKeyframe) {
  const auto place_m2 = [](const OdometryResult& result) { return result.drift.diagonal().head(3).sum(); };
  std::vector<double> drifts_m2;
  for (int image = 0; image < kImages; ++image) {
    const auto result = trackImage(image);
    ASSERT_TRUE(result.covariance) << image;
    EXPECT_EQ(*result.covarianceInPiece(), PoseCovariance(*result.covariance + result.drift));
    if (result.keyframe) drifts_m2.push_back(place_m2(result));
  }
  ASSERT_GE(drifts_m2.size(), 3U);
  EXPECT_EQ(drifts_m2.front(), 0.0);
  for (std::size_t i = 1; i < drifts_m2.size(); ++i) EXPECT_GT(drifts_m2[i], drifts_m2[i - 1]) << i;

  MapUpdate loop;
  loop.newestKeyframe = drifts_m2.size();
  loop.movesTheMap = true;
  loop.seenAgain = {1, drifts_m2.size(), truth(kImages - 1)};
  odometry_.apply(std::make_shared<const MapUpdate>(loop));
  const double after_m2 = place_m2(trackImage(kImages - 1));
  EXPECT_LT(after_m2, 0.5 * drifts_m2.back());
  EXPECT_GT(after_m2, 0.0) << "the newest keyframe errs as before";
}

TEST_F(OdometryTest, IsLostWhenFeaturesVanishAndRecoversWhenTheyReturn) {
  for (int image = 0; image < 20; ++image) trackImage(image);
  for (int i = 0; i < 3; ++i) {
    const auto result = track({});
    EXPECT_EQ(result.state, State::Lost);
    EXPECT_FALSE(result.hasPose());
  }
  // Meanwhile the camera went on by 10 cm and a few degrees, farther than from image to image.
  for (int image = 26; image < 32; ++image) {
    const auto result = trackImage(image);
    ASSERT_EQ(result.state, State::Ok) << image;
    EXPECT_LT(distance_m(result.T_map_cam, truth(image)), 0.01) << "in the same map frame";
  }
}

/// What is seen beside somebody who covers one half of the image.
core::Features halfOf(const core::Features& all, bool isRight) {
  core::Features half;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if ((all.keypoints[i].raw_px.x > 320.0F) != isRight) continue;
    half.keypoints.push_back(all.keypoints[i]);
    half.descriptors.push_back(all.descriptors.row(static_cast<int>(i)));
  }
  return half;
}

TEST_F(OdometryTest, WhoWalksAcrossUncoversWhatTheLastImageDidNotShow) {
  OdometryOptions noPlaces = options();
  noPlaces.relocalisation.min_found_fraction = 1.0;  // what is lost is not found again
  odometry_ = Odometry(noPlaces);
  for (int image = 0; image < 20; ++image) trackImage(image);
  const auto look = [&](int image) { return world_.look(SyntheticWorld::T_world_cam(image, kImages), kNoise); };
  ASSERT_EQ(track(halfOf(look(20), false)).state, State::Ok);
  const auto across = track(halfOf(look(21), true));
  EXPECT_EQ(across.state, State::Ok);
  EXPECT_LT(distance_m(across.T_map_cam, truth(21)), 0.01);
}

TEST_F(OdometryTest, FindsItselfNoFartherAwayThanItCanHaveGone) {
  for (int image = 0; image < kImages; ++image) trackImage(image);
  track({});
  // It is carried back by a metre, within a thirtieth of a second: what looks like that place is another.
  for (int i = 0; i < 3; ++i) EXPECT_EQ(trackImage(i).state, State::Lost);
  stamp_s_ += 1.0;
  const auto later = trackImage(4);
  EXPECT_EQ(later.state, State::Ok);
  EXPECT_LT(distance_m(later.T_map_cam, truth(4)), 0.01);
}

TEST_F(OdometryTest, LeavesAFarPlaceToTheMapHoweverLongItWasLost) {
  OdometryOptions near = options();
  near.relocalisation.max_way_m = 0.3;  // rooms that look the same are farther apart in a hospital
  odometry_ = Odometry(near);
  for (int image = 0; image < kImages; ++image) trackImage(image);
  track({});
  stamp_s_ += 60.0;
  EXPECT_EQ(trackImage(4).state, State::Lost);
  EXPECT_EQ(trackImage(kImages - 2).state, State::Ok);
}

TEST_F(OdometryTest, DoesNotChooseBetweenTwoPlacesThatItSeesAtOnce) {
  for (int image = 0; image < kImages; ++image) trackImage(image);
  track({});
  auto both = world_.look(SyntheticWorld::T_world_cam(0, kImages), kNoise);
  const auto other = world_.look(SyntheticWorld::T_world_cam(kImages - 1, kImages), kNoise);
  core::Features half;
  const auto take = [&](const core::Features& features, std::size_t first) {
    for (std::size_t i = first; i < features.size(); i += 2) {
      half.keypoints.push_back(features.keypoints[i]);
      half.descriptors.push_back(features.descriptors.row(static_cast<int>(i)));
    }
  };
  take(both, 0);
  take(other, 1);
  stamp_s_ += 10.0;
  EXPECT_EQ(track(half).state, State::Lost);
}

TEST_F(OdometryTest, DoesNotFindItselfWhereDepthSaysThatNothingIs) {
  for (int image = 0; image < 20; ++image) trackImage(image);
  track({});
  const auto features = world_.look(SyntheticWorld::T_world_cam(20, kImages), kNoise);
  const DepthImage empty{cv::Mat(480, 640, CV_32FC1, cv::Scalar(9.0F)), {}};  // all that is known is nearer
  const auto lost = odometry_.track(stamp_s_ += 1.0 / 30, SyntheticWorld::camera(), features, empty);
  EXPECT_EQ(lost.state, State::Lost);
  const DepthImage full{cv::Mat(480, 640, CV_32FC1, cv::Scalar(1.0F)), {}};  // people all around, say
  EXPECT_EQ(odometry_.track(stamp_s_ += 1.0 / 30, SyntheticWorld::camera(), features, full).state, State::Ok);
}

TEST_F(OdometryTest, KnowsAPlaceOfWhichMorePointsAreKnownThanAnImageCanShow) {
  for (int image = 0; image < 20; ++image) trackImage(image);
  track({});
  const auto all = world_.look(SyntheticWorld::T_world_cam(20, kImages), kNoise);
  core::Features everyTenth;
  for (std::size_t i = 0; i < all.size(); i += 10) {
    everyTenth.keypoints.push_back(all.keypoints[i]);
    everyTenth.descriptors.push_back(all.descriptors.row(static_cast<int>(i)));
  }
  const auto found = track(everyTenth);
  ASSERT_EQ(found.state, State::Ok);
  EXPECT_LT(distance_m(found.T_map_cam, truth(20)), 0.01);
}

TEST_F(OdometryTest, KeyframesKeepTheirDepth) {
  EXPECT_EQ(trackImage(0).keyframe->depth, nullptr) << "none was told";
  odometry_ = Odometry(options());
  const DepthImage wall{cv::Mat(480, 640, CV_32FC1, cv::Scalar(3.0F)), {}};
  const auto features = world_.look(SyntheticWorld::T_world_cam(0, kImages), kNoise);
  const auto result = odometry_.track(1.0, SyntheticWorld::camera(), features, wall);
  ASSERT_NE(result.keyframe->depth, nullptr);
  EXPECT_EQ(result.keyframe->depth->nearest_mm.at(100), 3000);
}

TEST_F(OdometryTest, ForeignFeaturesAreNoPlaceItKnows) {
  for (int image = 0; image < 10; ++image) trackImage(image);
  EXPECT_EQ(track(world_.lookElsewhere(800)).state, State::Lost);
  const auto back = trackImage(12);
  EXPECT_EQ(back.state, State::Ok);
  EXPECT_LT(distance_m(back.T_map_cam, truth(12)), 0.01);
}

TEST_F(OdometryTest, TellsWhenAPoseIsNotInTheMap) {
  for (int image = 0; image < 20; ++image) EXPECT_TRUE(trackImage(image).isInMap);
  for (int i = 0; i <= options().max_lost_frames; ++i) track({});
  const auto anew = trackImage(40);
  ASSERT_TRUE(anew.hasPose());
  EXPECT_EQ(anew.piece, 1U);
  EXPECT_FALSE(anew.isInMap) << "nobody knows how far the camera went meanwhile";
  MapUpdate update;
  update.submap = 1;
  update.joined = SubmapJoin{1, 0};
  odometry_.apply(update);
  const auto joined = trackImage(41);
  EXPECT_EQ(joined.piece, 0U);
  EXPECT_TRUE(joined.isInMap);
}

TEST_F(OdometryTest, BesideAnEarlierMapNothingElseIsTheMap) {
  odometry_ = Odometry(options(), {40, 5000, 3, 0});
  for (int image = 0; image < 5; ++image) {
    const auto result = trackImage(image);
    EXPECT_EQ(result.piece, 3U);
    EXPECT_FALSE(result.isInMap);
  }
}

TEST_F(OdometryTest, FollowsTheMajorityWhereSomeMoveAlongWithTheCamera) {
  SyntheticWorld onBoard(1500, 2);  // half as many points as in the world, always seen alike
  for (int image = 0; image < 20; ++image) {
    auto features = world_.look(SyntheticWorld::T_world_cam(image, kImages), kNoise);
    const auto foreign = onBoard.look(Eigen::Isometry3d::Identity(), kNoise);
    features.keypoints.insert(features.keypoints.end(), foreign.keypoints.begin(), foreign.keypoints.end());
    features.descriptors.push_back(foreign.descriptors);
    const auto result = track(features);
    ASSERT_EQ(result.state, State::Ok) << image;
    EXPECT_LT(distance_m(result.T_map_cam, truth(image)), 0.01) << image;
  }
}

TEST_F(OdometryTest, StartsFirstWhenThereAreEnoughPointsWithDepth) {
  SyntheticWorld sparse(200);
  const auto few = sparse.look(SyntheticWorld::T_world_cam(0, kImages));
  ASSERT_LT(few.size(), 80U);
  EXPECT_EQ(track(few).state, State::Initialising);
  EXPECT_EQ(track({}).state, State::Initialising);

  auto withoutDepth = world_.look(SyntheticWorld::T_world_cam(0, kImages));
  for (auto& keypoint : withoutDepth.keypoints) keypoint.depth_m = 0.0F;
  const auto result = track(withoutDepth);
  EXPECT_EQ(result.state, State::Initialising);
  EXPECT_FALSE(result.hasPose());
  EXPECT_EQ(result.keyframe, nullptr);

  EXPECT_EQ(trackImage(0).state, State::Ok);
}

TEST_F(OdometryTest, SameInputSameOutput) {
  const auto run = [] {
    SyntheticWorld world;
    Odometry odometry{options()};
    std::vector<OdometryResult> results;
    for (int image = 0; image < 30; ++image) {
      const auto features =
          image == 15 ? core::Features{} : world.look(SyntheticWorld::T_world_cam(image, kImages), kNoise);
      results.push_back(odometry.track(image, SyntheticWorld::camera(), features));
    }
    return results;
  };
  const auto once = run();
  const auto again = run();
  for (std::size_t i = 0; i < once.size(); ++i) {
    EXPECT_EQ(once[i].T_map_cam.matrix(), again[i].T_map_cam.matrix()) << "to the last bit, in image " << i;
    EXPECT_EQ(once[i].inliers, again[i].inliers);
    EXPECT_EQ(once[i].state, again[i].state);
  }
}

TEST(State, HasAName) {
  EXPECT_EQ(toString(State::Initialising), "initialising");
  EXPECT_EQ(toString(State::Ok), "ok");
  EXPECT_EQ(toString(State::Lost), "lost");
}

/// Every key point is surrounded by the same cells.
class Surroundings : public core::SemanticDescriptorSource {
 public:
  explicit Surroundings(core::SemanticDescriptor cells) : cells_(std::move(cells)) {}
  [[nodiscard]] core::SemanticDescriptor of(const core::Keypoint&) const override { return cells_; }

 private:
  core::SemanticDescriptor cells_;
};

class OdometrySemanticDescriptors : public OdometryTest {
 protected:
  /// Follows two images, whose key points have these surroundings, with so much difference allowed.
  OdometryResult trackTwo(double allowed, const core::SemanticDescriptor& before, const core::SemanticDescriptor& now) {
    OdometryOptions asked = options();
    asked.matcher.max_semantic_difference = allowed;
    odometry_ = Odometry(asked);
    OdometryResult result;
    for (const auto& [image, cells] : {std::pair(0, before), {1, now}}) {
      auto features = world_.look(SyntheticWorld::T_world_cam(image, kImages), kNoise);
      if (!cells.empty()) features.semanticDescriptors = std::make_shared<Surroundings>(cells);
      result = track(features);
      EXPECT_TRUE(!result.keyframe || !result.keyframe->features.semanticDescriptors) << "images would be kept alive";
    }
    return result;
  }
};

TEST_F(OdometrySemanticDescriptors, MatchesOfOtherSurroundingsAreOutliers) {
  const core::SemanticDescriptor cells = {1, 1, 60, 0};
  EXPECT_GT(trackTwo(0.25, cells, cells).matches, 200);
  EXPECT_GT(trackTwo(0.25, cells, {1, 1, 60, 57}).matches, 200) << "one in four may differ";
  const auto foreign = trackTwo(0.25, cells, {1, 1, 57, 57});
  EXPECT_EQ(foreign.matches, 0);
  EXPECT_EQ(foreign.state, State::Lost);
}

TEST_F(OdometrySemanticDescriptors, AreAskedOnlyWhereWanted) {
  EXPECT_EQ(OdometryOptions().matcher.max_semantic_difference, 1.0);
  EXPECT_GT(trackTwo(1.0, {1, 1}, {2, 2}).matches, 200);
}

TEST_F(OdometrySemanticDescriptors, WhatHasNoneIsNotTested) {
  EXPECT_GT(trackTwo(0.0, {}, {1}).matches, 200);
  EXPECT_GT(trackTwo(0.0, {1}, {}).matches, 200);
}

}  // namespace
}  // namespace wardslam::odometry

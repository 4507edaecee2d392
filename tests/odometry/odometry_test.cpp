#include "wardslam/odometry/odometry.h"

#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "odometry/synthetic_world.h"
#include "wardslam/odometry/map_point.h"

namespace wardslam::odometry {
namespace {

using test::Noise;
using test::SyntheticWorld;

constexpr int kImages = 60;
constexpr Noise kNoise{0.5, 1.0, 8};

Eigen::Isometry3d truth(int image) {
  return SyntheticWorld::T_world_cam(0, kImages).inverse() * SyntheticWorld::T_world_cam(image, kImages);
}

double distance_m(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return (a.translation() - b.translation()).norm();
}

double angle_deg(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle() * 180 / M_PI;
}

/// A camera on a known path among points with known descriptors.
class OdometryTest : public ::testing::Test {
 protected:
  OdometryResult trackImage(int image, const Noise& noise = kNoise) {
    return track(world_.look(SyntheticWorld::T_world_cam(image, kImages), noise));
  }
  OdometryResult track(const core::Features& features) {
    return odometry_.track(stamp_s_ += 1.0 / 30, SyntheticWorld::camera(), features);
  }

  static OdometryOptions options() {
    OdometryOptions options;
    options.min_initial_points = 80;
    options.max_lost_frames = 5;
    return options;
  }

  SyntheticWorld world_;
  Odometry odometry_{options()};
  double stamp_s_ = 0;
};

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

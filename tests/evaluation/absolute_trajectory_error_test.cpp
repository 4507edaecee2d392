#include "wardslam/evaluation/absolute_trajectory_error.h"

#include <gmock/gmock.h>

#include <cmath>

#include "wardslam/core/errors.h"

namespace wardslam::evaluation {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

core::Trajectory through(const std::vector<Eigen::Vector3d>& positions_m, double firstStamp_s = 0.0) {
  core::Trajectory trajectory;
  for (const auto& position_m : positions_m) {
    trajectory.push_back({firstStamp_s, Eigen::Isometry3d(Eigen::Translation3d(position_m))});
    firstStamp_s += 1.0;
  }
  return trajectory;
}

core::Trajectory moved(const Eigen::Isometry3d& T, core::Trajectory trajectory) {
  for (auto& pose : trajectory) pose.T_map_cam = T * pose.T_map_cam;
  return trajectory;
}

const Eigen::Isometry3d kSomewhere =
    Eigen::Translation3d(3, -7, 11) * Eigen::AngleAxisd(2.5, Eigen::Vector3d(1, 2, -3).normalized());

TEST(AbsoluteTrajectoryError, TellsHowFarEachPositionIsOff) {
  const auto groundTruth = through({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
  auto estimate = through({{0, 0.1, 0}, {1, -0.1, 0}, {2, -0.1, 0}, {3, 0.1, 0}}, 0.01);
  const auto error = absoluteTrajectoryError(groundTruth, estimate);
  ASSERT_EQ(error.errors.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_DOUBLE_EQ(error.errors[i].stamp_s, static_cast<double>(i) + 0.01);
    EXPECT_NEAR(error.errors[i].distance_m, 0.1, 1e-12) << "no turn and no shift makes it less";
  }
}

TEST(AbsoluteTrajectoryError, IsZeroForTheSamePathInAnotherFrame) {
  const auto groundTruth = through({{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {1, 2, 3}, {-1, 1, 1}});
  const auto error = absoluteTrajectoryError(groundTruth, moved(kSomewhere.inverse(), groundTruth));
  EXPECT_EQ(error.translation_m.samples, 5U);
  EXPECT_LT(error.translation_m.max, 1e-12);
  EXPECT_TRUE(error.T_groundtruth_estimate.isApprox(kSomewhere, 1e-12));
}

// A cross whose arms the estimate stretches evenly to both sides: by symmetry the best alignment is none at all.
const std::vector<Eigen::Vector3d> kCross = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
const std::vector<Eigen::Vector3d> kStretched = {{1.1, 0, 0}, {-1.1, 0, 0}, {0, 1.3, 0}, {0, -1.3, 0}};

TEST(AbsoluteTrajectoryError, WorkedByHand) {
  const auto estimate = moved(kSomewhere, through(kStretched));
  const auto error = absoluteTrajectoryError(through(kCross), estimate).translation_m;
  // Distances 0.1, 0.1, 0.3, 0.3.
  EXPECT_EQ(error.samples, 4U);
  EXPECT_NEAR(error.rmse, std::sqrt(0.2 / 4), 1e-12);
  EXPECT_NEAR(error.mean, 0.2, 1e-12);
  EXPECT_NEAR(error.median, 0.2, 1e-12);
  EXPECT_NEAR(error.std, 0.1, 1e-12);
  EXPECT_NEAR(error.min, 0.1, 1e-12);
  EXPECT_NEAR(error.max, 0.3, 1e-12);
}

TEST(AbsoluteTrajectoryError, DoesNotCorrectTheScale) {
  auto twiceAsLarge = through(kCross);
  for (auto& pose : twiceAsLarge) pose.T_map_cam.translation() *= 2.0;
  const auto error = absoluteTrajectoryError(through(kCross), twiceAsLarge).translation_m;
  EXPECT_NEAR(error.min, 1.0, 1e-12);
  EXPECT_NEAR(error.max, 1.0, 1e-12);
}

TEST(AbsoluteTrajectoryError, CorrectsTheScaleWhereThatIsAskedFor) {
  auto twiceAsLarge = moved(kSomewhere.inverse(), through(kCross));
  for (auto& pose : twiceAsLarge) pose.T_map_cam.translation() *= 2.0;
  const auto error = absoluteTrajectoryError(through(kCross), twiceAsLarge, Alignment::Similarity);
  EXPECT_NEAR(error.scale, 0.5, 1e-12);
  EXPECT_LT(error.translation_m.max, 1e-12);
  EXPECT_NEAR(error.T_groundtruth_estimate.linear().determinant(), 1.0, 1e-12) << "the scale is told apart";

  // Truth p = ±1 along x and y, estimate ±1.1 and ±1.3: least squares of s (1.1, 1.3) against (1, 1) is
  // s = 2.4 / (1.21 + 1.69), which leaves 1 - 1.1 s and 1.3 s - 1.
  const double scale = 2.4 / 2.9;
  const auto stretched = absoluteTrajectoryError(through(kCross), through(kStretched), Alignment::Similarity);
  EXPECT_NEAR(stretched.scale, scale, 1e-12);
  EXPECT_NEAR(stretched.translation_m.max, 1.0 - 1.1 * scale, 1e-12);
  EXPECT_NEAR(stretched.translation_m.min, 1.3 * scale - 1.0, 1e-12);
  EXPECT_LT(stretched.translation_m.rmse,
            absoluteTrajectoryError(through(kCross), through(kStretched)).translation_m.rmse);
}

TEST(AbsoluteTrajectoryError, AnEstimateThatStandsStillHasNoScale) {
  const auto still = through(std::vector(4, Eigen::Vector3d(1, 2, 3)));
  const auto error = absoluteTrajectoryError(through(kCross), still, Alignment::Similarity);
  EXPECT_EQ(error.scale, 1.0);
  EXPECT_NEAR(error.translation_m.rmse, 1.0, 1e-9);
}

TEST(AbsoluteTrajectoryError, DoesNotMirror) {
  const std::vector<Eigen::Vector3d> corners = {{1, 0, 0}, {-1, 0, 0}, {0, 2, 0}, {0, -2, 0}, {0, 0, 4}};
  auto mirrored = through(corners);
  for (auto& pose : mirrored) pose.T_map_cam.translation().z() *= -1.0;
  const auto error = absoluteTrajectoryError(through(corners), mirrored);
  EXPECT_NEAR(error.T_groundtruth_estimate.linear().determinant(), 1.0, 1e-12);
  EXPECT_GT(error.translation_m.rmse, 0.5);
}

TEST(AbsoluteTrajectoryError, OrientationDoesNotCount) {
  auto turned = through(kCross);
  for (auto& pose : turned) pose.T_map_cam.rotate(Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitX()));
  EXPECT_LT(absoluteTrajectoryError(through(kCross), turned).translation_m.max, 1e-12);
}

TEST(AbsoluteTrajectoryError, PosesWithoutPartnerDoNotCount) {
  auto estimate = through(kStretched);
  estimate.push_back({10.0, Eigen::Isometry3d(Eigen::Translation3d(100, 100, 100))});
  const auto error = absoluteTrajectoryError(through(kCross), estimate).translation_m;
  EXPECT_EQ(error.samples, 4U);
  EXPECT_NEAR(error.max, 0.3, 1e-12);
}

TEST(AbsoluteTrajectoryError, RefusesTrajectoriesWithoutCommonTime) {
  EXPECT_THAT([] { (void)absoluteTrajectoryError(through(kCross), through(kCross, 1000.0)); },
              ThrowsMessage<core::InputError>(AllOf(HasSubstr("there are 0"), HasSubstr("ground truth 0.00 .. 3.00 s"),
                                                    HasSubstr("trajectory 1000.00 .. 1003.00 s"))));
}

TEST(AbsoluteTrajectoryError, RefusesASinglePose) {
  EXPECT_THAT(
      [] {
        (void)absoluteTrajectoryError(through(kCross), through({{0, 0, 0}}));
      },
      ThrowsMessage<core::InputError>(HasSubstr("there are 1")));
  EXPECT_THAT([] { (void)absoluteTrajectoryError({}, through(kCross)); },
              ThrowsMessage<core::InputError>(HasSubstr("ground truth empty")));
}

TEST(AbsoluteTrajectoryError, PathsThatLeaveTheAlignmentOpenHaveFiguresAndNoNaN) {
  const std::vector<std::vector<Eigen::Vector3d>> paths = {
      {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}},               // standing
      {{0, 0, 0}, {1, 0, 0}},                          // two places
      {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}},    // a line
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 2, 0}},    // a plane
      {{1e8, 0, 0}, {1e8, 1e-9, 0}, {1e8, 2e-9, 0}}};  // far off, and hardly moving
  for (const auto& path : paths) {
    const auto truth = through(path);
    for (const auto& estimate : {truth, moved(kSomewhere, truth), through(std::vector(path.size(), path.front()))}) {
      const auto error = absoluteTrajectoryError(truth, estimate);
      EXPECT_TRUE(error.T_groundtruth_estimate.matrix().allFinite());
      EXPECT_NEAR(error.T_groundtruth_estimate.linear().determinant(), 1.0, 1e-9);
      EXPECT_TRUE(std::isfinite(error.translation_m.rmse) && std::isfinite(error.translation_m.max));
    }
    EXPECT_LT(absoluteTrajectoryError(truth, moved(kSomewhere, truth)).translation_m.max, 1e-6);
  }
}

}  // namespace
}  // namespace wardslam::evaluation

#include "wardslam/evaluation/relative_pose_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace wardslam::evaluation {
namespace {

constexpr double kStep_s = 0.125;  // exact in binary, so that stamps one second apart are

/// `poseAt(stamp_s)` for 0, kStep_s, … up to and including `end_s`.
core::Trajectory sampled(double end_s, const std::function<Eigen::Isometry3d(double)>& poseAt,
                         double step_s = kStep_s) {
  core::Trajectory trajectory;
  for (double stamp_s = 0.0; stamp_s <= end_s; stamp_s += step_s) trajectory.push_back({stamp_s, poseAt(stamp_s)});
  return trajectory;
}

Eigen::Isometry3d alongX(double x_m) { return Eigen::Isometry3d(Eigen::Translation3d(x_m, 0, 0)); }
Eigen::Isometry3d aboutZ(double angle_deg) {
  return Eigen::Isometry3d(Eigen::AngleAxisd(angle_deg * M_PI / 180.0, Eigen::Vector3d::UnitZ()));
}
Eigen::Isometry3d atRest(double) { return Eigen::Isometry3d::Identity(); }

TEST(RelativePoseError, OfASteadyDriftIsTheDrift) {
  const auto slide =
      relativePoseError(sampled(3.0, atRest), sampled(3.0, [](double t_s) { return alongX(0.5 * t_s); }));
  EXPECT_NEAR(slide.translation_m.min, 0.5, 1e-12);
  EXPECT_NEAR(slide.translation_m.max, 0.5, 1e-12);
  EXPECT_NEAR(slide.rotation_deg.max, 0.0, 1e-5);

  const auto turn = relativePoseError(sampled(3.0, atRest), sampled(3.0, [](double t_s) { return aboutZ(2 * t_s); }));
  EXPECT_NEAR(turn.translation_m.max, 0.0, 1e-12);
  EXPECT_NEAR(turn.rotation_deg.min, 2.0, 1e-9);
  EXPECT_NEAR(turn.rotation_deg.median, 2.0, 1e-9);
}

TEST(RelativePoseError, PairsThatReachTheLastPoseAreLeftOut) {
  // 25 poses, a second is 8 of them: poses 0 … 15 have a partner before the last pose (24).
  const auto error = relativePoseError(sampled(3.0, atRest), sampled(3.0, atRest));
  EXPECT_EQ(error.translation_m.samples, 16U);
  EXPECT_EQ(error.rotation_deg.samples, 16U);
}

TEST(RelativePoseError, DoesNotDependOnTheFrames) {
  const auto path = [](double t_s) { return aboutZ(30 * t_s) * alongX(t_s); };
  const Eigen::Isometry3d elsewhere = Eigen::Translation3d(5, 6, 7) * Eigen::AngleAxisd(1, Eigen::Vector3d::UnitX());
  const auto error =
      relativePoseError(sampled(3.0, path), sampled(3.0, [&](double t_s) { return elsewhere * path(t_s); }));
  EXPECT_LT(error.translation_m.max, 1e-12);
}

TEST(RelativePoseError, OfOneStepWorkedByHand) {
  // True step: 1 m ahead. Estimated step: 1 m ahead and a quarter turn to the left, M_e = [Rz(90) | (1, 0, 0)].
  // E = M_e * inv(M_g) has rotation Rz(90) and translation (1, 0, 0) - Rz(90) (1, 0, 0) = (1, -1, 0).
  const core::Trajectory groundTruth = {{0.0, alongX(0)}, {1.0, alongX(1)}, {2.0, alongX(2)}};
  const core::Trajectory estimate = {{0.0, alongX(0)}, {1.0, alongX(1) * aboutZ(90)}, {2.0, alongX(2)}};
  const auto error = relativePoseError(groundTruth, estimate);
  ASSERT_EQ(error.translation_m.samples, 1U);
  EXPECT_NEAR(error.translation_m.rmse, std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(error.rotation_deg.rmse, 90.0, 1e-9);
}

TEST(RelativePoseError, TheTimeApartCanBeChosen) {
  const auto slide = sampled(3.0, [](double t_s) { return alongX(0.5 * t_s); });
  const auto error = relativePoseError(sampled(3.0, atRest), slide, 2.0);
  EXPECT_EQ(error.translation_m.samples, 8U);
  EXPECT_NEAR(error.translation_m.mean, 1.0, 1e-12);
}

TEST(RelativePoseError, PairsWhereTheGroundTruthHasAHoleAreLeftOut) {
  auto groundTruth = sampled(3.0, atRest);
  groundTruth.erase(groundTruth.begin() + 9, groundTruth.begin() + 16);  // 1.125 … 1.875 s
  // The median interval is 0.125 s, so ground truth up to 0.25 s away is taken: only 1.375, 1.5 and 1.625 s have
  // none. They are the start of three of the 16 pairs and the end of three others.
  EXPECT_EQ(relativePoseError(groundTruth, sampled(3.0, atRest)).translation_m.samples, 10U);
}

TEST(RelativePoseError, OfTwoEquallyNearPosesTheBisectionDecides) {
  // The only pair is 0.5 -> 1.5 s. Among 0 1 2 3 s bisection looks at 2, then at 1, and a later pose must be nearer
  // to be preferred: 0.5 s gets pose 0 (the first guess), 1.5 s gets pose 2.
  const core::Trajectory groundTruth = {{0.0, alongX(0)}, {1.0, alongX(10)}, {2.0, alongX(200)}, {3.0, alongX(3000)}};
  const core::Trajectory estimate = {{0.5, alongX(0)}, {1.5, alongX(0)}, {2.5, alongX(0)}};
  const auto error = relativePoseError(groundTruth, estimate);
  ASSERT_EQ(error.translation_m.samples, 1U);
  EXPECT_DOUBLE_EQ(error.translation_m.mean, 200.0);
}

TEST(RelativePoseError, OfVeryManyPairsARepeatableSampleIsCompared) {
  constexpr double kFineStep_s = 1.0 / 64;
  const auto slide = sampled(
      170.0, [](double t_s) { return alongX(0.5 * t_s * t_s); }, kFineStep_s);
  const auto groundTruth = sampled(170.0, atRest, kFineStep_s);
  const auto error = relativePoseError(groundTruth, slide).translation_m;
  EXPECT_EQ(error.samples, kMaxRelativePosePairs);
  // From t to t + 1 the estimate slides t + 0.5: 85 m in the mean over the whole run.
  EXPECT_NEAR(error.mean, 85.0, 0.5);
  EXPECT_EQ(error.mean, relativePoseError(groundTruth, slide).translation_m.mean);
}

TEST(RelativePoseError, HasNoFiguresWhereNothingCanBeCompared) {
  const auto second = sampled(1.0, atRest);
  const core::Trajectory onePose = {{0.0, alongX(0)}};
  core::Trajectory later = sampled(3.0, atRest);
  for (auto& pose : later) pose.stamp_s += 100.0;

  for (const auto& [groundTruth, estimate] :
       {std::pair(second, second), {second, onePose}, {onePose, second}, {second, later}, {{}, second}, {second, {}}}) {
    const auto error = relativePoseError(groundTruth, estimate);
    EXPECT_EQ(error.translation_m.samples, 0U);
    EXPECT_TRUE(std::isnan(error.rotation_deg.rmse));
  }
}

}  // namespace
}  // namespace wardslam::evaluation

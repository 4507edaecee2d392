#include "wardslam/evaluation/floor_plan_evaluation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

namespace wardslam::evaluation {
namespace {

using mapping::FloorPlan;

/// 4 m by 3 m, cells of 0.1 m, its corner at (1, 2): free but for a wall of 0.2 m along x = 3.
FloorPlan twoRooms() {
  FloorPlan plan;
  plan.resolution_m = 0.1;
  plan.origin_m = {1.0, 2.0};
  plan.cells = cv::Mat(30, 40, CV_8UC1, cv::Scalar(FloorPlan::kFree));
  plan.cells.colRange(20, 22).setTo(FloorPlan::kOccupied);
  return plan;
}

TEST(FloorPlanEvaluation, OfTheTruthItselfIsPerfect) {
  const auto result = evaluateFloorPlan(twoRooms(), twoRooms(), Eigen::Isometry2d::Identity());
  EXPECT_NEAR(result.free_m2, 3.8 * 3.0, 1e-9);
  EXPECT_NEAR(result.intersectionOverUnion(), 1.0, 1e-12);
  EXPECT_NEAR(result.knownShare(), 1.0, 1e-12);
}

TEST(FloorPlanEvaluation, TellsEveryKindOfErrorApart) {
  FloorPlan found = twoRooms();
  found.cells.colRange(0, 5).setTo(FloorPlan::kUnknown);     // 0.5 m x 3 m
  found.cells.colRange(10, 12).setTo(FloorPlan::kOccupied);  // 0.2 m x 3 m
  found.cells.col(20).setTo(FloorPlan::kFree);               // 0.1 m x 3 m of the wall
  const auto result = evaluateFloorPlan(twoRooms(), found, Eigen::Isometry2d::Identity());
  EXPECT_NEAR(result.unknown_m2, 1.5, 1e-9);
  EXPECT_NEAR(result.occupied_m2, 0.6, 1e-9);
  EXPECT_NEAR(result.wronglyFree_m2, 0.3, 1e-9);
  EXPECT_NEAR(result.free_m2, 9.3, 1e-9);
  EXPECT_NEAR(result.intersectionOverUnion(), 9.3 / 10.2, 1e-9);
  EXPECT_NEAR(result.knownShare(), 9.9 / 11.4, 1e-9);
}

TEST(FloorPlanEvaluation, FollowsTheTransformAndTheResolutionsOfBoth) {
  // The map's frame is the truth's turned by a quarter: what is at (x, y) of the truth is at (y, -x) of the map.
  FloorPlan found;
  found.resolution_m = 0.05;
  found.origin_m = {2.0, -5.0};
  found.cells = cv::Mat(80, 60, CV_8UC1, cv::Scalar(FloorPlan::kFree));
  found.cells.rowRange(36, 40).setTo(FloorPlan::kOccupied);
  Eigen::Isometry2d T_truth_map = Eigen::Isometry2d::Identity();
  T_truth_map.rotate(Eigen::Rotation2Dd(std::acos(0.0)));
  const auto result = evaluateFloorPlan(twoRooms(), found, T_truth_map);
  EXPECT_NEAR(result.intersectionOverUnion(), 1.0, 1e-9);
  EXPECT_NEAR(result.free_m2, 11.4, 1e-9);
}

TEST(FloorPlanEvaluation, FreeFloorBeyondTheTruthIsWrong) {
  FloorPlan found = twoRooms();
  found.origin_m.x() += 0.5;
  const auto result = evaluateFloorPlan(twoRooms(), found, Eigen::Isometry2d::Identity());
  EXPECT_NEAR(result.wronglyFree_m2, 1.5 + 0.6, 1e-9) << "half a metre beyond, and the true wall";
}

TEST(FloorPlanEvaluation, HasNoFiguresWithoutFreeFloor) {
  FloorPlan nothing;
  nothing.cells = cv::Mat(3, 3, CV_8UC1, cv::Scalar(FloorPlan::kUnknown));
  const auto result = evaluateFloorPlan(nothing, nothing, Eigen::Isometry2d::Identity());
  EXPECT_TRUE(std::isnan(result.intersectionOverUnion()));
  EXPECT_TRUE(std::isnan(result.knownShare()));
}

TEST(OnFloor, KeepsHeadingAndPlace) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.rotate(Eigen::AngleAxisd(std::acos(0.0), Eigen::Vector3d::UnitZ()));
  T.translation() = Eigen::Vector3d(5, 6, 7);
  const Eigen::Vector2d p_m = onFloor(T) * Eigen::Vector2d(1, 2);
  EXPECT_LT((p_m - Eigen::Vector2d(3, 7)).norm(), 1e-12) << "(1, 2) turned by a quarter is (-2, 1)";
}

TEST(ReachableFloor, IsWhatIsConnectedWithOneOfThePlaces) {
  const FloorPlan left = reachableFloor(twoRooms(), {{1.5, 2.5}, {3.1, 2.5}, {99.0, 0.0}});
  EXPECT_EQ(cv::countNonZero(left.cells == FloorPlan::kFree), 20 * 30);
  EXPECT_EQ(cv::countNonZero(left.cells == FloorPlan::kOccupied), 2 * 30);
  EXPECT_EQ(cv::countNonZero(left.cells == FloorPlan::kUnknown), 18 * 30);
  EXPECT_EQ(left.origin_m, twoRooms().origin_m);
}

}  // namespace
}  // namespace wardslam::evaluation

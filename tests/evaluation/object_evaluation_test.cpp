#include "wardslam/evaluation/object_evaluation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wardslam::evaluation {
namespace {

constexpr core::ClassId kChair = 57;
constexpr core::ClassId kBed = 60;

Eigen::AlignedBox3d cube(double x_m, double side_m = 1.0) {
  const Eigen::Vector3d center(x_m, 0, 0);
  const Eigen::Vector3d half = Eigen::Vector3d::Constant(side_m / 2);
  return {center - half, center + half};
}

TrueObject truth(core::ClassId classId, const Eigen::AlignedBox3d& box_m, int frames = 100, int pixels = 5000) {
  return {"thing", classId, "class", box_m, frames, pixels};
}

FoundObject found(core::ClassId classId, const Eigen::AlignedBox3d& box_m) {
  FoundObject object;
  object.classId = classId;
  object.box_m = box_m;
  object.centroid_m = box_m.center();
  return object;
}

TEST(ObjectEvaluationTest, CountsWhatWasFoundAndWhatIsTrue) {
  const auto result = evaluateObjects({truth(kChair, cube(0)), truth(kChair, cube(5)), truth(kBed, cube(9))},
                                      {found(kChair, cube(0.1)), found(kBed, cube(9)), found(kBed, cube(20))});
  EXPECT_DOUBLE_EQ(result.all.recall(), 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(result.all.precision(), 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(result.classes.at(kChair).recall(), 0.5);
  EXPECT_DOUBLE_EQ(result.classes.at(kChair).precision(), 1.0);
  EXPECT_DOUBLE_EQ(result.classes.at(kBed).precision(), 0.5);
  EXPECT_NEAR(result.center_m.median, 0.05, 1e-12);
}

TEST(ObjectEvaluationTest, AnotherClassIsNoMatch) {
  EXPECT_TRUE(evaluateObjects({truth(kChair, cube(0))}, {found(kBed, cube(0))}).matches.empty());
}

TEST(ObjectEvaluationTest, EachOfTheThreeWaysToMatchSuffices) {
  EXPECT_EQ(evaluateObjects({truth(kBed, cube(0, 0.1))}, {found(kBed, cube(0.24, 0.1))}).matches.size(), 1U);  // near
  EXPECT_EQ(evaluateObjects({truth(kBed, cube(0, 2))}, {found(kBed, cube(1.1, 2))}).matches.size(), 1U);    // IoU .29
  EXPECT_EQ(evaluateObjects({truth(kBed, cube(0, 4))}, {found(kBed, cube(1.9, 0.1))}).matches.size(), 1U);  // inside
  EXPECT_TRUE(evaluateObjects({truth(kBed, cube(0, 0.1))}, {found(kBed, cube(0.26, 0.1))}).matches.empty());
}

TEST(ObjectEvaluationTest, MatchesOneToOneAndAsManyAsCanBe) {
  const std::vector<TrueObject> things{truth(kBed, cube(0)), truth(kBed, cube(0.2))};
  EXPECT_EQ(evaluateObjects(things, {found(kBed, cube(0.1))}).matches.size(), 1U);
  // The first found thing is nearest to both true ones; only the right choice leaves a partner for the second.
  const std::vector<FoundObject> two{found(kBed, cube(0.1, 0.1)), found(kBed, cube(-0.2, 0.1))};
  const std::vector<TrueObject> small{truth(kBed, cube(0, 0.1)), truth(kBed, cube(0.2, 0.1))};
  EXPECT_EQ(evaluateObjects(small, two).matches.size(), 2U);
}

TEST(ObjectEvaluationTest, WhatWasHardlySeenCannotBeMissedButMakesAFindTrue) {
  const std::vector<TrueObject> things{truth(kBed, cube(0), 14, 5000), truth(kBed, cube(5), 100, 1499)};
  const auto result = evaluateObjects(things, {found(kBed, cube(5))});
  EXPECT_EQ(result.all.wanted, 0U);
  EXPECT_TRUE(std::isnan(result.all.recall()));
  EXPECT_DOUBLE_EQ(result.all.precision(), 1.0);
}

TEST(ObjectEvaluationTest, SizesAreComparedLongSideFirst) {
  TrueObject thing = truth(kBed, {Eigen::Vector3d(-1, -0.5, 0), Eigen::Vector3d(1, 0.5, 1)});
  FoundObject same = found(kBed, {Eigen::Vector3d(-0.5, -1, 0), Eigen::Vector3d(0.5, 1, 1)});
  EXPECT_DOUBLE_EQ(evaluateObjects({thing}, {same}).size_m.median, 0.0);
  same.orientedSize_m = Eigen::Vector3d(2.0, 1.0, 1.5);
  EXPECT_DOUBLE_EQ(evaluateObjects({thing}, {same}).size_m.median, 0.5);
}

TEST(ObjectEvaluationTest, BoxesGrowWhenTurned) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = Eigen::AngleAxisd(M_PI / 4, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  T.translation().x() = 3;
  const auto turned = transformed({found(kBed, cube(0))}, T);
  EXPECT_TRUE(turned.front().centroid_m.isApprox(Eigen::Vector3d(3, 0, 0)));
  EXPECT_TRUE(turned.front().box_m.sizes().isApprox(Eigen::Vector3d(std::sqrt(2.0), std::sqrt(2.0), 1), 1e-9));
}

}  // namespace
}  // namespace wardslam::evaluation

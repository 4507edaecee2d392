#include "depth_alignment.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "odometry/rendered_planes.h"

namespace wardslam::odometry {
namespace {

using test::moved;
using test::RenderedPlanes;
using Vector6 = Eigen::Matrix<double, 6, 1>;

const core::CameraModel kCamera;
const Eigen::Isometry3d kStart = Eigen::Isometry3d::Identity();
// A tenth of a second of a hasty robot.
const Eigen::Isometry3d kMotion = moved({0.06, -0.03, 0.08}, {0.02, 0.05, -0.01});

DepthSurface surfaceOf(const DepthImage& image) { return DepthSurface(image, kCamera); }

DepthAlignment alignFromStart(RenderedPlanes& planes, const Eigen::Isometry3d& motion, double sigmas = 0.0) {
  const DepthSurface before = surfaceOf(planes.look(kStart, sigmas));
  return alignDepth(surfaceOf(planes.look(motion, sigmas)), before, kStart);
}

/// Translation (m) and rotation vector (rad) that lead from one to the other, in the frame of the first.
Vector6 difference(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to) {
  const Eigen::Isometry3d way = from.inverse() * to;
  const Eigen::AngleAxisd rotation(way.linear());
  Vector6 off;
  off << way.translation(), rotation.angle() * rotation.axis();
  return off;
}

TEST(DepthAlignment, FindsHowTheCameraMovedInABareRoom) {
  RenderedPlanes room(RenderedPlanes::room());
  const DepthAlignment found = alignFromStart(room, kMotion);
  EXPECT_EQ(found.open, 0);
  const Vector6 off = difference(kMotion, found.T_before_now);
  EXPECT_LT(off.head<3>().norm(), 0.001);
  EXPECT_LT(off.tail<3>().norm(), 0.0005);
  EXPECT_GT(found.overlap, 0.8);
  EXPECT_GT(found.agreement, 0.9);
}

TEST(DepthAlignment, LeavesOpenWhatACorridorDoesNotTell) {
  RenderedPlanes corridor(RenderedPlanes::corridor());
  const DepthAlignment found = alignFromStart(corridor, kMotion, 1.0);
  EXPECT_EQ(found.open, 1);
  const Eigen::Vector3d off_m = found.T_before_now.translation() - kMotion.translation();
  EXPECT_LT(off_m.head<2>().norm(), 0.003) << "across it is sure";
  EXPECT_LT(difference(kMotion, found.T_before_now).tail<3>().norm(), 0.002);
  EXPECT_NEAR(found.T_before_now.translation().z(), 0.0, 0.02) << "along it is nearly as guessed";
  const Eigen::Vector3d along = found.T_before_now.linear().transpose() * Eigen::Vector3d::UnitZ();
  Vector6 motion;
  motion << along, 0, 0, 0;
  EXPECT_LT(motion.dot(found.information * motion), 1e-3 * found.information.diagonal().head<3>().maxCoeff());
}

TEST(DepthAlignment, NoiseOfFarSurfacesTellsNoDirection) {
  // A small image of a floor and a wall 4 m off, where noise turns normals by some degrees: sideways all is alike.
  core::CameraModel small;
  small.width_px = 320;
  small.height_px = 240;
  small.fx_px = small.fy_px = 262.5;
  small.cx_px = 159.5;
  small.cy_px = 119.5;
  const std::vector<test::Plane> planes{{{0, 1, 0}, 1.0}, {{0, 0, 1}, 4.0}};
  for (unsigned seed = 1; seed <= 8; ++seed) {
    RenderedPlanes hall(planes, seed, small);
    const DepthSurface before(hall.look(kStart, 1.0), small);
    const DepthAlignment found =
        alignDepth(DepthSurface(hall.look(moved({0.06, 0, 0.03}, {0, 0, 0}), 1.0), small), before, kStart);
    EXPECT_EQ(found.open, 1) << seed;
    EXPECT_NEAR(found.T_before_now.translation().x(), 0.0, 0.01) << "as guessed";
  }
}

TEST(DepthAlignment, OneWallTellsThreeOfSix) {
  RenderedPlanes wall({{{0, 0, 1}, 2.0}});
  const DepthAlignment found = alignFromStart(wall, moved({0.05, 0.02, 0.04}, {0.03, 0.02, 0.04}), 1.0);
  EXPECT_EQ(found.open, 3);
  EXPECT_NEAR((found.T_before_now * Eigen::Vector3d::Zero()).z(), 0.04, 0.002);
}

TEST(DepthAlignment, IsAsSureAsItIsRight) {
  // Normalised errors of 6 numbers: their squares are 6 on average if the covariance is right. Ours knows of errors
  // that white noise does not have, so it is wider; but not without bound.
  double sum = 0.0;
  constexpr int kRuns = 12;
  for (unsigned seed = 1; seed <= kRuns; ++seed) {
    RenderedPlanes room(RenderedPlanes::room(), seed);
    const DepthAlignment found = alignFromStart(room, kMotion, 1.0);
    const Vector6 off = difference(found.T_before_now, kMotion);
    sum += off.dot(found.information * off);
  }
  EXPECT_LT(sum / kRuns, 6.0);
  EXPECT_GT(sum / kRuns, 0.005);
}

TEST(DepthAlignment, PassesByWhoWalksThroughTheImage) {
  RenderedPlanes room(RenderedPlanes::room());
  DepthImage before = room.look(kStart, 1.0);
  DepthImage now = room.look(kMotion, 1.0);
  before.depth_m(cv::Rect(120, 60, 140, 420)).setTo(1.6);
  now.depth_m(cv::Rect(180, 60, 140, 420)).setTo(1.3);
  const DepthAlignment found = alignDepth(surfaceOf(now), surfaceOf(before), kStart);
  EXPECT_LT(difference(kMotion, found.T_before_now).head<3>().norm(), 0.005);
}

TEST(DepthAlignment, ACrowdLeavesEnoughBetweenIt) {
  const Eigen::Isometry3d motion = moved({0.03, -0.015, 0.04}, {0.01, 0.025, -0.005});
  RenderedPlanes room(RenderedPlanes::room());
  DepthImage before = room.look(kStart, 1.0);
  DepthImage now = room.look(motion, 1.0);
  before.mayMove = now.mayMove = cv::Mat(480, 640, CV_8UC1, cv::Scalar(0));
  for (const auto& [image, shift_px] : {std::pair(&before, 0), std::pair(&now, -5)}) {
    for (const int left_px : {-80, 80, 240, 400, 560}) {  // a hundred and twenty wide, forty between
      image->mayMove(cv::Rect(left_px + shift_px, 20, 120, 460) & cv::Rect(0, 0, 640, 480)).setTo(1);
    }
  }
  ASSERT_GT(cv::mean(now.mayMove)[0], 0.7);
  const DepthAlignment found = alignDepth(surfaceOf(now), surfaceOf(before), kStart);
  EXPECT_GT(found.overlap, 0.25) << "as much as a pose may rest on";
  EXPECT_LT(difference(motion, found.T_before_now).head<3>().norm(), 0.01);
  EXPECT_LT(difference(motion, found.T_before_now).tail<3>().norm(), 0.005);
}

TEST(DepthAlignment, ARoomThatIsNotThisOneDoesNotAgree) {
  RenderedPlanes room(RenderedPlanes::room());
  RenderedPlanes shorter(RenderedPlanes::room(1.5));
  const DepthAlignment found = alignDepth(surfaceOf(shorter.look(kStart)), surfaceOf(room.look(kStart)), kStart);
  EXPECT_LT(found.agreement, 0.5);
}

TEST(DepthAlignment, WithoutDepthAllIsOpen) {
  RenderedPlanes room(RenderedPlanes::room());
  const DepthSurface seen = surfaceOf(room.look(kStart));
  const DepthImage none{cv::Mat(480, 640, CV_32FC1, cv::Scalar(0)), {}};
  for (const auto& found : {alignDepth(surfaceOf(none), seen, kMotion), alignDepth(seen, surfaceOf(none), kMotion),
                            alignDepth(surfaceOf({}), seen, kMotion)}) {
    EXPECT_EQ(found.open, 6);
    EXPECT_TRUE(found.information.isZero());
    EXPECT_TRUE(found.T_before_now.isApprox(kMotion));
    EXPECT_EQ(found.overlap, 0.0);
  }
}

TEST(DepthAlignment, SurfacesThatTellLittleLeaveDirectionsOpenAndMakeNoNaN) {
  RenderedPlanes room(RenderedPlanes::room());
  const cv::Mat whole = room.look(kStart).depth_m;
  const auto part = [&](const cv::Rect& seen) {
    cv::Mat depth_m = cv::Mat::zeros(whole.size(), CV_32FC1);
    whole(seen).copyTo(depth_m(seen));
    return depth_m;
  };
  cv::Mat odd = whole.clone();
  odd.rowRange(0, 160).setTo(std::numeric_limits<float>::quiet_NaN());
  odd.rowRange(160, 320).setTo(std::numeric_limits<float>::infinity());
  const std::vector<std::pair<const char*, cv::Mat>> images = {
      {"one pixel", part({320, 240, 1, 1})},
      {"a line", part({0, 240, 640, 1})},
      {"a column", part({320, 0, 1, 480})},
      {"a corner", part({0, 0, 16, 16})},
      {"one depth everywhere", cv::Mat(whole.size(), CV_32FC1, cv::Scalar(2.0))},
      {"farther than any", cv::Mat(whole.size(), CV_32FC1, cv::Scalar(1e30))},
      {"nearer than any", cv::Mat(whole.size(), CV_32FC1, cv::Scalar(1e-30))},
      {"no numbers", odd}};
  for (const auto& [name, image] : images) {
    const DepthSurface surface = surfaceOf({image, {}});
    for (const auto& guess : {kStart, kMotion, moved({0, 0, 0}, {0.0, 0.4, 0.0})}) {
      for (const auto& found : {alignDepth(surface, surface, guess), alignDepth(surface, surfaceOf({whole, {}}), guess),
                                alignDepth(surfaceOf({whole, {}}), surface, guess)}) {
        EXPECT_TRUE(found.T_before_now.matrix().allFinite()) << name;
        EXPECT_NEAR(found.T_before_now.linear().determinant(), 1.0, 1e-6) << name;
        EXPECT_TRUE(found.information.allFinite()) << name;
        EXPECT_TRUE(found.overlap >= 0.0 && found.overlap <= 1.0) << name;
        EXPECT_TRUE(found.agreement >= 0.0 && found.agreement <= 1.0) << name;
      }
    }
  }
  for (const char* bare : {"one pixel", "a line", "a column"}) {
    const auto image = std::find_if(images.begin(), images.end(), [&](const auto& i) { return i.first == bare; });
    const DepthSurface surface = surfaceOf({image->second, {}});
    EXPECT_EQ(alignDepth(surface, surface, kMotion).open, 6) << bare;
  }
}

TEST(DepthAlignment, APureTurnIsFound) {
  RenderedPlanes room(RenderedPlanes::room());
  const Eigen::Isometry3d turn = moved({0, 0, 0}, {0.03, -0.05, 0.04});
  EXPECT_LT(difference(turn, alignFromStart(room, turn).T_before_now).norm(), 0.002);
}

}  // namespace
}  // namespace wardslam::odometry

#include "depth_surface.h"

#include <gtest/gtest.h>

#include "odometry/rendered_planes.h"

namespace wardslam::odometry {
namespace {

const core::CameraModel kCamera;  // 640 x 480: squares of 4 pixels
const Eigen::Isometry3d kStart = Eigen::Isometry3d::Identity();

DepthImage wallAt(double distance_m) {
  test::RenderedPlanes wall({{{0, 0, 1}, distance_m}});
  return wall.look(kStart);
}

TEST(DepthSurface, HasAPointInTheMiddleOfEachSquare) {
  const DepthSurface surface(wallAt(2.0), kCamera);
  ASSERT_EQ(surface.columns(), 160);
  ASSERT_EQ(surface.rows(), 120);
  // The square (10, 20) has the pixels 40..43 and 80..83: (41.5 - 319.5) / 525 * 2 and (81.5 - 239.5) / 525 * 2.
  EXPECT_TRUE(surface.point(10, 20).isApprox(Eigen::Vector3f(-1.0590476F, -0.6019048F, 2.0F), 1e-5F));
  EXPECT_TRUE(surface.normal(10, 20).isApprox(Eigen::Vector3f(0, 0, -1), 1e-4F)) << "towards the camera";
  EXPECT_EQ(surface.squareOf({-1.0590476, -0.6019048, 2.0}), Eigen::Vector2i(10, 20));
  EXPECT_FALSE(surface.squareOf({5.0, 0.0, 2.0})) << "beside the image";
  EXPECT_FALSE(surface.squareOf({0.0, 0.0, -2.0})) << "behind it";
}

TEST(DepthSurface, ANormalIsTurnedAsTheSurfaceIs) {
  // A wall that recedes to the right by 45 degrees: z - x = 2, so its normal is (1, 0, -1) / sqrt 2.
  const double half = std::sqrt(0.5);
  test::RenderedPlanes slanted({{{-half, 0, half}, 2.0 * half}});
  const DepthSurface surface(slanted.look(kStart), kCamera);
  EXPECT_TRUE(surface.normal(60, 60).isApprox(Eigen::Vector3f(0.7071F, 0, -0.7071F), 0.01F));
}

TEST(DepthSurface, LeavesOutEdgesHolesAndWhatMoves) {
  DepthImage image = wallAt(3.0);
  image.depth_m(cv::Rect(202, 0, 100, 480)).setTo(1.5F);  // a pillar that begins within a square
  image.depth_m(cv::Rect(400, 100, 4, 4)).setTo(0.0F);
  image.mayMove = cv::Mat(480, 640, CV_8UC1, cv::Scalar(0));
  image.mayMove.at<std::uint8_t>(201, 503) = 1;
  const DepthSurface surface(image, kCamera);
  EXPECT_EQ(surface.point(50, 60).z(), 0.0F) << "half wall, half pillar";
  EXPECT_NEAR(surface.point(49, 60).z(), 3.0F, 1e-4F);
  EXPECT_NEAR(surface.point(51, 60).z(), 1.5F, 1e-4F);
  EXPECT_TRUE(surface.normal(49, 60).isApprox(Eigen::Vector3f(0, 0, -1), 1e-3F)) << "the pillar has no say in it";
  EXPECT_TRUE(surface.normal(50, 60).isZero());
  EXPECT_EQ(surface.point(100, 25).z(), 0.0F) << "a hole";
  EXPECT_EQ(surface.point(125, 50).z(), 0.0F) << "something moves there";
}

TEST(DepthSurface, AStripBetweenPeopleIsASurfaceAndALineIsNone) {
  const double half = std::sqrt(0.5);
  test::RenderedPlanes slanted({{{-half, 0, half}, 2.0 * half}});
  DepthImage image = slanted.look(kStart);
  image.mayMove = cv::Mat(480, 640, CV_8UC1, cv::Scalar(1));
  image.mayMove(cv::Rect(240, 0, 12, 480)).setTo(0);  // three squares wide
  const DepthSurface strip(image, kCamera);
  EXPECT_TRUE(strip.normal(61, 60).isApprox(Eigen::Vector3f(0.7071F, 0, -0.7071F), 0.01F));
  image.mayMove(cv::Rect(244, 0, 12, 480)).setTo(1);
  const DepthSurface line(image, kCamera);
  EXPECT_GT(line.point(60, 60).z(), 0.0F);
  EXPECT_TRUE(line.normal(60, 60).isZero()) << "any plane through a line fits";
}

TEST(DepthSurface, OfAnImageWithoutDepthThereIsNone) {
  const DepthSurface surface({}, kCamera);
  EXPECT_EQ(surface.columns(), 0);
  EXPECT_FALSE(surface.squareOf({0.0, 0.0, 1.0}));
}

}  // namespace
}  // namespace wardslam::odometry

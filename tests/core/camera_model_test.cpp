#include "wardslam/core/camera_model.h"

#include <gtest/gtest.h>
#include <mrpt/img/TCamera.h>

#include <opencv2/calib3d.hpp>

#include "wardslam/core/options.h"

namespace wardslam::core {
namespace {

/// The strongly distorting camera of TUM's freiburg1 recordings.
CameraModel distortingCamera() {
  CameraModel camera;
  camera.fx_px = 517.306408;
  camera.fy_px = 516.469215;
  camera.cx_px = 318.643040;
  camera.cy_px = 255.313989;
  camera.k1 = 0.262383;
  camera.k2 = -0.953104;
  camera.p1 = -0.005358;
  camera.p2 = 0.002628;
  camera.k3 = 1.163314;
  return camera;
}

TEST(CameraModel, ProjectsByHand) {
  CameraModel camera;
  camera.fx_px = 500;
  camera.fy_px = 400;
  camera.cx_px = 320;
  camera.cy_px = 240;
  // x: 500 * 0.5 / 2 + 320 = 445; y: 400 * -0.25 / 2 + 240 = 190.
  EXPECT_TRUE(camera.project({0.5, -0.25, 2.0}).isApprox(Eigen::Vector2d(445, 190)));
  EXPECT_TRUE(camera.unproject({445, 190}, 2.0).isApprox(Eigen::Vector3d(0.5, -0.25, 2.0)));
}

TEST(CameraModel, WithoutDistortionRawIsUndistorted) {
  const CameraModel camera;
  EXPECT_FALSE(camera.hasDistortion());
  EXPECT_EQ(camera.undistort({{3.25F, 479.0F}}), (std::vector<cv::Point2f>{{3.25F, 479.0F}}));
  EXPECT_TRUE(camera.projectDistorted({0.3, 0.2, 1.5}).isApprox(camera.project({0.3, 0.2, 1.5})));
}

TEST(CameraModel, DistortsAsOpenCvDoes) {
  const CameraModel camera = distortingCamera();
  const cv::Matx33d K(camera.fx_px, 0, camera.cx_px, 0, camera.fy_px, camera.cy_px, 0, 0, 1);
  const std::vector<double> lens{camera.k1, camera.k2, camera.p1, camera.p2, camera.k3};
  const std::vector<cv::Point3d> points{{0, 0, 1}, {0.4, -0.3, 1.2}, {-0.9, 0.7, 2.0}, {0.05, 0.6, 1.5}};
  std::vector<cv::Point2d> expected;
  cv::projectPoints(points, cv::Vec3d::zeros(), cv::Vec3d::zeros(), K, lens, expected);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d raw_px = camera.projectDistorted({points[i].x, points[i].y, points[i].z});
    EXPECT_NEAR(raw_px.x(), expected[i].x, 1e-9);
    EXPECT_NEAR(raw_px.y(), expected[i].y, 1e-9);
  }
}

TEST(CameraModel, UndistortInvertsTheLensAllOverTheImage) {
  const CameraModel camera = distortingCamera();
  std::vector<cv::Point2f> raw_px;
  for (int y = 0; y < camera.height_px; y += 37) {
    for (int x = 0; x < camera.width_px; x += 41) raw_px.emplace_back(static_cast<float>(x), static_cast<float>(y));
  }
  const std::vector<cv::Point2f> undistorted_px = camera.undistort(raw_px);
  double largestShift_px = 0.0;
  for (std::size_t i = 0; i < raw_px.size(); ++i) {
    const Eigen::Vector2d back_px =
        camera.projectDistorted(camera.unproject({undistorted_px[i].x, undistorted_px[i].y}, 1.0));
    EXPECT_NEAR(back_px.x(), raw_px[i].x, 0.02) << raw_px[i];
    EXPECT_NEAR(back_px.y(), raw_px[i].y, 0.02) << raw_px[i];
    largestShift_px = std::max(largestShift_px, cv::norm(undistorted_px[i] - raw_px[i]));
  }
  EXPECT_GT(largestShift_px, 5.0) << "the lens was not applied at all";
}

TEST(CameraModel, SeesWhatFallsIntoTheRawImage) {
  CameraModel barrel;
  barrel.k1 = -0.28;
  // By hand: x = 0.62 is 0.62 (1 - 0.28 * 0.3844) = 0.55327, at 525 px 290.5 px beside the middle, inside; without a
  // lens it would be 325.5 px, outside. x = 0.72 is 0.61549, 323.1 px, outside.
  const auto inside = barrel.seenAt({0.62, 0.0, 1.0});
  ASSERT_TRUE(inside);
  EXPECT_NEAR(inside->x(), 319.5 + 290.47, 0.01);
  EXPECT_FALSE(barrel.seenAt({0.72, 0.0, 1.0}));
  EXPECT_FALSE(CameraModel().seenAt({0.62, 0.0, 1.0})) << "without the lens";
  EXPECT_TRUE(CameraModel().seenAt({0.6, 0.0, 1.0}));
  EXPECT_FALSE(CameraModel().seenAt({0.0, 0.0, -1.0})) << "behind the camera";
  EXPECT_FALSE(CameraModel().seenAt({0.0, 0.0, 0.0}));
}

TEST(CameraModel, DoesNotSeeWhereTheLensModelFoldsBack) {
  CameraModel barrel;
  barrel.k1 = -0.28;
  // r (1 - 0.28 r^2) grows up to r = 1.091 and is 0 again at r = 1.89: what is there would be in the middle of the
  // image.
  const Eigen::Vector3d aside(1.8, 0.0, 1.0);
  EXPECT_LT(std::abs(barrel.projectDistorted(aside).x() - barrel.cx_px), 100.0);
  EXPECT_FALSE(barrel.seenAt(aside));
  CameraModel wavy =
      barrel;  // the slope is below 0 from r = 1.39 to 1.97, but what is there is beyond the fold all the same
  wavy.k2 = 0.03;
  wavy.fx_px = wavy.fy_px = 100.0;
  ASSERT_GT(1 - 3 * 0.28 * 4 + 5 * 0.03 * 16, 0.0);
  EXPECT_FALSE(wavy.seenAt({2.0, 0.0, 1.0}));
  EXPECT_TRUE(wavy.seenAt({0.8, 0.0, 1.0}));
  CameraModel steep = barrel;
  steep.k2 = 0.02;
  steep.k3 = 0.004;
  EXPECT_FALSE(steep.seenAt({1.5, 0.0, 1.0})) << "the slope is 1 - 1.89 + 0.51 + 0.32 = -0.06";
}

TEST(CameraModel, TheEdgeOfTheImageIsTheEdgeOfWhatIsSeen) {
  const CameraModel camera = distortingCamera();
  for (const cv::Point2f& corner :
       {cv::Point2f(1, 1), cv::Point2f(638, 1), cv::Point2f(1, 478), cv::Point2f(638, 478)}) {
    const cv::Point2f undistorted_px = camera.undistort({corner}).front();
    const Eigen::Vector2d edge_px(undistorted_px.x, undistorted_px.y);
    EXPECT_TRUE(camera.seenAt(camera.unproject(edge_px, 1.0))) << corner;
    const Eigen::Vector2d centre_px(camera.cx_px, camera.cy_px);
    const Eigen::Vector2d farther_px = centre_px + 1.02 * (edge_px - centre_px);
    EXPECT_FALSE(camera.seenAt(camera.unproject(farther_px, 1.0))) << corner;
  }
}

TEST(CameraModel, UndistortOfNothingIsNothing) { EXPECT_TRUE(distortingCamera().undistort({}).empty()); }

TEST(CameraModel, GoesThroughMrptUnchanged) {
  CameraModel camera = distortingCamera();
  camera.width_px = 1280;
  camera.height_px = 720;
  EXPECT_EQ(writeOptions(fromMrpt(toMrpt(camera))), writeOptions(camera));
  EXPECT_EQ(toMrpt(camera).ncols, 1280U);
  EXPECT_EQ(toMrpt(camera).fy(), camera.fy_px);
}

TEST(CameraModel, OfAnMrptCameraWithoutLensModelIgnoresItsCoefficients) {
  mrpt::img::TCamera camera = toMrpt(distortingCamera());
  camera.distortion = mrpt::img::DistortionModel::none;
  EXPECT_FALSE(fromMrpt(camera).hasDistortion());
  EXPECT_EQ(fromMrpt(camera).fx_px, distortingCamera().fx_px);
}

}  // namespace
}  // namespace wardslam::core

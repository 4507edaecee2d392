#include "inverse_lens.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/calib3d.hpp>
#include <vector>

namespace wardslam::sources {
namespace {

core::CameraModel makeCamera() {
  core::CameraModel camera;
  camera.width_px = 1280;
  camera.height_px = 720;
  camera.fx_px = camera.fy_px = 640.0;
  camera.cx_px = 636.0;
  camera.cy_px = 362.0;
  return camera;
}

// librealsense's rs2_deproject_pixel_to_point says where each pixel looks; OpenCV must say the same with what was
// found.
TEST(InverseLens, LooksWhereLibrealsenseLooks) {
  const std::array<double, 5> inverse = {-0.056, 0.066, -0.0005, 0.0006, -0.021};
  core::CameraModel camera = makeCamera();
  const auto error_px = setInverseLens(camera, inverse);
  ASSERT_TRUE(error_px);
  EXPECT_LT(*error_px, 0.1);
  const cv::Matx33d k(camera.fx_px, 0, camera.cx_px, 0, camera.fy_px, camera.cy_px, 0, 0, 1);
  const std::vector<double> d = {camera.k1, camera.k2, camera.p1, camera.p2, camera.k3};
  for (const cv::Point2d pixel :
       {cv::Point2d(0, 0), cv::Point2d(1279, 719), cv::Point2d(200, 500), cv::Point2d(640, 10)}) {
    std::vector<cv::Point2d> ideal;
    cv::undistortPoints(std::vector<cv::Point2d>{pixel}, ideal, k, d, cv::noArray(), cv::noArray(),
                        cv::TermCriteria(cv::TermCriteria::COUNT, 50, 0));
    const double x = (pixel.x - camera.cx_px) / camera.fx_px;
    const double y = (pixel.y - camera.cy_px) / camera.fy_px;
    const double r2 = x * x + y * y;
    const double f = 1 + inverse[0] * r2 + inverse[1] * r2 * r2 + inverse[4] * r2 * r2 * r2;
    EXPECT_NEAR(ideal[0].x, x * f + 2 * inverse[2] * x * y + inverse[3] * (r2 + 2 * x * x), 0.2 / camera.fx_px);
    EXPECT_NEAR(ideal[0].y, y * f + 2 * inverse[3] * x * y + inverse[2] * (r2 + 2 * y * y), 0.2 / camera.fy_px);
  }
}

TEST(InverseLens, IsNoneWithoutCoefficients) {
  core::CameraModel camera = makeCamera();
  EXPECT_EQ(setInverseLens(camera, {}), 0.0);
  EXPECT_FALSE(camera.hasDistortion());
}

TEST(InverseLens, TellsWhereNoPolynomialLeadsBack) {
  core::CameraModel camera = makeCamera();
  EXPECT_GT(setInverseLens(camera, {-0.9, 0.0, 0.0, 0.0, 0.0}).value_or(99.0), 5.0);  // folds the image over
}

}  // namespace
}  // namespace wardslam::sources

#include "camera/lens.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "camera/camera_options.h"
#include "rendering/renderer.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"

namespace wardslam::synth {
namespace {

class LensOfACamera : public testing::TestWithParam<Lens> {
 protected:
  const core::CameraModel camera_ = withLens(cameraFor(320, 240), GetParam());
};

TEST_P(LensOfACamera, RaysOfPixelsComeBackToThemThroughTheLensModel) {
  const LensView lens(camera_);
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 320; ++x) {
      ASSERT_LT((camera_.projectDistorted(lens.ray(x, y)) - Eigen::Vector2d(x, y)).norm(), 0.02) << x << ", " << y;
    }
  }
}

TEST_P(LensOfACamera, ThePinholesImageHoldsAllThatIsShown) {
  const LensView lens(camera_);
  for (const int x : {0, 319}) {
    for (const int y : {0, 239}) {
      const Eigen::Vector2d pixel = lens.pinhole().project(lens.ray(x, y));
      EXPECT_GE(pixel.minCoeff(), 0.0);
      EXPECT_LE(pixel.x(), lens.pinhole().width_px - 1.0);
      EXPECT_LE(pixel.y(), lens.pinhole().height_px - 1.0);
    }
  }
}

TEST_P(LensOfACamera, AnImageOfAnotherSizeShowsTheSame) {
  const LensView lens(camera_);
  const Directions same = lens.rays({320, 240});
  const Directions finer = lens.rays({960, 720});  // its pixel 3 x + 1 lies in the middle of pixel x
  for (const auto& [x, y] : {std::pair(0, 0), {319, 0}, {7, 200}, {160, 120}, {319, 239}}) {
    const Eigen::Vector3d ray = lens.ray(x, y);
    for (const Eigen::Vector3f& other : {same.at(x, y), finer.at(3 * x + 1, 3 * y + 1)}) {
      EXPECT_LT((other.cast<double>() - ray).norm(), 1e-4) << x << ", " << y;
    }
  }
}

constexpr float kSide_m = 0.12F;

/// A wall with a small light square on it, where `p` is; the camera is at the origin and looks along x.
Scene squareAt(const Eigen::Vector3f& p) {
  const Eigen::Vector3f corner = p + Eigen::Vector3f(0, kSide_m / 2, -kSide_m / 2);
  Scene scene;
  scene.textures[Material::Linen] = cv::Mat(16, 16, CV_8UC3, cv::Scalar::all(250));
  scene.textures[Material::Rubber] = cv::Mat(16, 16, CV_8UC3, cv::Scalar::all(0));
  scene.things.push_back({{1, "wall", 0, ""}, {{Material::Rubber, panel({4, 20, -20}, {0, -40, 0}, {0, 0, 40})}}});
  scene.things.push_back({{2, "square", 0, ""}, {{Material::Linen, panel(corner, {0, -kSide_m, 0}, {0, 0, kSide_m})}}});
  return scene;
}

/// Middle of weights (one channel of 8 bits), px.
Eigen::Vector2d middleOf(const cv::Mat& weights) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double total = 0.0;
  for (int y = 0; y < weights.rows; ++y) {
    for (int x = 0; x < weights.cols; ++x) {
      const double weight = weights.at<std::uint8_t>(y, x);
      sum += weight * Eigen::Vector2d(x, y);
      total += weight;
    }
  }
  return sum / total;
}

/// Pixels whose own ray, by the lens model, meets the square around p_cam and that show something else, or the reverse;
/// those within 0.02 px of its border may be either.
int mislabelled(const cv::Mat& instanceIds, const core::CameraModel& camera, const Eigen::Vector3d& p_cam) {
  std::vector<cv::Point2f> raw_px;
  for (int y = 0; y < instanceIds.rows; ++y) {
    for (int x = 0; x < instanceIds.cols; ++x) raw_px.emplace_back(static_cast<float>(x), static_cast<float>(y));
  }
  const auto ideal_px = camera.undistort(raw_px);
  const double margin_m = 0.02 * p_cam.z() / camera.fx_px;
  int count = 0;
  for (std::size_t i = 0; i < raw_px.size(); ++i) {
    const Eigen::Vector2d px(static_cast<double>(ideal_px[i].x), static_cast<double>(ideal_px[i].y));
    const Eigen::Vector3d off = camera.unproject(px, p_cam.z()) - p_cam;
    const double outside_m = std::max(std::abs(off.x()), std::abs(off.y())) - static_cast<double>(kSide_m) / 2;
    if (std::abs(outside_m) < margin_m) continue;
    const bool isSquare = instanceIds.at<std::uint16_t>(cv::Point(raw_px[i])) == 2;
    if (isSquare != (outside_m < 0)) ++count;
  }
  return count;
}

TEST_P(LensOfACamera, ThingsAreSeenWhereTheLensModelPutsThem) {
  const LensView lens(camera_);
  for (const auto& [x, y] : {std::pair(8, 8), {311, 8}, {8, 231}, {311, 231}, {160, 12}, {100, 80}}) {
    const Eigen::Vector3d p_cam = 3.0 * lens.ray(x, y);
    const Scene scene = squareAt((core::T_sensor_cam() * p_cam).cast<float>());
    const Rendering seen = Renderer(scene, camera_).render(0.0, core::T_sensor_cam());
    ASSERT_EQ(seen.color_bgr.size(), cv::Size(320, 240));
    const Eigen::Vector2d expected = camera_.projectDistorted(p_cam);
    cv::Mat green;
    cv::extractChannel(seen.color_bgr, green, 1);
    EXPECT_LT((middleOf(green) - expected).norm(), 0.3) << "colours at " << x << ", " << y;
    EXPECT_EQ(mislabelled(seen.instanceIds, camera_, p_cam), 0) << "around " << x << ", " << y;
    EXPECT_NEAR(seen.depth_m.at<float>(y, x), 3.0F, 1e-4F);
  }
}

TEST_P(LensOfACamera, DepthsOfASlantedSurfaceAreThoseOfTheBentRays) {
  Scene scene;
  scene.textures[Material::Linen] = cv::Mat(16, 16, CV_8UC3, cv::Scalar::all(250));
  scene.things.push_back({{1, "floor", 0, ""}, {{Material::Linen, panel({0, 20, -1}, {0, -40, 0}, {25, 0, 0})}}});
  const Rendering seen = Renderer(scene, camera_).render(0.0, core::T_sensor_cam());
  const LensView lens(camera_);
  for (const int x : {1, 100, 160, 318}) {
    for (const int y : {150, 200, 238}) {
      const double expected_m = 1.0 / lens.ray(x, y).y();  // where the ray has sunk by one metre
      EXPECT_NEAR(static_cast<double>(seen.depth_m.at<float>(y, x)), expected_m, 1e-4 * expected_m);
    }
  }
}

TEST(LensView, RefusesImagesThatALensCannotFill) {
  EXPECT_THROW(LensView(withLens(cameraFor(64, 512), Lens::Wide)), core::InputError);
  EXPECT_THROW(LensView(withLens(cameraFor(64, 512), Lens::Kinect)), core::InputError);
  EXPECT_NO_THROW(LensView(cameraFor(64, 512)));
}

INSTANTIATE_TEST_SUITE_P(Lenses, LensOfACamera, testing::Values(Lens::None, Lens::Kinect, Lens::Wide));

}  // namespace
}  // namespace wardslam::synth

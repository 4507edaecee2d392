#include "rendering/renderer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "camera/camera_options.h"
#include "camera/camera_path.h"
#include "places/ward_scene.h"
#include "wardslam/core/mrpt_compat.h"

namespace wardslam::synth {
namespace {

/// A light wall 4 m ahead and a dark panel 2 m ahead that hides the left half of it; the camera is at the origin.
Scene wallAndPanel() {
  Scene scene;
  scene.textures[Material::Linen] = cv::Mat(16, 16, CV_8UC3, cv::Scalar::all(220));
  scene.textures[Material::Rubber] = cv::Mat(16, 16, CV_8UC3, cv::Scalar::all(40));
  scene.things.push_back({{3, "wall", 0, ""}, {{Material::Linen, panel({4, 10, -10}, {0, -20, 0}, {0, 0, 20})}}});
  scene.things.push_back(
      {{300, "panel", 60, "bed"}, {{Material::Rubber, panel({2, 10, -10}, {0, -10, 0}, {0, 0, 20})}}});
  return scene;
}

TEST(Renderer, DepthIsExactAndIdsEndWhereColoursChange) {
  const Scene scene = wallAndPanel();
  const core::CameraModel camera = cameraFor(640, 480);
  const Rendering seen = Renderer(scene, camera).render(0.0, core::T_sensor_cam());

  for (const int x : {0, 200, 318}) {
    EXPECT_NEAR(seen.depth_m.at<float>(100, x), 2.0F, 1e-5F);
    EXPECT_EQ(seen.instanceIds.at<std::uint16_t>(100, x), 300);
    EXPECT_LT(seen.color_bgr.at<cv::Vec3b>(100, x)[0], 80);
  }
  // The panel ends at y = 0, i.e. between the pixels 319 and 320 around the principal point 319.5.
  EXPECT_EQ(seen.instanceIds.at<std::uint16_t>(100, 319), 300);
  EXPECT_EQ(seen.instanceIds.at<std::uint16_t>(100, 320), 3);
  for (const int x : {321, 500, 639}) {
    EXPECT_NEAR(seen.depth_m.at<float>(400, x), 4.0F, 1e-5F);
    EXPECT_EQ(seen.instanceIds.at<std::uint16_t>(400, x), 3);
    EXPECT_GT(seen.color_bgr.at<cv::Vec3b>(400, x)[0], 120);
  }
}

TEST(Renderer, PixelsLieWhereThePinholeModelPutsThem) {
  // A small bright square around a known point: its centre of light is the point's projection.
  Scene scene;
  scene.textures[Material::Linen] = cv::Mat(16, 16, CV_8UC3, cv::Scalar::all(250));
  const Eigen::Vector3f p(3.0F, 0.6F, -0.4F);
  scene.things.push_back(
      {{1, "square", 0, ""},
       {{Material::Linen, panel(p + Eigen::Vector3f(0, 0.05F, -0.05F), {0, -0.1F, 0}, {0, 0, 0.1F})}}});
  const core::CameraModel camera = cameraFor(640, 480);
  const Rendering seen = Renderer(scene, camera).render(0.0, core::T_sensor_cam());

  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double weight = 0.0;
  for (int y = 0; y < 480; ++y) {
    for (int x = 0; x < 640; ++x) {
      const double light = seen.color_bgr.at<cv::Vec3b>(y, x)[1];
      sum += light * Eigen::Vector2d(x, y);
      weight += light;
    }
  }
  const Eigen::Vector2d expected = camera.project(core::T_sensor_cam().inverse() * p.cast<double>());
  EXPECT_LT((sum / weight - expected).norm(), 0.05);
}

TEST(Renderer, ImagesHaveAnyWidth) {
  const Scene scene = wallAndPanel();
  for (const int width_px : {65, 66, 67, 321}) {
    const Rendering seen = Renderer(scene, cameraFor(width_px, 61)).render(0.0, core::T_sensor_cam());
    ASSERT_EQ(seen.color_bgr.size(), cv::Size(width_px, 61));
    EXPECT_NEAR(seen.depth_m.at<float>(30, 2), 2.0F, 1e-5F);
    EXPECT_EQ(seen.instanceIds.at<std::uint16_t>(30, width_px - 1), 3);
    EXPECT_GT(seen.color_bgr.at<cv::Vec3b>(30, width_px - 1)[0], 120);
  }
}

TEST(Renderer, AWholeWardIsThere) {
  const Scene scene = buildWard({});
  const Rendering seen = Renderer(scene, cameraFor(320, 240)).render(1.0, CameraPath().T_world_cam(1.0));
  EXPECT_EQ(cv::countNonZero(seen.depth_m), 320 * 240) << "no ray leaves a closed room";
  double largest = 0.0;
  cv::minMaxLoc(seen.instanceIds, nullptr, &largest);
  EXPECT_EQ(largest, scene.actors.back()->label().id) << "somebody is in view";
}

}  // namespace
}  // namespace wardslam::synth

#pragma once

#include <mrpt/obs/CObservationStereoImages.h>

#include <Eigen/Geometry>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "wardslam/core/camera_model.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/core/view_rays.h"

namespace wardslam::test {

/// Two cameras that look at a wall painted with random blobs; without changes 320x240 pixels, f = 250 px, 0.1 m apart
/// and rectified: what is z_m away has a disparity of 25 / z_m pixels.
struct StereoScene {
  core::CameraModel left = camera();
  core::CameraModel right = camera();
  Eigen::Isometry3d T_left_right = Eigen::Isometry3d(Eigen::Translation3d(0.1, 0.0, 0.0));
  Eigen::Hyperplane<double, 3> wall{Eigen::Vector3d(0, 0, 1), -2.0};  ///< In the frame of the left camera, m.

  [[nodiscard]] static core::CameraModel camera() {
    core::CameraModel camera;
    camera.width_px = 320;
    camera.height_px = 240;
    camera.fx_px = camera.fy_px = 250.0;
    camera.cx_px = 159.5;
    camera.cy_px = 119.5;
    return camera;
  }

  /// Stamped 1000 s + `number`; the robot's base is the left optical frame.
  [[nodiscard]] mrpt::obs::CObservationStereoImages::Ptr record(int number = 0) const {
    auto pair = mrpt::obs::CObservationStereoImages::Create();
    pair->timestamp = core::toMrptTime(1000.0 + number);
    pair->sensorLabel = "STEREO";
    pair->leftCamera = core::toMrpt(left);
    pair->rightCamera = core::toMrpt(right);
    pair->rightCameraPose = mrpt::poses::CPose3DQuat(core::toMrpt(T_left_right));
    pair->imageLeft = mrpt::img::CImage(look(left, Eigen::Isometry3d::Identity()), mrpt::img::DEEP_COPY);
    pair->imageRight = mrpt::img::CImage(look(right, T_left_right), mrpt::img::DEEP_COPY);
    pair->hasImageRight = true;
    return pair;
  }

 private:
  [[nodiscard]] cv::Mat look(const core::CameraModel& camera, const Eigen::Isometry3d& T_left_cam) const {
    constexpr double kTexels_per_m = 125.0;
    const cv::Mat rays = core::viewRays(camera);
    cv::Mat image(rays.size(), CV_8UC1);
    image.forEach<std::uint8_t>([&](std::uint8_t& gray, const int* pixel) {
      const auto& ray = rays.at<cv::Vec2f>(pixel);
      const Eigen::Vector3d direction = T_left_cam.linear() * Eigen::Vector3d(ray[0], ray[1], 1.0);
      const double distance = -wall.signedDistance(T_left_cam.translation()) / wall.normal().dot(direction);
      const Eigen::Vector3d p_m = T_left_cam.translation() + distance * direction;
      gray = cv::saturate_cast<std::uint8_t>(paintAt(kTexels_per_m * p_m.x(), kTexels_per_m * p_m.y()));
    });
    return image;
  }

  /// 0..255, repeated without end.
  [[nodiscard]] static double paintAt(double x, double y) {
    constexpr int kSize = 512;
    static const cv::Mat paint = [] {
      cv::Mat noise(kSize, kSize, CV_32FC1);
      cv::RNG(7).fill(noise, cv::RNG::UNIFORM, 0.0F, 255.0F);
      cv::GaussianBlur(noise, noise, {}, 1.2, 1.2);
      cv::normalize(noise, noise, 0.0, 255.0, cv::NORM_MINMAX);
      return noise;
    }();
    const int column = static_cast<int>(std::floor(x));
    const int row = static_cast<int>(std::floor(y));
    const auto texel = [](int r, int c) {
      return static_cast<double>(paint.at<float>(r & (kSize - 1), c & (kSize - 1)));
    };
    const auto between = [](double a, double b, double share) { return a + share * (b - a); };
    return between(between(texel(row, column), texel(row, column + 1), x - column),
                   between(texel(row + 1, column), texel(row + 1, column + 1), x - column), y - row);
  }
};

}  // namespace wardslam::test

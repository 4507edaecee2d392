#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>

#include "wardslam/core/camera_model.h"

namespace wardslam::test {

/// The inside of a box whose walls are full of random blobs, drawn with exact depth.
class TexturedRoom {
 public:
  struct View {
    cv::Mat color_bgr;  ///< CV_8UC3
    cv::Mat depth_m;    ///< CV_32FC1
  };

  explicit TexturedRoom(std::uint64_t seed = 1) {
    for (cv::Mat& pattern : patterns_) {
      pattern.create(kPattern_px, kPattern_px, CV_32FC1);
      cv::RNG(seed++).fill(pattern, cv::RNG::UNIFORM, 0.0, 255.0);
      cv::GaussianBlur(pattern, pattern, {}, 0.7);
    }
  }

  /// What a camera of 320x240 pixels sees from `T_room_cam`, which must be inside the room.
  [[nodiscard]] View look(const Eigen::Isometry3d& T_room_cam) const {
    const core::CameraModel camera = camera320x240();
    const cv::Size size_px(camera.width_px, camera.height_px);
    View view{cv::Mat(size_px, CV_8UC3), cv::Mat(size_px, CV_32FC1)};
    view.depth_m.forEach<float>([&](float& depth_m, const int* at) {
      const Eigen::Vector3d ray_room = T_room_cam.linear() * camera.unproject({at[1], at[0]}, 1.0);
      const Hit hit = follow(T_room_cam.translation(), ray_room);
      depth_m = static_cast<float>(hit.depth_m);
      view.color_bgr.at<cv::Vec3b>(at[0], at[1]) = cv::Vec3b::all(hit.gray);
    });
    return view;
  }

  [[nodiscard]] static core::CameraModel camera320x240() {
    core::CameraModel camera;
    camera.width_px = 320;
    camera.height_px = 240;
    camera.fx_px = camera.fy_px = 262.5;
    camera.cx_px = 159.5;
    camera.cy_px = 119.5;
    return camera;
  }

  /// A slow walk: a centimetre and half a degree per image. T_room_cam(0) is the identity.
  [[nodiscard]] static Eigen::Isometry3d T_room_cam(int image) {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.translation() = image * Eigen::Vector3d(0.008, -0.002, 0.006);
    T.linear() = Eigen::AngleAxisd(image * M_PI / 360, Eigen::Vector3d(0.2, 1.0, 0.1).normalized()).matrix();
    return T;
  }

 private:
  struct Hit {
    double depth_m;
    uchar gray;
  };

  [[nodiscard]] Hit follow(const Eigen::Vector3d& from_m, const Eigen::Vector3d& ray) const {
    const Eigen::Vector3d min_m(-2.0, -1.5, -1.0);
    const Eigen::Vector3d max_m(2.0, 1.5, 3.5);
    const Eigen::Array3d wall_m = (ray.array() > 0).select(max_m, min_m);
    Eigen::Index axis = 0;
    const double depth_m = ((wall_m - from_m.array()) / ray.array()).minCoeff(&axis);
    const Eigen::Vector3d p_m = from_m + depth_m * ray;
    return {depth_m, grayAt(axis, p_m[(axis + 1) % 3], p_m[(axis + 2) % 3])};
  }

  [[nodiscard]] uchar grayAt(Eigen::Index axis, double u_m, double v_m) const {
    const double u = (u_m + kHalf_m) / kBlob_m;
    const double v = (v_m + kHalf_m) / kBlob_m;
    const int column = static_cast<int>(u);
    const int row = static_cast<int>(v);
    const double right = u - column;
    const double below = v - row;
    const cv::Mat& pattern = patterns_[static_cast<std::size_t>(axis)];
    const auto at = [&](int r, int c) { return static_cast<double>(pattern.at<float>(r, c)); };
    return cv::saturate_cast<uchar>((1 - below) * ((1 - right) * at(row, column) + right * at(row, column + 1)) +
                                    below * ((1 - right) * at(row + 1, column) + right * at(row + 1, column + 1)));
  }

  static constexpr double kBlob_m = 0.03;
  static constexpr double kHalf_m = 4.0;
  static constexpr int kPattern_px = 272;  // 8 m and a margin

  std::array<cv::Mat, 3> patterns_;
};

}  // namespace wardslam::test

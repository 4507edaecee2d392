#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "wardslam/core/frame.h"

/// A scene for tests whose every pixel can be worked out: textured boards across the z axis of the map, seen by a
/// camera that looks along it or turns.
namespace wardslam::change::test {

inline constexpr int kWidth = 640;
inline constexpr int kHeight = 480;

inline core::CameraModel camera() {
  core::CameraModel camera;
  camera.width_px = kWidth;
  camera.height_px = kHeight;
  camera.fx_px = camera.fy_px = 500.0;
  camera.cx_px = 320.0;
  camera.cy_px = 240.0;
  return camera;
}

/// A board across the z axis: its middle and its size in metres.
struct Board {
  Eigen::Vector3d p_map_m;
  double width_m;
  double height_m;
  cv::Mat texture;  ///< CV_8UC1.

  /// In the image of a camera at `c` that looks along z.
  [[nodiscard]] cv::Rect2d boxSeenFrom(const Eigen::Vector3d& c) const {
    const Eigen::Vector3d p = p_map_m - c;
    const double scale = camera().fx_px / p.z();
    return {camera().cx_px + (p.x() - width_m / 2) * scale, camera().cy_px + (p.y() - height_m / 2) * scale,
            width_m * scale, height_m * scale};
  }
};

/// Blobs of random grey, the same for the same seed.
inline cv::Mat texture(int seed, cv::Size size) {
  cv::Mat noise(size, CV_8UC1);
  cv::RNG random(static_cast<std::uint64_t>(seed));
  random.fill(noise, cv::RNG::UNIFORM, 0, 256);
  cv::GaussianBlur(noise, noise, {0, 0}, 2.0);
  cv::normalize(noise, noise, 0, 255, cv::NORM_MINMAX);
  return noise;
}

/// Takes pixels of the board's texture to the image.
inline cv::Matx33d homography(const Board& board, const Eigen::Isometry3d& T_map_cam) {
  const core::CameraModel model = camera();
  const double step_m = board.width_m / board.texture.cols;
  const Eigen::Isometry3d T_cam_map = T_map_cam.inverse();
  const Eigen::Vector3d corner(board.p_map_m.x() - board.width_m / 2, board.p_map_m.y() - board.height_m / 2,
                               board.p_map_m.z());
  Eigen::Matrix3d K;
  K << model.fx_px, 0, model.cx_px, 0, model.fy_px, model.cy_px, 0, 0, 1;
  Eigen::Matrix3d plane;
  plane << step_m * T_cam_map.linear().leftCols<1>(), board.height_m / board.texture.rows * T_cam_map.linear().col(1),
      T_cam_map * corner;
  const Eigen::Matrix3d H = K * plane;
  return {H(0, 0), H(0, 1), H(0, 2), H(1, 0), H(1, 1), H(1, 2), H(2, 0), H(2, 1), H(2, 2)};
}

/// Draws the board where it is seen, over what is there.
inline void draw(const Board& board, const Eigen::Isometry3d& T_map_cam, core::Frame& frame) {
  const cv::Matx33d H = homography(board, T_map_cam);
  cv::Mat gray;
  cv::Mat mask;
  const cv::Mat all(board.texture.size(), CV_8UC1, cv::Scalar(255));
  cv::warpPerspective(board.texture, gray, H, frame.gray.size(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  cv::warpPerspective(all, mask, H, frame.gray.size(), cv::INTER_NEAREST);
  gray.copyTo(frame.gray, mask);
  const double ahead_m = board.p_map_m.z() - T_map_cam.translation().z();
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      if (mask.at<std::uint8_t>(y, x) == 0) continue;
      const double alongZ = (T_map_cam.linear() * camera().unproject({x, y}, 1.0)).z();
      frame.depth_m.at<float>(y, x) = static_cast<float>(ahead_m / alongZ);
    }
  }
}

/// A camera at `c`, turned to the right.
inline Eigen::Isometry3d looking(const Eigen::Vector3d& c, double right_rad) {
  return Eigen::Translation3d(c) * Eigen::AngleAxisd(right_rad, Eigen::Vector3d::UnitY());
}

/// A wall 3 m away and boards in front of it.
class Scene {
 public:
  Scene() : wall_{{0, 0, 3.0}, 8.0, 6.0, texture(1, {1600, 1200})} {}

  void add(const Board& board) { boards_.push_back(board); }
  [[nodiscard]] Board& board(std::size_t i) { return boards_[i]; }

  /// What the camera sees; with key points every 16 px.
  [[nodiscard]] core::Frame frame(double stamp_s, const Eigen::Vector3d& c) const {
    return frame(stamp_s, looking(c, 0.0));
  }
  [[nodiscard]] core::Frame frame(double stamp_s, const Eigen::Isometry3d& T_map_cam) const {
    core::Frame frame;
    frame.index = static_cast<std::uint64_t>(std::lround(stamp_s * 30));
    frame.stamp_s = stamp_s;
    frame.camera = camera();
    frame.gray = cv::Mat(kHeight, kWidth, CV_8UC1, cv::Scalar(0));
    frame.depth_m = cv::Mat(kHeight, kWidth, CV_32FC1, cv::Scalar(0));
    draw(wall_, T_map_cam, frame);
    for (const Board& board : boards_) draw(board, T_map_cam, frame);
    cv::cvtColor(frame.gray, frame.color_bgr, cv::COLOR_GRAY2BGR);
    for (int y = 16; y < kHeight - 16; y += 16) {
      for (int x = 16; x < kWidth - 16; x += 16) frame.features.keypoints.push_back(keypoint(frame, x, y));
    }
    return frame;
  }

 private:
  static core::Keypoint keypoint(const core::Frame& frame, int x, int y) {
    core::Keypoint keypoint;
    keypoint.raw_px = keypoint.undistorted_px = {static_cast<float>(x), static_cast<float>(y)};
    keypoint.depth_m = frame.depth_m.at<float>(y, x);
    return keypoint;
  }

  Board wall_;
  std::vector<Board> boards_;
};

/// A man-sized board 1.5 m away, left of the middle.
inline Board person() { return {{-0.3, 0.1, 1.5}, 0.5, 1.2, texture(7, {250, 600})}; }

inline constexpr double kFrameTime_s = 1.0 / 30;

}  // namespace wardslam::change::test

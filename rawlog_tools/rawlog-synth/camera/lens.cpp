#include "camera/lens.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>

#include "wardslam/core/errors.h"

namespace wardslam::synth {
namespace {

constexpr double kWidest = 3.0;  ///< Length of a ray with z = 1: 70 degrees off the axis.
constexpr int kMargin_px = 2;    ///< So that bilinear lookups at the rim have neighbours.

/// The ideal pixels of those of an image of that size in which the camera sees the same, CV_32FC2.
cv::Mat undistortedPixels(const core::CameraModel& camera, const cv::Size& size_px) {
  const double columns = static_cast<double>(camera.width_px) / size_px.width;
  const double rows = static_cast<double>(camera.height_px) / size_px.height;
  std::vector<cv::Point2f> raw_px;
  raw_px.reserve(static_cast<std::size_t>(size_px.area()));
  for (int y = 0; y < size_px.height; ++y) {
    for (int x = 0; x < size_px.width; ++x) {
      raw_px.emplace_back(static_cast<float>((x + 0.5) * columns - 0.5), static_cast<float>((y + 0.5) * rows - 0.5));
    }
  }
  return cv::Mat(camera.hasDistortion() ? camera.undistort(raw_px) : raw_px, true).reshape(2, size_px.height);
}

/// CV_64FC3
cv::Mat raysThrough(const cv::Mat& pixels, const core::CameraModel& camera) {
  cv::Mat rays(pixels.size(), CV_64FC3);
  rays.forEach<cv::Vec3d>([&](cv::Vec3d& ray, const int* at) {
    const auto& ideal = pixels.at<cv::Vec2f>(at[0], at[1]);
    const Eigen::Vector3d p = camera.unproject(Eigen::Vector2d(ideal[0], ideal[1]), 1.0);
    ray = {p.x(), p.y(), p.z()};
  });
  return rays;
}

/// Far outside of the images that a lens is made for its model folds back: then no ray leads to a pixel any more.
void checkThatRaysExist(const cv::Mat& pixels, const core::CameraModel& camera) {
  constexpr double kNear_px = 0.1;
  for (int y = 0; y < pixels.rows; ++y) {
    for (int x = 0; x < pixels.cols; ++x) {
      const auto& ideal = pixels.at<cv::Vec2f>(y, x);
      const Eigen::Vector3d ray = camera.unproject(Eigen::Vector2d(ideal[0], ideal[1]), 1.0);
      const double off_px = (camera.projectDistorted(ray) - Eigen::Vector2d(x, y)).norm();
      if (off_px < kNear_px && ray.norm() < kWidest) continue;
      throw core::InputError("--lens: this lens cannot fill an image of " + std::to_string(camera.width_px) + " x " +
                             std::to_string(camera.height_px) + " pixels; take one that is wider than high");
    }
  }
}

/// The camera without its lens, with an image that holds all of these pixels.
core::CameraModel covering(const cv::Mat& pixels, core::CameraModel camera) {
  cv::Mat xy[2];
  cv::split(pixels, xy);
  double left = 0;
  double right = 0;
  double top = 0;
  double bottom = 0;
  cv::minMaxLoc(xy[0], &left, &right);
  cv::minMaxLoc(xy[1], &top, &bottom);
  const int x0 = static_cast<int>(std::floor(left)) - kMargin_px;
  const int y0 = static_cast<int>(std::floor(top)) - kMargin_px;
  camera.width_px = static_cast<int>(std::ceil(right)) + kMargin_px + 1 - x0;
  camera.height_px = static_cast<int>(std::ceil(bottom)) + kMargin_px + 1 - y0;
  camera.cx_px -= x0;
  camera.cy_px -= y0;
  camera.k1 = camera.k2 = camera.p1 = camera.p2 = camera.k3 = 0.0;
  return camera;
}

}  // namespace

core::CameraModel withLens(core::CameraModel camera, Lens lens) {
  if (lens == Lens::Kinect) {
    camera.k1 = 0.2624;
    camera.k2 = -0.9531;
    camera.p1 = -0.0054;
    camera.p2 = 0.0026;
    camera.k3 = 1.1633;
  } else if (lens == Lens::Wide) {
    camera.k1 = -0.28;
    camera.k2 = 0.07;
  }
  return camera;
}

LensView::LensView(const core::CameraModel& camera) : camera_(camera), pinhole_(camera) {
  const cv::Mat pixels = undistortedPixels(camera, {camera.width_px, camera.height_px});
  rays_ = raysThrough(pixels, camera);
  if (!camera.hasDistortion()) return;
  checkThatRaysExist(pixels, camera);
  pinhole_ = covering(pixels, camera);
}

Directions LensView::rays(const cv::Size& size_px) const {
  cv::Mat rays;
  raysThrough(undistortedPixels(camera_, size_px), camera_).convertTo(rays, CV_32F);
  Directions directions;
  cv::extractChannel(rays, directions.x, 0);
  cv::extractChannel(rays, directions.y, 1);
  return directions;
}

}  // namespace wardslam::synth

#include "lens.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>

#include "wardslam/core/errors.h"

namespace wardslam::synth {
namespace {

constexpr double kWidest = 3.0;  ///< Length of a ray with z = 1: 70 degrees off the axis.
constexpr int kMargin_px = 2;    ///< So that bilinear lookups at the rim have neighbours.

/// The ideal pixel of every pixel of the camera, CV_32FC2.
cv::Mat undistortedPixels(const core::CameraModel& camera) {
  std::vector<cv::Point2f> raw_px;
  raw_px.reserve(static_cast<std::size_t>(camera.width_px) * static_cast<std::size_t>(camera.height_px));
  for (int y = 0; y < camera.height_px; ++y) {
    for (int x = 0; x < camera.width_px; ++x) raw_px.emplace_back(static_cast<float>(x), static_cast<float>(y));
  }
  const auto ideal_px = camera.undistort(raw_px);
  return cv::Mat(ideal_px, true).reshape(2, camera.height_px);
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

LensView::LensView(const core::CameraModel& camera) : pinhole_(camera) {
  if (!camera.hasDistortion()) return;
  where_px_ = undistortedPixels(camera);
  checkThatRaysExist(where_px_, camera);
  pinhole_ = covering(where_px_, camera);
  const cv::Scalar shift(pinhole_.cx_px - camera.cx_px, pinhole_.cy_px - camera.cy_px);
  cv::add(where_px_, shift, where_px_);
}

cv::Mat LensView::colours(const cv::Mat& ofPinhole) const {
  if (isIdeal()) return ofPinhole;
  cv::Mat seen;
  cv::remap(ofPinhole, seen, where_px_, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  return seen;
}

cv::Mat LensView::nearest(const cv::Mat& ofPinhole) const {
  if (isIdeal()) return ofPinhole;
  cv::Mat seen(where_px_.size(), ofPinhole.type());
  const std::size_t size = ofPinhole.elemSize();
  const auto scale = static_cast<float>(ofPinhole.cols / pinhole_.width_px);
  const auto nearestTo = [scale](float at_px) { return cvRound((at_px + 0.5F) * scale - 0.5F); };
  for (int y = 0; y < seen.rows; ++y) {
    const auto* where = where_px_.ptr<cv::Vec2f>(y);
    for (int x = 0; x < seen.cols; ++x) {
      std::copy_n(ofPinhole.ptr(nearestTo(where[x][1]), nearestTo(where[x][0])), size, seen.ptr(y, x));
    }
  }
  return seen;
}

Eigen::Vector3d LensView::ray(int x_px, int y_px) const {
  if (isIdeal()) return pinhole_.unproject(Eigen::Vector2d(x_px, y_px), 1.0);
  const auto& where = where_px_.at<cv::Vec2f>(y_px, x_px);
  return pinhole_.unproject(Eigen::Vector2d(where[0], where[1]), 1.0);
}

}  // namespace wardslam::synth

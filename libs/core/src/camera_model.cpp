#include "wardslam/core/camera_model.h"

#include <mrpt/img/TCamera.h>

#include <cmath>
#include <opencv2/calib3d.hpp>

namespace wardslam::core {
namespace {

/// Whether the distorted radius stops to grow with the ideal one before that is sqrt(r2): its derivative,
/// 1 + 3 k1 s + 5 k2 s^2 + 7 k3 s^3 with s = r^2, has its least values at the end and where its own derivative is 0.
bool foldsWithin(double r2, const CameraModel& camera) {
  const double a = 3.0 * camera.k1;
  const double b = 5.0 * camera.k2;
  const double c = 7.0 * camera.k3;
  const auto folds = [&](double s) { return 1.0 + s * (a + s * (b + s * c)) <= 0.0; };
  if (folds(r2)) return true;
  const auto foldsInside = [&](double s) { return s > 0.0 && s < r2 && folds(s); };
  if (c == 0.0) return b != 0.0 && foldsInside(-a / (2.0 * b));
  const double discriminant = b * b - 3.0 * a * c;
  if (discriminant < 0.0) return false;
  const double root = std::sqrt(discriminant);
  return foldsInside((-b + root) / (3.0 * c)) || foldsInside((-b - root) / (3.0 * c));
}

}  // namespace

std::vector<cv::Point2f> CameraModel::undistort(const std::vector<cv::Point2f>& raw_px) const {
  if (raw_px.empty() || !hasDistortion()) return raw_px;
  const cv::Matx33d K(fx_px, 0, cx_px, 0, fy_px, cy_px, 0, 0, 1);
  const cv::Vec<double, 5> lens(k1, k2, p1, p2, k3);
  std::vector<cv::Point2f> undistorted_px;
  const cv::TermCriteria converged(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 40, 1e-4);
  cv::undistortPoints(raw_px, undistorted_px, K, lens, cv::noArray(), K, converged);
  return undistorted_px;
}

Eigen::Vector2d CameraModel::projectDistorted(const Eigen::Vector3d& p_cam) const {
  const double x = p_cam.x() / p_cam.z();
  const double y = p_cam.y() / p_cam.z();
  const double r2 = x * x + y * y;
  const double radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
  const double xd = x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x);
  const double yd = y * radial + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y;
  return {fx_px * xd + cx_px, fy_px * yd + cy_px};
}

std::optional<Eigen::Vector2d> CameraModel::seenAt(const Eigen::Vector3d& p_cam) const {
  if (p_cam.z() <= 0.0) return std::nullopt;
  const double r2 = (p_cam.head<2>() / p_cam.z()).squaredNorm();
  if (hasDistortion() && foldsWithin(r2, *this)) return std::nullopt;
  const Eigen::Vector2d raw_px = hasDistortion() ? projectDistorted(p_cam) : project(p_cam);
  const bool isInside =
      raw_px.x() > -0.5 && raw_px.x() < width_px - 0.5 && raw_px.y() > -0.5 && raw_px.y() < height_px - 0.5;
  return isInside ? std::optional(raw_px) : std::nullopt;
}

CameraModel fromMrpt(const mrpt::img::TCamera& camera) {
  CameraModel model;
  model.width_px = static_cast<int>(camera.ncols);
  model.height_px = static_cast<int>(camera.nrows);
  model.fx_px = camera.fx();
  model.fy_px = camera.fy();
  model.cx_px = camera.cx();
  model.cy_px = camera.cy();
  if (camera.distortion == mrpt::img::DistortionModel::none) return model;  // MRPT then ignores the coefficients
  model.k1 = camera.k1();
  model.k2 = camera.k2();
  model.p1 = camera.p1();
  model.p2 = camera.p2();
  model.k3 = camera.k3();
  return model;
}

mrpt::img::TCamera toMrpt(const CameraModel& camera) {
  mrpt::img::TCamera mrptCamera;
  mrptCamera.ncols = static_cast<uint32_t>(camera.width_px);
  mrptCamera.nrows = static_cast<uint32_t>(camera.height_px);
  mrptCamera.setIntrinsicParamsFromValues(camera.fx_px, camera.fy_px, camera.cx_px, camera.cy_px);
  mrptCamera.setDistortionPlumbBob(camera.k1, camera.k2, camera.p1, camera.p2, camera.k3);
  return mrptCamera;
}

}  // namespace wardslam::core

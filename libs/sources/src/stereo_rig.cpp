#include "stereo_rig.h"

#include <mrpt/obs/CObservationStereoImages.h>

#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>
#include <opencv2/imgproc.hpp>

#include "wardslam/core/camera_limits.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"

namespace wardslam::sources {
namespace {

// Images this close to rectified have matches less than a tenth of a pixel off their row.
constexpr double kSameCamera_px = 0.05;
constexpr double kSameDirection_rad = 1e-4;
constexpr double kSideBySide = 1e-3;  // of the baseline

cv::Matx33d matrixOf(const core::CameraModel& c) { return {c.fx_px, 0, c.cx_px, 0, c.fy_px, c.cy_px, 0, 0, 1}; }

cv::Vec<double, 5> lensOf(const core::CameraModel& c) { return {c.k1, c.k2, c.p1, c.p2, c.k3}; }

bool isRectified(const core::CameraModel& left, const core::CameraModel& right, const Eigen::Isometry3d& T_left_right) {
  const Eigen::Vector3d& t_m = T_left_right.translation();
  const auto isSame = [](double a_px, double b_px) { return std::abs(a_px - b_px) < kSameCamera_px; };
  return !left.hasDistortion() && !right.hasDistortion() && isSame(left.fx_px, right.fx_px) &&
         isSame(left.fy_px, right.fy_px) && isSame(left.cy_px, right.cy_px) &&
         Eigen::AngleAxisd(T_left_right.linear()).angle() < kSameDirection_rad &&
         std::hypot(t_m.y(), t_m.z()) < kSideBySide * t_m.norm();
}

StereoRig rectify(const core::CameraModel& left, const core::CameraModel& right,
                  const Eigen::Isometry3d& T_left_right) {
  const Eigen::Isometry3d T_right_left = T_left_right.inverse();
  cv::Matx33d R;
  cv::Vec3d t_m;
  cv::eigen2cv(Eigen::Matrix3d(T_right_left.linear()), R);
  cv::eigen2cv(Eigen::Vector3d(T_right_left.translation()), t_m);
  const cv::Size size_px(left.width_px, left.height_px);
  cv::Matx33d rotateLeft;
  cv::Matx33d rotateRight;
  cv::Matx34d projectLeft;
  cv::Matx34d projectRight;
  cv::Matx44d unused;
  cv::stereoRectify(matrixOf(left), lensOf(left), matrixOf(right), lensOf(right), size_px, R, t_m, rotateLeft,
                    rotateRight, projectLeft, projectRight, unused, cv::CALIB_ZERO_DISPARITY, 0.0, size_px);
  StereoRig rig;
  rig.camera.width_px = left.width_px;
  rig.camera.height_px = left.height_px;
  rig.camera.fx_px = projectLeft(0, 0);
  rig.camera.fy_px = projectLeft(1, 1);
  rig.camera.cx_px = projectLeft(0, 2);
  rig.camera.cy_px = projectLeft(1, 2);
  rig.baseline_m = -projectRight(0, 3) / projectRight(0, 0);
  Eigen::Matrix3d R_rectified_left;
  cv::cv2eigen(cv::Mat(rotateLeft), R_rectified_left);
  rig.R_left_rectified = R_rectified_left.transpose();
  cv::initUndistortRectifyMap(matrixOf(left), lensOf(left), rotateLeft, projectLeft, size_px, CV_32FC1, rig.left.x,
                              rig.left.y);
  cv::initUndistortRectifyMap(matrixOf(right), lensOf(right), rotateRight, projectRight, size_px, CV_32FC1, rig.right.x,
                              rig.right.y);
  return rig;
}

/// Lenses and poses that no pair of cameras has can lead anywhere.
StereoRig requireSound(StereoRig rig) {
  const core::CameraModel& camera = rig.camera;
  const bool isSound = camera.fx_px >= 1.0 && camera.fx_px <= core::kLongestFocus_px && std::isfinite(camera.fy_px) &&
                       std::isfinite(camera.cx_px) && std::isfinite(camera.cy_px) && rig.baseline_m > 0.0 &&
                       rig.baseline_m <= core::kLongestBaseline_m && rig.R_left_rectified.allFinite();
  if (isSound) return rig;
  throw core::FrameError(
      "the calibration of the stereo pair cannot be rectified; correct it with rawlog-edit --camera-params");
}

}  // namespace

StereoRig rigOf(const mrpt::obs::CObservationStereoImages& pair) {
  const core::CameraModel left = core::fromMrpt(pair.leftCamera);
  const core::CameraModel right = core::fromMrpt(pair.rightCamera);
  const Eigen::Isometry3d T_left_right = core::fromMrpt(mrpt::poses::CPose3D(pair.rightCameraPose));
  const Eigen::Vector3d& t_m = T_left_right.translation();
  if (t_m.x() < std::hypot(t_m.y(), t_m.z())) {
    throw core::FrameError(
        "the right camera of the stereo pair does not stand to the right of the left one; correct its pose with "
        "rawlog-edit --camera-params (x to the right, z forward)");
  }
  if (!isRectified(left, right, T_left_right)) return requireSound(rectify(left, right, T_left_right));
  StereoRig rig;
  rig.camera = left;
  rig.baseline_m = t_m.x();
  rig.disparityOfInfinity_px = left.cx_px - right.cx_px;
  return rig;
}

}  // namespace wardslam::sources

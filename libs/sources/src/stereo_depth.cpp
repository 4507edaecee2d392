#include "stereo_depth.h"

#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationStereoImages.h>

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <string>

#include "observation_check.h"
#include "stereo_rig.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"

namespace wardslam::sources {
namespace {

using mrpt::obs::CObservation3DRangeScan;
using mrpt::obs::CObservationStereoImages;

constexpr double kRangeUnits_m = 0.001;
constexpr double kDisparityUnits_px = 1.0 / static_cast<double>(cv::StereoMatcher::DISP_SCALE);

cv::Mat rectified(const mrpt::img::CImage& image, const StereoRig::Maps& maps) {
  const cv::Mat& recorded = image.asCvMatRef();
  if (maps.x.empty()) return recorded;
  cv::Mat out;
  cv::remap(recorded, out, maps.x, maps.y, cv::INTER_LINEAR);
  return out;
}

cv::Mat grayOf(const cv::Mat& image) {
  if (image.channels() == 1) return image;
  cv::Mat gray;
  cv::cvtColor(image, gray, cv::COLOR_BGR2GRAY);
  return gray;
}

/// Columns added on the left, or what the right camera sees only in part would get no depth at all.
cv::Mat widened(const cv::Mat& gray, int columns) {
  cv::Mat out;
  cv::copyMakeBorder(gray, out, 0, 0, columns, 0, cv::BORDER_REPLICATE);
  return out;
}

void requireSound(const StereoOptions& options) {
  if (options.block_size_px % 2 == 0) {
    throw core::InputError("sources.stereo.block_size: " + std::to_string(options.block_size_px) +
                           " is even; give an odd width");
  }
  if (options.min_range_m >= options.max_range_m) {
    throw core::InputError("sources.stereo.min_range: must be less than max_range");
  }
}

}  // namespace

/// Matches pairs of one calibration.
class StereoDepth::Matcher {
 public:
  Matcher(const CObservationStereoImages& pair, const StereoOptions& options)
      : leftCamera_(pair.leftCamera),
        rightCamera_(pair.rightCamera),
        rightPose_(pair.rightCameraPose),
        options_(options),
        rig_(rigOf(pair)) {
    constexpr int kUnit_px = 16;  // of the number of disparities
    constexpr int kSpeckleStep_px = 2;
    // What is too far must be found where it is, or it would be found elsewhere.
    const int least_px = static_cast<int>(std::floor(rig_.disparityOfInfinity_px));
    const int most_px = static_cast<int>(std::ceil(rig_.disparityAt_px(options.min_range_m)));
    const int widest_px = std::min(most_px - least_px + 1, rig_.camera.width_px);
    const int count_px = (widest_px + kUnit_px - 1) / kUnit_px * kUnit_px;
    const int area = options.block_size_px * options.block_size_px;
    margin_px_ = std::max(0, least_px + count_px);
    sgbm_ = cv::StereoSGBM::create(least_px, count_px, options.block_size_px, 8 * area, 32 * area,
                                   options.left_right_check_px, 31, options.uniqueness_percent, options.speckle_size_px,
                                   kSpeckleStep_px, cv::StereoSGBM::MODE_SGBM_3WAY);
  }

  [[nodiscard]] bool isFor(const CObservationStereoImages& pair) const {
    return pair.leftCamera == leftCamera_ && pair.rightCamera == rightCamera_ && pair.rightCameraPose == rightPose_;
  }

  [[nodiscard]] const StereoRig& rig() const { return rig_; }

  /// CV_16UC1 in kRangeUnits_m, 0 = none.
  [[nodiscard]] cv::Mat depth(const cv::Mat& left, const cv::Mat& right) const {
    cv::Mat disparity;
    sgbm_->compute(widened(grayOf(left), margin_px_), widened(grayOf(right), margin_px_), disparity);
    cv::Mat depth(left.size(), CV_16UC1);
    depth.forEach<std::uint16_t>([&](std::uint16_t& units, const int* at) {
      const double d_px = kDisparityUnits_px * disparity.at<std::int16_t>(at[0], at[1] + margin_px_);
      const double parallax_px = d_px - rig_.disparityOfInfinity_px;
      const double z_m = parallax_px > 0 ? rig_.camera.fx_px * rig_.baseline_m / parallax_px : 0.0;
      const bool isSeenByBoth = d_px <= at[1];
      const bool isInRange = z_m >= options_.min_range_m && z_m <= options_.max_range_m;
      units = isSeenByBoth && isInRange ? static_cast<std::uint16_t>(std::lround(z_m / kRangeUnits_m)) : 0;
    });
    return depth;
  }

 private:
  mrpt::img::TCamera leftCamera_;
  mrpt::img::TCamera rightCamera_;
  mrpt::poses::CPose3DQuat rightPose_;
  StereoOptions options_;
  StereoRig rig_;
  int margin_px_ = 0;
  cv::Ptr<cv::StereoSGBM> sgbm_;
};

StereoDepth::StereoDepth(const StereoOptions& options) : options_(options) { requireSound(options); }
StereoDepth::~StereoDepth() = default;

std::shared_ptr<CObservation3DRangeScan> StereoDepth::convert(const CObservationStereoImages& pair) {
  if (const auto reason = whyUnusable(pair)) throw core::FrameError("the stereo pair " + *reason);
  if (!matcher_ || !matcher_->isFor(pair)) {
    matcher_ = std::make_unique<Matcher>(pair, options_);
    const StereoRig& rig = matcher_->rig();
    noise_ = {0.0, options_.disparity_sigma_px / (rig.camera.fx_px * rig.baseline_m), 0.0};
  }
  const StereoRig& rig = matcher_->rig();
  const cv::Mat left = rectified(pair.imageLeft, rig.left);
  const cv::Mat depth = matcher_->depth(left, rectified(pair.imageRight, rig.right));

  auto scan = CObservation3DRangeScan::Create();
  scan->timestamp = pair.timestamp;
  scan->sensorLabel = pair.sensorLabel;
  scan->cameraParams = scan->cameraParamsIntensity = core::toMrpt(rig.camera);
  // The pose of a stereo pair is that of the left optical frame, which rectification turns.
  Eigen::Isometry3d T_base_cam = core::fromMrpt(mrpt::poses::CPose3D(pair.cameraPose));
  T_base_cam.rotate(rig.R_left_rectified);
  scan->sensorPose = core::toMrpt(T_base_cam * core::T_sensor_cam().inverse());
  scan->hasIntensityImage = true;
  scan->intensityImage = mrpt::img::CImage(left, mrpt::img::SHALLOW_COPY);
  scan->hasRangeImage = true;
  scan->range_is_depth = true;
  scan->maxRange = static_cast<float>(options_.max_range_m);
  scan->rangeUnits = static_cast<float>(kRangeUnits_m);
  scan->rangeImage_setSize(depth.rows, depth.cols);
  depth.copyTo(cv::Mat(depth.size(), CV_16UC1, scan->rangeImage.data()));
  return scan;
}

}  // namespace wardslam::sources

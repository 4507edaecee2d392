#include "wardslam/sources/frame_builder.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <string>
#include <utility>

#include "depth_registration.h"
#include "observation_check.h"
#include "still_images.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/core/view_rays.h"

namespace wardslam::sources {
namespace {

using mrpt::obs::CObservation3DRangeScan;

/// Beyond the reach of any RGB-D camera.
constexpr double kFarthest_m = 50.0;
/// What some sensors and programs write where they see nothing, besides 0.
constexpr double kNothingMeasured = std::numeric_limits<std::uint16_t>::max();

cv::Mat rangeInMetres(CObservation3DRangeScan& scan) {
  const cv::Mat units(static_cast<int>(scan.rangeImage.rows()), static_cast<int>(scan.rangeImage.cols()), CV_16UC1,
                      scan.rangeImage.data());
  cv::Mat range_m;
  units.convertTo(range_m, CV_32F, scan.rangeUnits);
  range_m.setTo(0.0, units == kNothingMeasured);
  const double largest_m = kNothingMeasured * static_cast<double>(scan.rangeUnits);
  if (largest_m > kFarthest_m) range_m.setTo(0.0, range_m > kFarthest_m);
  return range_m;
}

/// Depth over range per pixel: the cosine of the angle between view ray and optical axis.
cv::Mat cosineToAxis(const core::CameraModel& camera) {
  cv::Mat cosine(camera.height_px, camera.width_px, CV_32FC1);
  const cv::Mat rays = core::viewRays(camera);
  cosine.forEach<float>([&](float& value, const int* pixel) {
    const auto& ray = rays.at<cv::Vec2f>(pixel);
    value = 1.0F / std::sqrt(1.0F + ray.dot(ray));
  });
  return cosine;
}

bool isRegistered(const CObservation3DRangeScan& scan) {
  const auto& depth = scan.cameraParams;
  const auto& color = scan.cameraParamsIntensity;
  return scan.doDepthAndIntensityCamerasCoincide() && depth.ncols == color.ncols && depth.nrows == color.nrows &&
         depth.intrinsicParams == color.intrinsicParams && depth.dist == color.dist;
}

}  // namespace

/// Range image to depth in the colour image. Keeps what depends on the cameras alone, which seldom change.
class FrameBuilder::DepthConverter {
 public:
  [[nodiscard]] cv::Mat convert(CObservation3DRangeScan& scan) {
    follow(scan);
    cv::Mat depth_m = rangeInMetres(scan);
    if (!scan.range_is_depth) {
      if (cosine_.empty()) cosine_ = cosineToAxis(core::fromMrpt(scan.cameraParams));
      cv::multiply(depth_m, cosine_, depth_m);
    }
    if (isRegistered(scan)) return depth_m;
    if (!registration_) registration_.emplace(rigOf(scan));
    return registration_->apply(depth_m);
  }

 private:
  /// Forgets what was worked out for other cameras.
  void follow(const CObservation3DRangeScan& scan) {
    if (scan.cameraParams == depthCamera_ && scan.cameraParamsIntensity == colorCamera_ &&
        scan.relativePoseIntensityWRTDepth == colorPose_) {
      return;
    }
    depthCamera_ = scan.cameraParams;
    colorCamera_ = scan.cameraParamsIntensity;
    colorPose_ = scan.relativePoseIntensityWRTDepth;
    cosine_.release();
    registration_.reset();
  }

  [[nodiscard]] static RgbdRig rigOf(const CObservation3DRangeScan& scan) {
    // The pose of the colour camera is given in MRPT's frame of the depth sensor (x forward), not its optical frame.
    const Eigen::Isometry3d T_sensor_color = core::fromMrpt(scan.relativePoseIntensityWRTDepth);
    return {core::fromMrpt(scan.cameraParams), core::fromMrpt(scan.cameraParamsIntensity),
            T_sensor_color.inverse() * core::T_sensor_cam()};
  }

  mrpt::img::TCamera depthCamera_;
  mrpt::img::TCamera colorCamera_;
  mrpt::poses::CPose3D colorPose_;
  cv::Mat cosine_;
  std::optional<DepthRegistration> registration_;
};

FrameBuilder::FrameBuilder()
    : depthConverter_(std::make_unique<DepthConverter>()), stillImages_(std::make_unique<StillImages>()) {}
FrameBuilder::~FrameBuilder() = default;
FrameBuilder::FrameBuilder(FrameBuilder&&) noexcept = default;
FrameBuilder& FrameBuilder::operator=(FrameBuilder&&) noexcept = default;

core::Frame FrameBuilder::build(std::shared_ptr<CObservation3DRangeScan> observation) {
  if (const auto reason = whyUnusable(*observation)) {
    throw core::FrameError("frame " + std::to_string(nextIndex_) + ": the observation " + *reason);
  }
  requireSameSize(observation->intensityImage.asCvMatRef().size());
  core::Frame frame;
  frame.stamp_s = core::fromMrptTime(observation->timestamp);
  frame.camera = core::fromMrpt(observation->cameraParamsIntensity);
  frame.camera.depthNoise = traits_.depthNoise;
  frame.camera.readout_s = traits_.readout_s;
  frame.T_base_cam =
      core::fromMrpt(observation->sensorPose) * core::fromMrpt(observation->relativePoseIntensityWRTDepth);

  const auto image = observation->intensityImage.asCvMat<cv::Mat>(mrpt::img::SHALLOW_COPY);
  if (image.channels() == 1) {
    frame.gray = image;
    cv::cvtColor(image, frame.color_bgr, cv::COLOR_GRAY2BGR);
  } else {
    frame.color_bgr = image;
    cv::cvtColor(image, frame.gray, cv::COLOR_BGR2GRAY);
  }
  frame.depth_m = depthConverter_->convert(*observation);
  stillImages_->look(frame);
  frame.observation = std::move(observation);
  frame.index = nextIndex_++;
  return frame;
}

void FrameBuilder::requireSameSize(const cv::Size& size_px) {
  if (size_px_.empty()) size_px_ = size_px;
  if (size_px == size_px_) return;
  const auto text = [](const cv::Size& s) { return std::to_string(s.width) + "x" + std::to_string(s.height); };
  throw core::FrameError("frame " + std::to_string(nextIndex_) + ": the image has " + text(size_px) +
                         " pixels, those before it " + text(size_px_) +
                         "; it is left out, as are others like it: give what has another size a run of its own");
}

}  // namespace wardslam::sources

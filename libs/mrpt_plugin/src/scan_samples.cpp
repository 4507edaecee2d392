#include "scan_samples.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <algorithm>
#include <cmath>

#include "scan_pairing.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/core/nearest_pixel.h"
#include "wardslam/mapping/depth_points.h"

namespace wardslam::mrpt_plugin {
namespace {

using mrpt::obs::CObservation3DRangeScan;

std::vector<ScanSample> sample(const core::Frame& frame, const SemanticLikelihoodOptions& options) {
  const auto pixels = static_cast<double>(frame.depth_m.total());
  const int step_px = std::max(1, static_cast<int>(std::sqrt(pixels / options.pixels)));
  std::vector<ScanSample> samples;
  for (const mapping::DepthPoint& point : mapping::depthPoints(frame.depth_m, frame.camera, step_px)) {
    if (point.p_cam_m.z() > options.max_range_m) continue;
    if (!frame.mayMove.empty() && frame.mayMove.at<std::uint8_t>(point.raw_px) != 0) continue;
    samples.push_back({frame.T_base_cam * point.p_cam_m, 0});
  }
  return samples;
}

std::vector<ScanSample> sample(const CObservation3DRangeScan& scan, const SemanticLikelihoodOptions& options) {
  ScanPairing alone;
  try {
    static_cast<void>(alone.put(scan, Eigen::Isometry3d::Identity()));
  } catch (const core::FrameError&) {
    return {};
  }
  return sample(alone.flush()->frame, options);
}

std::vector<ScanSample> sample(const CObservationSemanticRGBD& semantic, const SemanticLikelihoodOptions& options) {
  const Eigen::Isometry3d T_base_cam = core::fromMrpt(semantic.cameraPose) * core::T_sensor_cam();
  const std::size_t step =
      std::max<std::size_t>(1, semantic.features.size() / static_cast<std::size_t>(options.pixels));
  const cv::Mat& classIds = semantic.segmentation.classIds;
  std::vector<ScanSample> samples;
  for (std::size_t i = 0; i < semantic.features.size(); i += step) {
    const auto p_cam_m = semantic.pointInCamera(i);
    if (!p_cam_m || p_cam_m->z() > options.max_range_m || semantic.states.at(i) == KeypointState::Dynamic) continue;
    const cv::Point2f& raw_px = semantic.features.keypoints[i].raw_px;
    const core::ClassId classId =
        classIds.empty() ? core::ClassId{0} : classIds.at<core::ClassId>(core::nearestPixel(raw_px, classIds.size()));
    samples.push_back({T_base_cam * *p_cam_m, classId});
  }
  return samples;
}

}  // namespace

bool canBeSampled(const mrpt::obs::CObservation& observation) {
  const auto* scan = dynamic_cast<const CObservation3DRangeScan*>(&observation);
  if (scan != nullptr) return scan->hasRangeImage && scan->hasIntensityImage;
  return dynamic_cast<const CObservationSemanticRGBD*>(&observation) != nullptr;
}

std::vector<ScanSample> sampleObservation(const mrpt::obs::CObservation& observation,
                                          const SemanticLikelihoodOptions& options) {
  if (const auto* scan = dynamic_cast<const CObservation3DRangeScan*>(&observation)) return sample(*scan, options);
  if (const auto* semantic = dynamic_cast<const CObservationSemanticRGBD*>(&observation))
    return sample(*semantic, options);
  return {};
}

}  // namespace wardslam::mrpt_plugin

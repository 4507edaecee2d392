#include "wardslam/mrpt_plugin/frame_conversion.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <array>

#include "wardslam/core/mrpt_compat.h"
#include "wardslam/core/nearest_pixel.h"
#include "wardslam/features/semantic_descriptor.h"

namespace wardslam::mrpt_plugin {
namespace {

KeypointState stateOf(const core::Keypoint& keypoint, const cv::Mat& labelBits) {
  if (keypoint.motion == core::Motion::Dynamic) return KeypointState::Dynamic;
  if (labelBits.empty()) return KeypointState::Static;
  const auto bits = labelBits.at<std::uint8_t>(core::nearestPixel(keypoint.raw_px, labelBits.size()));
  const bool isMovable = (bits & core::bitOf(core::PixelLabel::Movable)) != 0;
  return isMovable ? KeypointState::Movable : KeypointState::Static;
}

std::map<core::ClassId, std::string> namesIn(const cv::Mat& classIds, const core::LabelSpace& labels) {
  std::array<bool, 256> isThere{};
  for (int row = 0; row < classIds.rows; ++row) {
    const auto* ids = classIds.ptr<core::ClassId>(row);
    for (int col = 0; col < classIds.cols; ++col) isThere[ids[col]] = true;
  }
  std::map<core::ClassId, std::string> names;
  for (int c = 1; c < 256; ++c) {
    const auto id = static_cast<core::ClassId>(c);
    if (isThere[id] && !labels.name(id).empty()) names.emplace(id, labels.name(id));
  }
  return names;
}

}  // namespace

std::shared_ptr<CObservationSemanticRGBD> toObservation(const core::Frame& frame, const core::LabelSpace& labels,
                                                        int descriptorSide) {
  auto observation = CObservationSemanticRGBD::Create();
  observation->timestamp = core::toMrptTime(frame.stamp_s);
  observation->sensorLabel = kSemanticSuffix;
  if (frame.observation) {
    observation->timestamp = frame.observation->timestamp;  // exactly
    observation->sensorLabel = frame.observation->sensorLabel + kSemanticSuffix;
  }
  observation->labelBits = frame.labelBits;
  observation->cameraPose = core::toMrpt(frame.T_base_cam * core::T_sensor_cam().inverse());
  observation->camera = frame.camera;
  observation->segmentation = frame.segmentation;
  observation->classes = namesIn(frame.segmentation.classIds, labels);
  observation->descriptorSide = descriptorSide;
  observation->features = frame.features;
  observation->features.semanticDescriptors = nullptr;
  for (const core::Keypoint& keypoint : frame.features.keypoints) {
    observation->states.push_back(stateOf(keypoint, observation->labelBits));
  }
  return observation;
}

core::Frame toFrame(const CObservationSemanticRGBD& observation) {
  core::Frame frame;
  frame.stamp_s = core::fromMrptTime(observation.timestamp);
  frame.camera = observation.camera;
  frame.T_base_cam = core::fromMrpt(observation.cameraPose) * core::T_sensor_cam();
  frame.segmentation = observation.segmentation;
  frame.features = observation.features;
  if (!frame.segmentation.empty()) {
    frame.features.semanticDescriptors =
        std::make_shared<features::SemanticDescriptors>(frame.segmentation.classIds, observation.descriptorSide);
  }
  frame.labelBits = observation.labelBits;
  frame.mayMove = core::dynamicPixels(frame);
  return frame;
}

}  // namespace wardslam::mrpt_plugin

#include "wardslam/mrpt_plugin/scan_annotator.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <utility>

#include "wardslam/core/errors.h"
#include "wardslam/mrpt_plugin/frame_conversion.h"
#include "wardslam/sources/external_images.h"
#include "wardslam/sources/input_damage.h"

namespace wardslam::mrpt_plugin {

ScanAnnotator::ScanAnnotator(const pipeline::SlamOptions& options, std::string sensorLabel)
    : frontEnd_(options), sensorLabel_(std::move(sensorLabel)) {}

CObservationSemanticRGBD::Ptr ScanAnnotator::annotate(const std::shared_ptr<mrpt::obs::CObservation3DRangeScan>& scan) {
  if (!isOurs(*scan)) return nullptr;
  try {
    sources::loadImages(*scan);
    const auto [frame, odometry] = frontEnd_.process(scan);
    core::accumulate(events_, frame.events);
    ++annotated_;
    return toObservation(frame, frontEnd_.labelSpace());
  } catch (const sources::InputDamage& damage) {
    count(damage.event(), damage.what());
  } catch (const core::FrameError& error) {
    count("sources.observation_unusable", error.what());
  }
  return nullptr;
}

bool ScanAnnotator::isOurs(const mrpt::obs::CObservation3DRangeScan& scan) {
  if (!scan.hasIntensityImage || !scan.hasRangeImage) return false;
  if (sensorLabel_.empty()) sensorLabel_ = scan.sensorLabel;
  return scan.sensorLabel == sensorLabel_;
}

void ScanAnnotator::count(const std::string& event, const std::string& trouble) {
  ++events_[event];
  if (firstTrouble_.empty()) firstTrouble_ = trouble;
}

}  // namespace wardslam::mrpt_plugin

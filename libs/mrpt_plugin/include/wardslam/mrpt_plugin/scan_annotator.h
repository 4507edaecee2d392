#pragma once

#include <memory>
#include <string>

#include "wardslam/core/event_counts.h"
#include "wardslam/mrpt_plugin/observation_semantic_rgbd.h"
#include "wardslam/pipeline/front_end.h"

namespace mrpt::obs {
class CObservation3DRangeScan;
}

namespace wardslam::mrpt_plugin {

/// Filters the scans of one RGB-D sensor.
class ScanAnnotator {
 public:
  /// `sensorLabel`: whose scans; empty: of that which the first scan with both images comes from.
  ScanAnnotator(const pipeline::SlamOptions& options, std::string sensorLabel);

  /// Annotates the scan and tells what was found. Null, with the scan as it was: it is of another sensor, has no two
  /// images, or cannot be used, which is counted. Throws core::InputError for what no later scan mends.
  [[nodiscard]] CObservationSemanticRGBD::Ptr annotate(const std::shared_ptr<mrpt::obs::CObservation3DRangeScan>& scan);

  /// After the last scan. Throws core::InputError when no mask belonged to any.
  void requireSoundSetup() { frontEnd_.requireSoundSetup(); }

  [[nodiscard]] std::size_t annotated() const { return annotated_; }
  [[nodiscard]] const std::string& sensorLabel() const { return sensorLabel_; }    ///< Empty until it is known.
  [[nodiscard]] const core::EventCounts& events() const { return events_; }        ///< Trouble, by kind.
  [[nodiscard]] const std::string& firstTrouble() const { return firstTrouble_; }  ///< A sentence part.
  [[nodiscard]] std::string parameters() const { return frontEnd_.filters().parameters(0); }

 private:
  [[nodiscard]] bool isOurs(const mrpt::obs::CObservation3DRangeScan& scan);
  void count(const std::string& event, const std::string& trouble);

  pipeline::FrontEnd frontEnd_;
  std::string sensorLabel_;
  std::size_t annotated_ = 0;
  core::EventCounts events_;
  std::string firstTrouble_;
};

}  // namespace wardslam::mrpt_plugin

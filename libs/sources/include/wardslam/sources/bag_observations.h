#pragma once

#include <filesystem>
#include <memory>

#include "wardslam/sources/observation_source.h"

namespace mrpt::obs {
class CObservation;
}

namespace wardslam::sources {

/// What a recording of ROS (see bags::isBag()) says about an RGB-D camera and its robot, as observations of MRPT in
/// order of their stamps: CObservation3DRangeScan, CObservationOdometry, CObservationIMU. Their labels are the names of
/// topics.
///
/// Stamps are those of the messages' headers. Colour and depth are associated as in a TUM folder, by all stamps at
/// once; the recording is read through once for that when it is opened. Where transforms lead from the colour camera to
/// the robot (base_link) and do not change, they are the scans' sensorPose. Depth that was recorded from another place
/// than colour gets its own calibration and place; whoever builds a frame registers it.
///
/// SourceOptions::note hears which topics were taken and what was assumed.
class BagObservations {
 public:
  /// Throws core::InputError where there are no colour and depth images, or nothing tells their calibration or how they
  /// belong together, and ChoiceNeeded where several topics could be meant.
  BagObservations(const std::filesystem::path& file, const SourceOptions& options);
  ~BagObservations();

  /// Null at the end. A message that cannot be read is left out and counted in damage().
  [[nodiscard]] std::shared_ptr<mrpt::obs::CObservation> next();

  /// Only scans from here on.
  void passOverAllButScans();

  [[nodiscard]] std::size_t scans() const;  ///< Pairs of images, of which some may turn out to be unreadable.
  [[nodiscard]] std::size_t size() const;   ///< The same with all other observations.
  [[nodiscard]] const core::EventCounts& damage() const;
  [[nodiscard]] core::SensorTraits sensorTraits() const;

 private:
  class Reading;

  std::unique_ptr<Reading> reading_;
};

}  // namespace wardslam::sources

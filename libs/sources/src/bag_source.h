#pragma once

#include <filesystem>

#include "wardslam/sources/bag_observations.h"

namespace wardslam::sources {

/// The scans of a recording of ROS: see BagObservations.
class BagSource : public ObservationSource {
 public:
  BagSource(const std::filesystem::path& file, const SourceOptions& options);

  [[nodiscard]] std::shared_ptr<mrpt::obs::CObservation3DRangeScan> next() override;
  [[nodiscard]] std::optional<std::size_t> size() const override { return bag_.scans(); }
  [[nodiscard]] const core::EventCounts& damage() const override { return bag_.damage(); }
  [[nodiscard]] core::SensorTraits sensorTraits() const override { return bag_.sensorTraits(); }

 private:
  BagObservations bag_;
};

}  // namespace wardslam::sources

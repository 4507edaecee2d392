#include "tally.h"

#include <mrpt/obs/CObservationComment.h>

#include "wardslam/sources/rawlog_reader.h"

namespace wardslam::rawlog_cut {

void Tally::add(const std::shared_ptr<mrpt::serialization::CSerializable>& object) {
  ++objects;
  for (const auto& observation : sources::observationsIn(object)) {
    if (!std::dynamic_pointer_cast<mrpt::obs::CObservationComment>(observation))
      ++observations[observation->sensorLabel];
  }
}

bool operator==(const Tally& a, const Tally& b) { return a.objects == b.objects && a.observations == b.observations; }

}  // namespace wardslam::rawlog_cut

#include "bag_source.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

namespace wardslam::sources {

BagSource::BagSource(const std::filesystem::path& file, const SourceOptions& options) : bag_(file, options) {
  bag_.passOverAllButScans();
}

std::shared_ptr<mrpt::obs::CObservation3DRangeScan> BagSource::next() {
  return std::dynamic_pointer_cast<mrpt::obs::CObservation3DRangeScan>(bag_.next());
}

}  // namespace wardslam::sources

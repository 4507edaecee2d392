#include "wardslam/filters/observation_filter.h"

namespace wardslam::filters {

IMPLEMENTS_VIRTUAL_MRPT_OBJECT(ObservationFilter, mrpt::rtti::CObject, wardslam::filters)

}  // namespace wardslam::filters

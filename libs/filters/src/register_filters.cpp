#include "wardslam/filters/register_filters.h"

#include "wardslam/filters/geometric_motion_filter.h"
#include "wardslam/filters/observation_filter.h"
#include "wardslam/filters/semantic_dynamic_filter.h"

namespace wardslam::filters {

void registerAllFilters() {
  mrpt::rtti::registerClass(CLASS_ID(ObservationFilter));
  mrpt::rtti::registerClass(CLASS_ID(SemanticDynamicFilter));
  mrpt::rtti::registerClass(CLASS_ID(GeometricMotionFilter));
}

}  // namespace wardslam::filters

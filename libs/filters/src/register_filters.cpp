#include "wardslam/filters/register_filters.h"

#include "geometric_motion_filter.h"
#include "semantic_dynamic_filter.h"
#include "wardslam/filters/observation_filter.h"

namespace wardslam::filters {

void registerAllFilters() {
  mrpt::rtti::registerClass(CLASS_ID(ObservationFilter));
  mrpt::rtti::registerClass(CLASS_ID(SemanticDynamicFilter));
  mrpt::rtti::registerClass(CLASS_ID(GeometricMotionFilter));
}

}  // namespace wardslam::filters

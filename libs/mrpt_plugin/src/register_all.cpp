#include "wardslam/mrpt_plugin/register_all.h"

#include <mrpt/core/initializer.h>

#include "wardslam/filters/register_filters.h"
#include "wardslam/mrpt_plugin/observation_annotator.h"
#include "wardslam/mrpt_plugin/observation_semantic_rgbd.h"
#include "wardslam/mrpt_plugin/semantic_metric_map.h"

namespace wardslam::mrpt_plugin {

void registerAll() {
  mrpt::rtti::registerClass(CLASS_ID(CObservationSemanticRGBD));
  mrpt::rtti::registerClass(CLASS_ID(ObservationAnnotator));
  mrpt::rtti::registerClass(CLASS_ID(CSemanticMap));
  filters::registerAllFilters();
}

}  // namespace wardslam::mrpt_plugin

MRPT_INITIALIZER(registerWardslam) { wardslam::mrpt_plugin::registerAll(); }

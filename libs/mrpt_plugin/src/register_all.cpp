#include "wardslam/mrpt_plugin/register_all.h"

#include <mrpt/core/initializer.h>

#include "wardslam/filters/register_filters.h"

namespace wardslam::mrpt_plugin {

void registerAll() { filters::registerAllFilters(); }

}  // namespace wardslam::mrpt_plugin

MRPT_INITIALIZER(registerWardslam) { wardslam::mrpt_plugin::registerAll(); }

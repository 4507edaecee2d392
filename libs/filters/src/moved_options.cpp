#include "moved_options.h"

namespace wardslam::filters {

void refuseMovedOptions(const core::ConfigNode& parameters) {
  const core::ConfigNode annotate = parameters.child("annotate");
  if (!annotate.exists()) return;
  annotate.fail("is no parameter of a filter any more: give it once for all of them, at the top of the configuration");
}

}  // namespace wardslam::filters

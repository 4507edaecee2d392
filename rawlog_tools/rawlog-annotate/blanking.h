#pragma once

#include "wardslam/mrpt_plugin/observation_semantic_rgbd.h"

namespace mrpt::obs {
class CObservation3DRangeScan;
}

namespace wardslam::rawlog_annotate {

/// Takes people out of a scan and of what was found in it: their colours, their depth where it is registered to the
/// colour image, and their key points. All of it goes where nobody looked for people. Images that were stored outside
/// are within the scan from then on. Masks stay: they are what is to be told.
void blankPeople(mrpt::obs::CObservation3DRangeScan& scan, mrpt_plugin::CObservationSemanticRGBD& semantic);

}  // namespace wardslam::rawlog_annotate

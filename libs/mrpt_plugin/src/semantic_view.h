#pragma once

#include "wardslam/mrpt_plugin/observation_semantic_rgbd.h"

namespace wardslam::mrpt_plugin {

/// Key points in the colours of their states, names of the things they lie on, and where the camera looks; in the
/// robot's frame.
void addTo(mrpt::opengl::CSetOfObjects& view, const CObservationSemanticRGBD& observation);

}  // namespace wardslam::mrpt_plugin

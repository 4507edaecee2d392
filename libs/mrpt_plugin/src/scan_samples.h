#pragma once

#include <mrpt/obs/CObservation.h>

#include <Eigen/Core>
#include <vector>

#include "wardslam/core/segmentation.h"
#include "wardslam/mrpt_plugin/semantic_map_options.h"

namespace wardslam::mrpt_plugin {

/// A point that an observation measured.
struct ScanSample {
  Eigen::Vector3d p_base_m = Eigen::Vector3d::Zero();  ///< On the robot.
  core::ClassId classId = 0;                           ///< 0 where nobody said.
};

/// CObservation3DRangeScan with both images, and CObservationSemanticRGBD.
[[nodiscard]] bool canBeSampled(const mrpt::obs::CObservation& observation);

/// What does not move, evenly over the image and about SemanticLikelihoodOptions::pixels of it: of a scan pixels with
/// depth, of a CObservationSemanticRGBD key points with depth and the classes they lie on. Nothing of what cannot be
/// used.
[[nodiscard]] std::vector<ScanSample> sampleObservation(const mrpt::obs::CObservation& observation,
                                                        const SemanticLikelihoodOptions& options);

}  // namespace wardslam::mrpt_plugin

#pragma once

#include <memory>

#include "wardslam/core/frame.h"
#include "wardslam/core/label_space.h"
#include "wardslam/mrpt_plugin/observation_semantic_rgbd.h"

namespace wardslam::mrpt_plugin {

/// What is added to the label of a sensor for the observations that go with its scans.
inline constexpr const char* kSemanticSuffix = "_SEM";

/// What the filters made of the frame. Images are shared, not copied. Stamp and label are those of Frame::observation
/// (with kSemanticSuffix); Frame::labelBits tells what is movable.
[[nodiscard]] std::shared_ptr<CObservationSemanticRGBD> toObservation(const core::Frame& frame,
                                                                      const core::LabelSpace& labels,
                                                                      int descriptorSide = 21);

/// The way back: everything but the images, which are those of the scan of the same stamp.
[[nodiscard]] core::Frame toFrame(const CObservationSemanticRGBD& observation);

}  // namespace wardslam::mrpt_plugin

#pragma once

#include "wardslam/core/blob.h"
#include "wardslam/mrpt_plugin/observation_semantic_rgbd.h"

namespace wardslam::mrpt_plugin {

/// Everything of the observation but stamp and label, as a blob (docs/file_formats.md). Throws std::logic_error where
/// its parts contradict each other.
[[nodiscard]] core::Bytes encodeContent(const CObservationSemanticRGBD& observation);

/// Throws core::BlobError where the blob is damaged or its parts contradict each other; `observation` is then left
/// half filled.
void decodeContent(const core::Bytes& blob, CObservationSemanticRGBD& observation);

}  // namespace wardslam::mrpt_plugin

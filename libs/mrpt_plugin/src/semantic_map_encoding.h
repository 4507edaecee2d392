#pragma once

#include "wardslam/core/blob.h"
#include "wardslam/mapping/semantic_map.h"

namespace wardslam::mrpt_plugin {

/// A semantic map as bytes; docs/file_formats.md has the layout. Not compressed, as MRPT's files are.
[[nodiscard]] core::Bytes encode(const mapping::SemanticMap& map);

/// The way back. Throws core::BlobError for what encode() does not write.
[[nodiscard]] mapping::SemanticMap decodeSemanticMap(const core::Bytes& bytes);

}  // namespace wardslam::mrpt_plugin

#pragma once

#include "wardslam/core/blob.h"
#include "wardslam/graph/mapper_state.h"

namespace wardslam::merging {

void put(core::ByteWriter& out, const graph::MapperState& state);

/// Throws core::BlobError.
[[nodiscard]] graph::MapperState getMapperState(core::ByteReader& in);

}  // namespace wardslam::merging

#pragma once

#include <mrpt/serialization/CArchive.h>

#include <string>

#include "wardslam/core/blob.h"

namespace wardslam::mrpt_plugin {

/// u32 size and the bytes.
void writeBytes(mrpt::serialization::CArchive& out, const core::Bytes& bytes);

/// `size` bytes of an object; takes no more memory than there is to read, whatever a damaged size says. Throws
/// core::BlobError where the file ends before.
[[nodiscard]] core::Bytes readBytes(mrpt::serialization::CArchive& in, std::size_t size, std::size_t most);

/// A text as MRPT writes it, of up to so many letters. Throws core::BlobError.
[[nodiscard]] std::string readText(mrpt::serialization::CArchive& in, std::size_t most);

}  // namespace wardslam::mrpt_plugin

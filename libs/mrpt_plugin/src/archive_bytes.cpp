#include "archive_bytes.h"

#include <algorithm>

namespace wardslam::mrpt_plugin {

void writeBytes(mrpt::serialization::CArchive& out, const core::Bytes& bytes) {
  out.WriteAs<std::uint32_t>(bytes.size());
  out.WriteBuffer(bytes.data(), bytes.size());
}

core::Bytes readBytes(mrpt::serialization::CArchive& in, std::size_t size, std::size_t most) {
  constexpr std::size_t kStep = 1U << 20U;
  if (size > most) throw core::BlobError("it should hold " + std::to_string(size) + " bytes");
  core::Bytes bytes;
  while (bytes.size() < size) {
    const std::size_t begin = bytes.size();
    const std::size_t step = std::min(kStep, size - begin);
    bytes.resize(begin + step);
    if (in.ReadBuffer(bytes.data() + begin, step) != step) throw core::BlobError("it ends in the middle");
  }
  return bytes;
}

std::string readText(mrpt::serialization::CArchive& in, std::size_t most) {
  const core::Bytes bytes = readBytes(in, in.ReadAs<std::uint32_t>(), most);
  return {bytes.begin(), bytes.end()};
}

}  // namespace wardslam::mrpt_plugin

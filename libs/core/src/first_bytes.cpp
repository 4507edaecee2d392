#include "wardslam/core/first_bytes.h"

#include <algorithm>
#include <fstream>

namespace wardslam::core {

std::string firstBytes(const std::filesystem::path& file, std::size_t count) {
  std::string head(count, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(head.data(), static_cast<std::streamsize>(count));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  return head;
}

}  // namespace wardslam::core

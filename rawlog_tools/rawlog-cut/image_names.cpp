#include "image_names.h"

namespace wardslam::rawlog_cut {
namespace {

constexpr std::size_t kLength_bytes = 4;

std::size_t lengthAt(const std::uint8_t* bytes) {
  return bytes[0] | std::size_t{bytes[1]} << 8U | std::size_t{bytes[2]} << 16U | std::size_t{bytes[3]} << 24U;
}

}  // namespace

ImageNames::ImageNames(const std::filesystem::path& folder) {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    const std::string name = entry.path().lexically_relative(folder).string();
    files_.insert(name);
    lengths_.insert(name.size());
  }
}

void ImageNames::lookIn(const std::vector<std::uint8_t>& object) {
  for (std::size_t i = 0; i + kLength_bytes < object.size(); ++i) {
    const std::size_t length = lengthAt(&object[i]);
    const std::size_t begin = i + kLength_bytes;
    if (length > object.size() - begin || lengths_.count(length) == 0) continue;
    const std::string name(object.begin() + static_cast<std::ptrdiff_t>(begin),
                           object.begin() + static_cast<std::ptrdiff_t>(begin + length));
    if (files_.count(name) > 0) named_.insert(name);
  }
}

}  // namespace wardslam::rawlog_cut

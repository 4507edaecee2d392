#pragma once

#include "wardslam/bags/bag_reader.h"

namespace wardslam::bags {

/// A ROS 2 bag that is a folder: the files that metadata.yaml lists, one after the other; without metadata.yaml, as
/// when the recorder was killed, all .mcap or .db3 files in the order of their numbers.
class SplitBag : public BagReader {
 public:
  /// Throws core::InputError where a file is missing, packed as a whole, or there is none.
  explicit SplitBag(const std::filesystem::path& folder);

  [[nodiscard]] Bytes read(std::size_t entry) override;

  [[nodiscard]] static bool isOne(const std::filesystem::path& folder);

 private:
  void append(const std::filesystem::path& file);

  std::vector<std::unique_ptr<BagReader>> parts_;
  std::vector<std::size_t> firstEntry_;  ///< Of each part.
};

}  // namespace wardslam::bags

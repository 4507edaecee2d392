#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <unordered_set>
#include <vector>

namespace wardslam::rawlog_cut {

/// Which files of a folder of external images the objects of a rawlog name. Objects are looked at as bytes, in which a
/// name stands behind its length (four bytes, little-endian), so that no class need be known.
class ImageNames {
 public:
  explicit ImageNames(const std::filesystem::path& folder);

  /// Notes the files that this object names.
  void lookIn(const std::vector<std::uint8_t>& object);

  /// Below the folder.
  [[nodiscard]] const std::set<std::string>& named() const { return named_; }

 private:
  std::unordered_set<std::string> files_;
  std::set<std::size_t> lengths_;
  std::set<std::string> named_;
};

}  // namespace wardslam::rawlog_cut

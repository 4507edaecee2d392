#pragma once

#include <filesystem>

namespace wardslam::storage {

/// A copy of a map, beside it under `NAME.grown`, to go on with: the map stays as it is until the copy takes its place.
/// Of a run that is killed the copy stays, a sound map of its own. All members throw core::InputError.
class MapCopy {
 public:
  /// Makes the copy, in place of one that a killed run may have left.
  explicit MapCopy(std::filesystem::path map);

  [[nodiscard]] const std::filesystem::path& path() const { return copy_; }

  // When nobody writes to the copy any more.
  void takePlace() const;  ///< It is the map from now on.
  void remove() const;     ///< Nothing is changed.

 private:
  std::filesystem::path map_;
  std::filesystem::path copy_;
};

}  // namespace wardslam::storage

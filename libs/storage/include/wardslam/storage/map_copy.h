#pragma once

#include <filesystem>
#include <optional>

namespace wardslam::storage {

/// A copy of a map, beside it under `NAME.grown`, to go on with: the map stays as it is until the copy takes its place.
/// Of a run that is killed the copy stays, a sound map of its own; the next run puts it aside. All members throw
/// core::InputError.
class MapCopy {
 public:
  /// Makes the copy. One that a killed run left is called `NAME.grown.old` from then on.
  explicit MapCopy(std::filesystem::path map);

  /// What a killed run left, where it is now.
  [[nodiscard]] const std::optional<std::filesystem::path>& leftBehind() const { return leftBehind_; }

  [[nodiscard]] const std::filesystem::path& path() const { return copy_; }

  // When nobody writes to the copy any more.
  void takePlace() const;  ///< It is the map from now on.
  void remove() const;     ///< Nothing is changed.

 private:
  void putAsideWhatWasLeftBehind();

  std::filesystem::path map_;
  std::filesystem::path copy_;
  std::optional<std::filesystem::path> leftBehind_;
};

}  // namespace wardslam::storage

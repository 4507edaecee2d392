#pragma once

#include <filesystem>
#include <string>

#include "support/temporary_folder.h"

namespace wardslam::test {

/// A TUM sequence of a walk through a textured room: 320x240 pixels, 32 images per second, with groundtruth.txt and
/// masks/ that make the left quarter of every image a person.
class RoomRecording {
 public:
  /// `images` are drawn; the lists name `listed` of them, back and forth over the same images where that is more.
  explicit RoomRecording(int images = 12, int listed = 0, double start_s = 1000.0);

  [[nodiscard]] const std::filesystem::path& path() const { return folder_.path(); }
  [[nodiscard]] std::filesystem::path groundTruth() const { return path() / "groundtruth.txt"; }
  [[nodiscard]] std::filesystem::path masks() const { return path() / "masks"; }
  [[nodiscard]] std::filesystem::path color(int image) const;
  [[nodiscard]] std::filesystem::path depth(int image) const;
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    return folder_.write(name, text);
  }

 private:
  TemporaryFolder folder_;
};

/// Keeps the first `part` (0..1) of a file.
void cutOff(const std::filesystem::path& file, double part);

/// Replaces an image by one of half the size.
void shrinkImage(const std::filesystem::path& file);

}  // namespace wardslam::test

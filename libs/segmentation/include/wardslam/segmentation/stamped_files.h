#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "wardslam/core/stamp_clock.h"

namespace wardslam::segmentation {

/// The files of a folder that are named by the time of an image ("1305031234.293697.png"), in order of time. So they
/// are in milli-, micro- or nanoseconds, with '_' in place of the point, or with the image's own ending (".jpg.png");
/// numbers of images count at `rate_hz`.
class StampedFiles {
 public:
  /// Lists the folder once. `extension`: ".png", in lower case; other files, and names that are not a number, are left
  /// out. Throws core::InputError when the folder cannot be read or nothing is left.
  StampedFiles(const std::filesystem::path& folder, const std::filesystem::path& extension, double rate_hz = 30.0);

  /// The file whose stamp is nearest to `stamp_s`, compared in whole microseconds; empty when none is within
  /// `tolerance_s`.
  [[nodiscard]] std::optional<std::filesystem::path> nearest(double stamp_s, double tolerance_s) const;

  [[nodiscard]] std::size_t size() const { return files_.size(); }
  [[nodiscard]] double firstStamp_s() const;
  [[nodiscard]] double lastStamp_s() const;
  [[nodiscard]] const std::filesystem::path& firstFile() const { return files_.front().path; }
  [[nodiscard]] const std::filesystem::path& file(std::size_t index) const { return files_[index].path; }
  [[nodiscard]] const core::StampClock& clock() const { return clock_; }

 private:
  struct File {
    std::int64_t stamp_us;
    std::filesystem::path path;
  };
  std::vector<File> files_;
  core::StampClock clock_;
};

}  // namespace wardslam::segmentation

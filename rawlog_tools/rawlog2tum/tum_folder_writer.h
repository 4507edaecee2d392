#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "recording/tum_notes.h"
#include "wardslam/core/frame.h"
#include "wardslam/sources/rgbd_camera.h"

namespace wardslam::rawlog2tum {

/// Writes a folder in the layout of the TUM RGB-D benchmark that is complete or absent: it is called "<folder>.partial"
/// until commit(); without, the destructor removes it.
class TumFolderWriter {
 public:
  /// `notes`: names and stamps to write again as they were. Throws core::InputError where the folder holds something
  /// already, or cannot be made.
  TumFolderWriter(std::filesystem::path folder, recording::TumNotes notes);
  ~TumFolderWriter();
  TumFolderWriter(const TumFolderWriter&) = delete;
  TumFolderWriter& operator=(const TumFolderWriter&) = delete;

  /// The frame of a scan. Its depth is written in the units of the first (`rangeUnits_m`), to the digit as in the scan.
  void write(const core::Frame& frame, double rangeUnits_m);
  void commit();

 private:
  [[nodiscard]] recording::TumNotes::Pair namesOf(const core::Frame& frame) const;
  void writeLists() const;

  std::filesystem::path folder_;
  std::filesystem::path partial_;
  recording::TumNotes notes_;
  std::map<std::int64_t, std::size_t> noteAt_;  ///< By stamp in MRPT's ticks.
  std::vector<recording::TumNotes::Pair> written_;
  std::optional<sources::RgbdCamera> camera_;
};

}  // namespace wardslam::rawlog2tum

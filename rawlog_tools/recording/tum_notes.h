#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace wardslam::recording {

class RawlogWriter;

/// What a TUM folder says and a CObservation3DRangeScan has no place for. It travels in a rawlog as texts
/// (mrpt::obs::CObservationComment) ahead of the scans, headed "# TUM groundtruth.txt" and so on, which all programs of
/// MRPT show or pass over.
struct TumNotes {
  /// As listed, stamps to the letter.
  struct Pair {
    std::string colorStamp;
    std::string colorFile;
    std::string depthStamp;
    std::string depthFile;
  };

  std::vector<Pair> pairs;
  std::map<std::string, std::string> files;  ///< Name to content: groundtruth.txt, accelerometer.txt.
};

/// Throws core::InputError where the lists of the folder are unsound.
[[nodiscard]] TumNotes notesOfTumFolder(const std::filesystem::path& folder);

void writeTumNotes(const TumNotes& notes, RawlogWriter& rawlog);

/// Those at the beginning of a rawlog; none where it did not come from a TUM folder.
[[nodiscard]] TumNotes readTumNotes(const std::filesystem::path& rawlog);

}  // namespace wardslam::recording

#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace wardslam::sources {

/// One line of rgb.txt or depth.txt: "<stamp> <file>".
struct ImageEntry {
  double stamp_s = 0.0;
  std::filesystem::path file;  ///< As listed: relative to the folder of the list.
  std::string stampText;       ///< As listed, where lists count seconds; else in seconds.
};

/// A colour image, the depth image that belongs to it, and the line that says so.
struct ImagePair {
  ImageEntry color;
  ImageEntry depth;
  std::filesystem::path list;  ///< The file that lists the colour image …
  int line = 0;                ///< … and where in it, from 1; 0: no list, the files themselves.
};

/// How the lists of a folder are to be taken.
struct ListReading {
  double rate_hz = 30.0;  ///< For lists that number the images instead of telling the time.
  std::function<void(const std::string&)> note = [](const std::string&) {};  ///< Hears what had to be assumed.
};

/// Throws core::InputError where a folder has neither lists of images nor folders of them, as the TUM benchmark has.
void requireImages(const std::filesystem::path& folder);

/// The image pairs of a folder in the layout of the TUM benchmark, in order of the colour stamps: those of
/// associations.txt (or associate.txt, …; "<stamp> <file> <stamp> <file>", colour or depth first) where it exists, else
/// rgb.txt and depth.txt (or color.txt, aligned_depth.txt, …) associated by time, else the files of rgb/ and depth/
/// themselves where they are named by stamp. What docs/inputs.md lists is told to `reading.note`. Throws
/// core::InputError naming file and line where a list is missing, empty or malformed.
[[nodiscard]] std::vector<ImagePair> listImagePairs(const std::filesystem::path& folder,
                                                    const ListReading& reading = {});

}  // namespace wardslam::sources

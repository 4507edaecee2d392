#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace wardslam::sources {

/// One line of rgb.txt or depth.txt: "<stamp> <file>".
struct ImageEntry {
  double stamp_s = 0.0;
  std::filesystem::path file;  ///< As listed: relative to the folder of the list.
  std::string stampText;       ///< As listed.
};

/// A colour image, the depth image that belongs to it, and the line that says so.
struct ImagePair {
  ImageEntry color;
  ImageEntry depth;
  std::filesystem::path list;  ///< The file that lists the colour image …
  int line = 0;                ///< … and where in it, from 1.
};

/// The image pairs of a TUM folder, in order of the colour stamps: those of associations.txt ("<stamp> <file> <stamp>
/// <file>", colour or depth first) where it exists, else rgb.txt and depth.txt associated by time. Throws
/// core::InputError naming file and line where a list is missing, empty, malformed or not in order of time.
[[nodiscard]] std::vector<ImagePair> listImagePairs(const std::filesystem::path& folder);

}  // namespace wardslam::sources

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "wardslam/sources/tum_lists.h"

namespace wardslam::sources {

/// A line of a list of images: one image (rgb.txt), or two that belong together (associations.txt).
struct ImageListLine {
  std::vector<ImageEntry> entries;  ///< `stamp_s` is not set yet; `stampText` is empty where only files are listed.
  int number = 0;
};

/// The lines of a list with `images` (1 or 2) images on each; never empty. What is no file name is a stamp, before its
/// file or behind it; further numbers (a pose in front) are passed over, and so is a line of headings. Throws
/// core::InputError naming file and line.
[[nodiscard]] std::vector<ImageListLine> readImageList(const std::filesystem::path& list, std::size_t images);

/// Where the file is: as listed, or where the list names another folder or a Windows path, the one of that name in this
/// folder. As listed where there is none.
[[nodiscard]] std::filesystem::path locateListed(const std::filesystem::path& folder, const std::string& listed);

}  // namespace wardslam::sources

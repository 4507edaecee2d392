#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace wardslam::core {

/// A line of a text file, without its end.
struct TextLine {
  int number = 0;  ///< From 1.
  std::string text;
  bool isRemark = false;  ///< Begins with '#'.
};

/// The lines of a list that hold anything. A byte order mark and the ends of lines of other systems are taken off.
/// Throws InputError where the file cannot be opened or is UTF-16 (which is named, with what turns it into UTF-8).
[[nodiscard]] std::vector<TextLine> readTextLines(const std::filesystem::path& file);

/// What stands between blanks, tabs, commas and semicolons; of what is in double quotes, all that is in them.
[[nodiscard]] std::vector<std::string> wordsIn(std::string_view text);

}  // namespace wardslam::core

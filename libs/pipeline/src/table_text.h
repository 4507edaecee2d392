#pragma once

#include <charconv>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "wardslam/core/errors.h"
#include "wardslam/core/text_lines.h"

namespace wardslam::pipeline {

template <class Number>
[[nodiscard]] bool readWord(const std::string& word, Number& number) {
  const char* end = word.data() + word.size();
  const auto result = std::from_chars(word.data(), end, number);
  return result.ec == std::errc() && result.ptr == end;
}

/// The rows of a file with these headings, in the order it has; `rowOf` makes one of a line, or none where it is none.
/// A last line that is cut off, as of a run that was killed, is left out. Throws core::InputError naming file and line.
template <class RowOf>
[[nodiscard]] auto readTable(const std::filesystem::path& file, const char* headings, const RowOf& rowOf) {
  const auto lines = core::readTextLines(file);
  std::vector<typename decltype(rowOf(std::string()))::value_type> rows;
  for (const auto& line : lines) {
    if (&line == &lines.front() && line.text == headings) continue;
    if (const auto row = rowOf(line.text)) {
      rows.push_back(*row);
    } else if (&line != &lines.back()) {
      throw core::InputError(file.string() + ":" + std::to_string(line.number) + ": is no line of " + headings +
                             "; the file was not written by this program, or has been changed");
    }
  }
  return rows;
}

}  // namespace wardslam::pipeline

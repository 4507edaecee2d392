#include "image_list_file.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <regex>

#include "wardslam/core/errors.h"
#include "wardslam/core/stamp_clock.h"
#include "wardslam/core/text_lines.h"

namespace wardslam::sources {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

bool isNumber(const std::string& word) { return core::StampClock().seconds(word).has_value(); }

/// Stamps with a decimal comma get a point, in lines that blanks part: there a comma between digits parts nothing.
std::string withDecimalPoints(std::string text) {
  static const std::regex kDecimalComma(R"((^|\s)(\d+),(\d+)(?=\s|$))");
  if (text.find_first_of(" \t") == std::string::npos || text.find(',') == std::string::npos) return text;
  return std::regex_replace(text, kDecimalComma, "$1$2.$3");
}

/// Without the plus signs that some programs put before numbers or between the two images.
Words wordsOf(const std::string& text) {
  Words words = core::wordsIn(withDecimalPoints(text));
  for (std::string& word : words) {
    if (word.size() > 1 && word.front() == '+' && isNumber(word.substr(1))) word.erase(0, 1);
  }
  words.erase(std::remove(words.begin(), words.end(), "+"), words.end());
  return words;
}

bool isHeading(const Words& words) {
  return std::all_of(words.begin(), words.end(), [](const std::string& word) {
    return word.find('/') == std::string::npos && word.find('.') == std::string::npos &&
           std::none_of(word.begin(), word.end(), [](unsigned char letter) { return std::isdigit(letter) != 0; });
  });
}

/// As in the benchmark's own lists: a stamp, then its file.
ImageListLine inOrder(const Words& words) {
  ImageListLine line;
  for (std::size_t i = 0; i + 1 < words.size(); i += 2) line.entries.push_back({0.0, words[i + 1], words[i]});
  return line;
}

/// The files among the words, each with the number before it, or behind it where lines begin with a file.
ImageListLine byFiles(const Words& words) {
  const bool isStampBehind = !words.empty() && !isNumber(words.front());
  ImageListLine line;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (isNumber(words[i])) continue;
    const std::size_t stamp = isStampBehind ? i + 1 : i - 1;
    const bool hasStamp = stamp < words.size() && isNumber(words[stamp]);
    line.entries.push_back({0.0, words[i], hasStamp ? words[stamp] : ""});
  }
  return line;
}

[[noreturn]] void failMalformed(const fs::path& list, int number, std::size_t images, std::size_t words) {
  throw core::InputError(list.string() + ":" + std::to_string(number) + ": expected " +
                         (images == 1 ? "'<stamp> <file>'" : "'<stamp> <file> <stamp> <file>'") + ", found " +
                         std::to_string(words) + " words; correct or remove the line");
}

ImageListLine parse(const core::TextLine& text, std::size_t images, const fs::path& list) {
  const Words words = wordsOf(text.text);
  const bool isCanonical = words.size() == 2 * images && !isNumber(words[1]) &&
                           (images == 1 ? isNumber(words[0]) || words[0].find('/') == std::string::npos
                                        : isNumber(words[0]) || isNumber(words[2]));
  ImageListLine line = isCanonical && !isNumber(words.back()) ? inOrder(words) : byFiles(words);
  if (line.entries.size() != images) failMalformed(list, text.number, images, words.size());
  line.number = text.number;
  return line;
}

}  // namespace

std::vector<ImageListLine> readImageList(const fs::path& list, std::size_t images) {
  std::vector<ImageListLine> lines;
  bool isFirst = true;
  for (const core::TextLine& text : core::readTextLines(list)) {
    if (text.isRemark) continue;
    const bool isHeadingLine = isFirst && isHeading(wordsOf(text.text));
    isFirst = false;
    if (!isHeadingLine) lines.push_back(parse(text, images, list));
  }
  if (lines.empty()) throw core::InputError(list.string() + ": lists no image; fetch the sequence again");
  return lines;
}

fs::path locateListed(const fs::path& folder, const std::string& listed) {
  if (fs::exists(folder / listed)) return listed;
  std::string slashed = listed;
  std::replace(slashed.begin(), slashed.end(), '\\', '/');
  const fs::path path(slashed);
  if (fs::exists(folder / path)) return path;
  const fs::path inFolder = path.parent_path().filename() / path.filename();
  return fs::exists(folder / inFolder) ? inFolder : path;
}

}  // namespace wardslam::sources

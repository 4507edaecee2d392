#include "wardslam/core/text_lines.h"

#include <fstream>
#include <iterator>

#include "wardslam/core/errors.h"

namespace wardslam::core {
namespace {

constexpr std::string_view kBlanks = " \t\r";
constexpr std::string_view kSeparators = " \t\r,;";
constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";

bool isUtf16(std::string_view bytes) {
  const std::string_view begin = bytes.substr(0, 2);
  return begin == "\xFF\xFE" || begin == "\xFE\xFF" || bytes.substr(0, 64).find('\0') != std::string_view::npos;
}

std::string readBytes(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) {
    throw InputError(file.string() + ": cannot be opened; is it there and a text file?");
  }
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

std::vector<TextLine> readTextLines(const std::filesystem::path& file) {
  const std::string bytes = readBytes(file);
  if (isUtf16(bytes)) {
    throw InputError(file.string() +
                     ": is no text of one byte a letter but UTF-16, or not text at all; turn it into "
                     "UTF-8: iconv -f UTF-16 -t UTF-8 " +
                     file.filename().string());
  }
  std::string_view rest = bytes;
  if (rest.substr(0, kUtf8Mark.size()) == kUtf8Mark) rest.remove_prefix(kUtf8Mark.size());
  std::vector<TextLine> lines;
  for (int number = 1; !rest.empty(); ++number) {
    const std::size_t end = rest.find('\n');
    std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    const std::size_t first = line.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) continue;
    line = line.substr(first, line.find_last_not_of(kBlanks) - first + 1);
    lines.push_back({number, std::string(line), line.front() == '#'});
  }
  return lines;
}

std::vector<std::string> wordsIn(std::string_view text) {
  std::vector<std::string> words;
  while (true) {
    const std::size_t first = text.find_first_not_of(kSeparators);
    if (first == std::string_view::npos) return words;
    text.remove_prefix(first);
    const bool isQuoted = text.front() == '"' && text.find('"', 1) != std::string_view::npos;
    if (isQuoted) text.remove_prefix(1);
    const std::size_t end = isQuoted ? text.find('"') : text.find_first_of(kSeparators);
    words.emplace_back(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + (isQuoted ? 1 : 0));
  }
}

}  // namespace wardslam::core

#include "wardslam/sources/tum_lists.h"

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>

#include "image_file.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/stamp_association.h"

namespace wardslam::sources {
namespace {

namespace fs = std::filesystem;

struct ListLine {
  std::vector<ImageEntry> entries;
  int number = 0;
};

std::string at(const fs::path& list, int line) { return list.string() + ":" + std::to_string(line) + ": "; }

double parseStamp(const std::string& word, const std::string& where) {
  std::size_t used = 0;
  double stamp_s = std::numeric_limits<double>::quiet_NaN();
  try {
    stamp_s = std::stod(word, &used);
  } catch (const std::logic_error&) {
    used = 0;
  }
  if (used != word.size() || !std::isfinite(stamp_s) || stamp_s < 0.0) {
    throw core::InputError(where + "'" + word + "' is not a time stamp in seconds");
  }
  return stamp_s;
}

ListLine parseLine(const std::string& text, int number, std::size_t images, const std::string& where) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  if (words.size() != 2 * images) {
    throw core::InputError(where + "expected " +
                           (images == 1 ? "'<stamp> <file>'" : "'<stamp> <file> <stamp> <file>'") + ", found " +
                           std::to_string(words.size()) + " words; correct or remove the line");
  }
  ListLine line;
  line.number = number;
  for (std::size_t i = 0; i < images; ++i) {
    line.entries.push_back({parseStamp(words[2 * i], where), words[2 * i + 1], words[2 * i]});
  }
  return line;
}

/// The lines of a list with `images` images on each; never empty.
std::vector<ListLine> readList(const fs::path& list, std::size_t images) {
  std::ifstream in(list);
  if (!in) throw core::InputError(list.string() + ": cannot be opened; is this the folder of a TUM sequence?");
  std::vector<ListLine> lines;
  int number = 0;
  for (std::string text; std::getline(in, text);) {
    ++number;
    const std::size_t start = text.find_first_not_of(" \t\r");
    if (start == std::string::npos || text[start] == '#') continue;
    lines.push_back(parseLine(text, number, images, at(list, number)));
  }
  if (lines.empty()) throw core::InputError(list.string() + ": lists no image; fetch the sequence again");
  return lines;
}

void requireIncreasing(const std::vector<ListLine>& lines, std::size_t image, const fs::path& list) {
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (lines[i].entries[image].stamp_s > lines[i - 1].entries[image].stamp_s) continue;
    throw core::InputError(at(list, lines[i].number) +
                           "the time stamp is not later than the one before; sort the list and remove doubles");
  }
}

/// Some published association files name the depth image first.
bool namesDepthFirst(const ListLine& line, const fs::path& folder) {
  const auto looksLikeDepth = [&](const ImageEntry& entry) {
    return isSixteenBitPng(folder / entry.file) || entry.file.parent_path().filename() == "depth";
  };
  return looksLikeDepth(line.entries[0]) && !looksLikeDepth(line.entries[1]);
}

std::vector<ImagePair> pairsFromAssociations(const fs::path& folder, const fs::path& list) {
  const auto lines = readList(list, 2);
  const std::size_t color = namesDepthFirst(lines.front(), folder) ? 1 : 0;
  requireIncreasing(lines, color, list);
  std::vector<ImagePair> pairs;
  pairs.reserve(lines.size());
  for (const ListLine& line : lines) pairs.push_back({line.entries[color], line.entries[1 - color], list, line.number});
  return pairs;
}

std::vector<double> stampsOf(const std::vector<ListLine>& lines) {
  std::vector<double> stamps_s;
  stamps_s.reserve(lines.size());
  for (const ListLine& line : lines) stamps_s.push_back(line.entries[0].stamp_s);
  return stamps_s;
}

std::vector<ImagePair> pairsFromStamps(const std::vector<ListLine>& color, const fs::path& folder) {
  const fs::path depthList = folder / "depth.txt";
  const auto depth = readList(depthList, 1);
  requireIncreasing(depth, 0, depthList);
  std::vector<ImagePair> pairs;
  for (const auto& [i, j] : core::associateByStamp(stampsOf(color), stampsOf(depth))) {
    pairs.push_back({color[i].entries[0], depth[j].entries[0], folder / "rgb.txt", color[i].number});
  }
  if (pairs.empty()) {
    throw core::InputError(folder.string() + ": no image of rgb.txt is within 0.02 s of one of depth.txt; " +
                           "the two lists must use the same clock");
  }
  return pairs;
}

}  // namespace

std::vector<ImagePair> listImagePairs(const fs::path& folder) {
  const fs::path associations = folder / "associations.txt";
  const fs::path colorList = folder / "rgb.txt";
  const bool isAssociated = fs::exists(associations);
  std::vector<ListLine> color;
  if (!isAssociated || fs::exists(colorList)) {  // a list that is there must be sound even where it is not needed
    color = readList(colorList, 1);
    requireIncreasing(color, 0, colorList);
  }
  return isAssociated ? pairsFromAssociations(folder, associations) : pairsFromStamps(color, folder);
}

}  // namespace wardslam::sources

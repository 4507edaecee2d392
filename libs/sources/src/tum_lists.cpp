#include "wardslam/sources/tum_lists.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <optional>
#include <string>

#include "image_file.h"
#include "image_list_file.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/stamp_association.h"
#include "wardslam/core/stamp_clock.h"

namespace wardslam::sources {
namespace {

namespace fs = std::filesystem;
using Lines = std::vector<ImageListLine>;
using Names = std::vector<const char*>;

const Names kAssociationLists = {"associations.txt", "associate.txt", "associated.txt",
                                 "association.txt",  "assoc.txt",     "rgbd_assoc.txt"};
const Names kColorLists = {"rgb.txt", "color.txt", "colour.txt"};
const Names kDepthLists = {"depth.txt", "aligned_depth.txt", "depth_aligned.txt"};
const Names kColorFolders = {"rgb", "color", "colour"};
const Names kDepthFolders = {"depth", "aligned_depth", "depth_aligned"};

std::optional<fs::path> firstThere(const fs::path& folder, const Names& names) {
  for (const char* name : names) {
    if (fs::exists(folder / name)) return folder / name;
  }
  return std::nullopt;
}

std::string at(const fs::path& list, int line) {
  return list.string() + (line > 0 ? ":" + std::to_string(line) : "") + ": ";
}

std::string inSeconds(double stamp_s) {
  char text[64];
  std::snprintf(text, sizeof text, "%.9f", stamp_s);
  return text;
}

core::StampClock clockOf(const Lines& lines, std::size_t image, const fs::path& list, double rate_hz) {
  std::vector<std::string_view> stamps;
  for (const ImageListLine& line : lines) stamps.push_back(line.entries[image].stampText);
  const auto unit = core::recogniseStampUnit(stamps);
  if (unit) return core::StampClock(*unit, rate_hz);
  throw core::InputError(at(list, lines.front().number) + "stamps such as '" + lines.front().entries[image].stampText +
                         "' may count milliseconds as well as images; write the list in seconds, such as 12.345");
}

/// Gives every image its time; the clock that was read.
core::StampClock setStamps(Lines& lines, std::size_t image, const fs::path& list, double rate_hz) {
  const core::StampClock clock = clockOf(lines, image, list, rate_hz);
  for (ImageListLine& line : lines) {
    ImageEntry& entry = line.entries[image];
    const auto stamp_s = clock.seconds(entry.stampText);
    if (!stamp_s || *stamp_s < 0.0) {
      throw core::InputError(at(list, line.number) + "'" + entry.stampText + "' is not a time stamp in seconds");
    }
    entry.stamp_s = *stamp_s;
    if (!clock.isSeconds()) entry.stampText = inSeconds(*stamp_s);
  }
  return clock;
}

/// Tells of the clock of a list unless that of the other images, `told`, is the same.
void tellOfClock(const core::StampClock& clock, const fs::path& list, const ListReading& reading, std::string& told) {
  const std::string sentence = clock.isSeconds() ? "" : clock.sentencePart();
  if (!sentence.empty() && sentence != told) reading.note(list.string() + ": " + sentence);
  told = sentence;
}

/// In order of time, each stamp once.
void putInOrder(Lines& lines, std::size_t image, const fs::path& list, const ListReading& reading) {
  const auto earlier = [&](const ImageListLine& a, const ImageListLine& b) {
    return a.entries[image].stamp_s < b.entries[image].stamp_s;
  };
  if (!std::is_sorted(lines.begin(), lines.end(), earlier)) {
    std::stable_sort(lines.begin(), lines.end(), earlier);
    reading.note(list.string() + ": is not in order of time; it is taken in that order");
  }
  const auto sameTime = [&](const ImageListLine& a, const ImageListLine& b) { return !earlier(a, b); };
  const auto doubles = std::unique(lines.begin(), lines.end(), sameTime);
  const auto count = lines.end() - doubles;
  lines.erase(doubles, lines.end());
  if (count > 0) {
    reading.note(list.string() + ": lists " + std::to_string(count) +
                 " images with the stamp of one before; the first of each stamp is taken");
  }
}

void locate(Lines& lines, const fs::path& folder) {
  for (ImageListLine& line : lines) {
    for (ImageEntry& entry : line.entries) entry.file = locateListed(folder, entry.file.string());
  }
}

/// A list of single images, ready to be associated.
Lines readTimedList(const fs::path& list, const ListReading& reading, std::string& toldOfClock) {
  Lines lines = readImageList(list, 1);
  for (ImageListLine& line : lines) {
    ImageEntry& entry = line.entries[0];
    if (entry.stampText.empty()) entry.stampText = fs::path(entry.file).stem().string();  // a list of names alone
  }
  locate(lines, list.parent_path());
  tellOfClock(setStamps(lines, 0, list, reading.rate_hz), list, reading, toldOfClock);
  putInOrder(lines, 0, list, reading);
  return lines;
}

/// Some published association files name the depth image first.
bool namesDepthFirst(const ImageListLine& line, const fs::path& folder) {
  const auto looksLikeDepth = [&](const ImageEntry& entry) {
    return isSixteenBitPng(folder / entry.file) ||
           entry.file.parent_path().filename().string().find("depth") != std::string::npos;
  };
  return looksLikeDepth(line.entries[0]) && !looksLikeDepth(line.entries[1]);
}

/// For lines of two files alone: the stamps that the lists of single images give, or the names of the files.
void findStamps(Lines& lines, const fs::path& folder) {
  std::map<fs::path, std::string> known;
  for (const Names& names : {kColorLists, kDepthLists}) {
    const auto list = firstThere(folder, names);
    if (!list) continue;
    for (const ImageListLine& line : readImageList(*list, 1)) {
      known[locateListed(folder, line.entries[0].file.string())] = line.entries[0].stampText;
    }
  }
  for (ImageListLine& line : lines) {
    for (ImageEntry& entry : line.entries) {
      if (!entry.stampText.empty()) continue;
      const auto listed = known.find(entry.file);
      entry.stampText = listed != known.end() ? listed->second : entry.file.stem().string();
    }
  }
}

std::vector<ImagePair> pairsFromAssociations(const fs::path& folder, const fs::path& list, const ListReading& reading) {
  Lines lines = readImageList(list, 2);
  locate(lines, folder);
  findStamps(lines, folder);
  const std::size_t color = namesDepthFirst(lines.front(), folder) ? 1 : 0;
  std::string told;
  for (const std::size_t image : {color, 1 - color}) {
    tellOfClock(setStamps(lines, image, list, reading.rate_hz), list, reading, told);
  }
  putInOrder(lines, color, list, reading);
  std::vector<ImagePair> pairs;
  pairs.reserve(lines.size());
  for (const auto& line : lines) pairs.push_back({line.entries[color], line.entries[1 - color], list, line.number});
  return pairs;
}

std::vector<double> stampsOf(const Lines& lines) {
  std::vector<double> stamps_s;
  stamps_s.reserve(lines.size());
  for (const ImageListLine& line : lines) stamps_s.push_back(line.entries[0].stamp_s);
  return stamps_s;
}

std::vector<ImagePair> associate(const Lines& color, const fs::path& colorList, const Lines& depth,
                                 const fs::path& depthList) {
  std::vector<ImagePair> pairs;
  for (const auto& [i, j] : core::associateByStamp(stampsOf(color), stampsOf(depth))) {
    pairs.push_back({color[i].entries[0], depth[j].entries[0], colorList, color[i].number});
  }
  if (pairs.empty()) {
    throw core::InputError(colorList.parent_path().string() + ": no image of " + colorList.filename().string() +
                           " is within 0.02 s of one of " + depthList.filename().string() +
                           "; the two lists must use the same clock");
  }
  return pairs;
}

/// The images of a folder, which are named by their stamps.
Lines listFolder(const fs::path& images) {
  Lines lines;
  for (const auto& entry : fs::directory_iterator(images)) {
    const fs::path name = entry.path().filename();
    if (!core::StampClock().seconds(name.stem().string())) continue;
    lines.push_back({{{0.0, images.filename() / name, name.stem().string()}}, 0});
  }
  if (lines.empty()) {
    throw core::InputError(images.string() + ": there is no list of its images beside it, and none is named by its " +
                           "time; write rgb.txt and depth.txt, lines of '<stamp> <file>'");
  }
  const auto number = [](const ImageListLine& line) { return *core::StampClock().seconds(line.entries[0].stampText); };
  std::sort(lines.begin(), lines.end(),
            [&](const ImageListLine& a, const ImageListLine& b) { return number(a) < number(b); });
  return lines;
}

std::vector<ImagePair> pairsFromFolders(const fs::path& colorFolder, const fs::path& depthFolder,
                                        const ListReading& reading) {
  Lines color = listFolder(colorFolder);
  Lines depth = listFolder(depthFolder);
  const core::StampClock clock = setStamps(color, 0, colorFolder, reading.rate_hz);
  setStamps(depth, 0, depthFolder, reading.rate_hz);
  reading.note(colorFolder.parent_path().string() +
               ": has no list of its images; the names of the files are taken for "
               "their stamps" +
               (clock.isSeconds() ? "" : ", which " + clock.sentencePart()));
  return associate(color, colorFolder, depth, depthFolder);
}

}  // namespace

void requireImages(const fs::path& folder) {
  if (firstThere(folder, kAssociationLists) || firstThere(folder, kColorLists) || firstThere(folder, kDepthLists))
    return;
  if (firstThere(folder, kColorFolders) && firstThere(folder, kDepthFolders)) return;
  throw core::InputError(
      folder.string() + ": there are neither lists of images (rgb.txt and depth.txt, or " +
      "associations.txt) nor folders of them (rgb and depth); is this the folder of a TUM sequence?");
}

std::vector<ImagePair> listImagePairs(const fs::path& folder, const ListReading& reading) {
  const auto associations = firstThere(folder, kAssociationLists);
  const auto colorList = firstThere(folder, kColorLists);
  const auto depthList = firstThere(folder, kDepthLists);
  if (associations) {
    if (colorList)
      static_cast<void>(
          readImageList(*colorList, 1));  // a list that is there must be sound even where it is not needed
    return pairsFromAssociations(folder, *associations, reading);
  }
  const auto colorFolder = firstThere(folder, kColorFolders);
  const auto depthFolder = firstThere(folder, kDepthFolders);
  if (!colorList && !depthList && colorFolder && depthFolder) {
    return pairsFromFolders(*colorFolder, *depthFolder, reading);
  }
  const fs::path colors = colorList.value_or(folder / kColorLists.front());
  const fs::path depths = depthList.value_or(folder / kDepthLists.front());
  std::string toldOfClock;
  const Lines color = readTimedList(colors, reading, toldOfClock);
  return associate(color, colors, readTimedList(depths, reading, toldOfClock), depths);
}

}  // namespace wardslam::sources

#include "recording/tum_notes.h"

#include <mrpt/obs/CObservationComment.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

#include "recording/rawlog_writer.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/core/text_lines.h"
#include "wardslam/sources/input_damage.h"
#include "wardslam/sources/rawlog_reader.h"
#include "wardslam/sources/tum_lists.h"

namespace wardslam::recording {
namespace {

namespace fs = std::filesystem;
using mrpt::obs::CObservationComment;

constexpr const char* kHeading = "# TUM ";  // MRPT does not store the label of a comment
constexpr const char* kAssociations = "associations.txt";
constexpr const char* kKeptFiles[] = {"groundtruth.txt", "accelerometer.txt"};

std::string wholeText(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Names may hold blanks.
std::string quoted(const std::string& file) {
  return file.find_first_of(" ,;") == std::string::npos ? file : "\"" + file + "\"";
}

std::string textOf(const std::vector<TumNotes::Pair>& pairs) {
  std::ostringstream text;
  for (const auto& [colorStamp, colorFile, depthStamp, depthFile] : pairs) {
    text << colorStamp << " " << quoted(colorFile) << " " << depthStamp << " " << quoted(depthFile) << "\n";
  }
  return text.str();
}

std::vector<TumNotes::Pair> pairsOf(const std::string& text) {
  constexpr std::size_t kWords = 4;
  std::istringstream in(text);
  std::vector<TumNotes::Pair> pairs;
  for (std::string line; std::getline(in, line);) {
    const auto words = core::wordsIn(line);
    if (words.size() == kWords) pairs.push_back({words[0], words[1], words[2], words[3]});
  }
  return pairs;
}

void writeNote(const std::string& name, const std::string& text, double stamp_s, RawlogWriter& rawlog) {
  CObservationComment comment;
  comment.timestamp = core::toMrptTime(stamp_s);
  comment.text = kHeading + name + "\n" + text;
  rawlog.write(comment);
}

/// The name in the first line, and what follows it; no name where it is none of our notes.
std::pair<std::string, std::string> readNote(const std::string& text) {
  const std::string heading = kHeading;
  const std::size_t end = text.find('\n');
  if (text.compare(0, heading.size(), heading) != 0 || end == std::string::npos) return {};
  return {text.substr(heading.size(), end - heading.size()), text.substr(end + 1)};
}

}  // namespace

TumNotes notesOfTumFolder(const fs::path& folder) {
  TumNotes notes;
  for (const sources::ImagePair& pair : sources::listImagePairs(folder)) {
    notes.pairs.push_back(
        {pair.color.stampText, pair.color.file.string(), pair.depth.stampText, pair.depth.file.string()});
  }
  for (const char* name : kKeptFiles) {
    if (fs::is_regular_file(folder / name)) notes.files.emplace(name, wholeText(folder / name));
  }
  return notes;
}

void writeTumNotes(const TumNotes& notes, RawlogWriter& rawlog) {
  if (notes.pairs.empty()) return;
  const double stamp_s =
      std::stod(notes.pairs.front().colorStamp);  // tools that cut by time keep them with the first scan
  writeNote(kAssociations, textOf(notes.pairs), stamp_s, rawlog);
  for (const auto& [name, text] : notes.files) writeNote(name, text, stamp_s, rawlog);
}

TumNotes readTumNotes(const fs::path& rawlog) {
  TumNotes notes;
  sources::RawlogReader reader(rawlog);
  try {
    while (const auto comment = std::dynamic_pointer_cast<CObservationComment>(reader.read())) {
      const auto [name, text] = readNote(comment->text);
      if (name == kAssociations) notes.pairs = pairsOf(text);
      const bool isKept = std::find(std::begin(kKeptFiles), std::end(kKeptFiles), name) != std::end(kKeptFiles);
      if (isKept) notes.files[name] = text;
    }
  } catch (const sources::InputDamage&) {
    return notes;  // whoever reads the scans meets it, too, and tells of it
  }
  return notes;
}

}  // namespace wardslam::recording

#include "wardslam/core/label_space.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <map>
#include <sstream>

#include "wardslam/core/errors.h"

namespace wardslam::core {
namespace {

constexpr std::array<const char*, 80> kCocoNames = {
    "person",         "bicycle",    "car",           "motorcycle",    "airplane",     "bus",           "train",
    "truck",          "boat",       "traffic light", "fire hydrant",  "stop sign",    "parking meter", "bench",
    "bird",           "cat",        "dog",           "horse",         "sheep",        "cow",           "elephant",
    "bear",           "zebra",      "giraffe",       "backpack",      "umbrella",     "handbag",       "tie",
    "suitcase",       "frisbee",    "skis",          "snowboard",     "sports ball",  "kite",          "baseball bat",
    "baseball glove", "skateboard", "surfboard",     "tennis racket", "bottle",       "wine glass",    "cup",
    "fork",           "knife",      "spoon",         "bowl",          "banana",       "apple",         "sandwich",
    "orange",         "broccoli",   "carrot",        "hot dog",       "pizza",        "donut",         "cake",
    "chair",          "couch",      "potted plant",  "bed",           "dining table", "toilet",        "tv",
    "laptop",         "mouse",      "remote",        "keyboard",      "cell phone",   "microwave",     "oven",
    "toaster",        "sink",       "refrigerator",  "book",          "clock",        "vase",          "scissors",
    "teddy bear",     "hair drier", "toothbrush"};

[[noreturn]] void fail(const std::filesystem::path& file, std::size_t line, const std::string& what) {
  throw InputError(file.string() + ":" + std::to_string(line) + ": " + what);
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

}  // namespace

LabelSpace LabelSpace::coco() {
  LabelSpace labels;
  labels.names_[0] = "unclassified";
  std::copy(kCocoNames.begin(), kCocoNames.end(), labels.names_.begin() + 1);
  return labels;
}

LabelSpace LabelSpace::cocoWith(const std::filesystem::path& classesFile) {
  std::ifstream in(classesFile);
  if (!in) throw InputError(classesFile.string() + ": cannot be opened for reading");
  LabelSpace labels = coco();
  std::map<std::string, ClassId> given;
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    const std::string content = trimmed(line);
    if (content.empty() || content.front() == '#') continue;
    std::istringstream fields(content);
    int id = 0;
    const bool isNumber = (fields >> id) && (fields.eof() || std::isspace(fields.peek()) != 0);
    if (!isNumber || id < 1 || id > 255) fail(classesFile, number, "a class id from 1 to 255 is expected first");
    std::string name;
    std::getline(fields, name);
    name = trimmed(name);
    if (name.empty()) fail(classesFile, number, "class " + std::to_string(id) + " has no name");
    const auto [entry, isNew] = given.emplace(name, static_cast<ClassId>(id));
    if (!isNew && entry->second != id) {
      fail(classesFile, number, "'" + name + "' is the name of class " + std::to_string(entry->second) + " already");
    }
    const std::string& before = labels.name(static_cast<ClassId>(id));
    if (before != name && given.count(before) > 0) {
      fail(classesFile, number, "class " + std::to_string(id) + " is named '" + before + "' already");
    }
    labels.rename(static_cast<ClassId>(id), name);
  }
  return labels;
}

void LabelSpace::rename(ClassId id, const std::string& name) {
  if (const auto before = find(name)) names_[*before].clear();
  names_[id] = name;
}

std::optional<ClassId> LabelSpace::find(const std::string& name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (name.empty() || found == names_.end()) return std::nullopt;
  return static_cast<ClassId>(found - names_.begin());
}

}  // namespace wardslam::core

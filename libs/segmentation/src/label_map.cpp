#include "wardslam/segmentation/label_map.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "wardslam/core/data_files.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/nearest_name.h"
#include "wardslam/core/options.h"

namespace wardslam::segmentation {
namespace {

namespace fs = std::filesystem;
using core::ConfigNode;

constexpr int kMaxId = 255;
constexpr int kMaxIndex = 65535;
constexpr int kFirstOwnId = 150;  // behind those of labels/hospital.yaml
constexpr int kMaxNesting = 8;    // of files that extend each other

fs::path locate(const fs::path& file) { return fs::exists(file) ? file : core::findDataFile(file); }

bool isYaml(const fs::path& file) { return file.extension() == ".yaml" || file.extension() == ".yml"; }

std::optional<int> numberIn(const ConfigNode& node, int min, int max) {
  int number = 0;
  if (!node.yaml().IsScalar() || !YAML::convert<int>::decode(node.yaml(), number)) return std::nullopt;
  if (number < min || number > max) {
    node.fail("a number from " + std::to_string(min) + " to " + std::to_string(max) + " is expected here");
  }
  return number;
}

int keyNumber(const ConfigNode& map, const YAML::Node& key, int min, int max) {
  const ConfigNode node(key, map.file(), map.key());
  const auto number = numberIn(node, min, max);
  if (!number) node.fail("a number is expected as key");
  return *number;
}

/// In small letters, words parted by blanks.
std::string plain(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char letter) {
    return letter == '_' || letter == '-' ? ' ' : static_cast<char>(std::tolower(letter));
  });
  return name;
}

std::optional<core::ClassId> findAlike(const core::LabelSpace& labels, const std::string& name) {
  for (int id = 1; id <= kMaxId; ++id) {
    const auto& known = labels.name(static_cast<core::ClassId>(id));
    if (!known.empty() && plain(known) == plain(name)) return static_cast<core::ClassId>(id);
  }
  return std::nullopt;
}

std::vector<std::string> namesOf(const core::LabelSpace& labels) {
  std::vector<std::string> names;
  for (int id = 1; id <= kMaxId; ++id) {
    if (const auto& name = labels.name(static_cast<core::ClassId>(id)); !name.empty()) names.push_back(name);
  }
  return names;
}

}  // namespace

/// Fills a LabelMap from a label file and the files it extends.
class LabelFileReader {
 public:
  static LabelMap read(const fs::path& file, int firstId) {
    LabelMap map = LabelMap::consecutive(core::LabelSpace::coco(), firstId);
    const auto root = ConfigNode::fromFile(file);
    root.requireKeys({"extends", "names", "classes"});
    readNames(map.labels_, root, 0);
    readClasses(map, root.child("classes"));
    return map;
  }

 private:
  /// Beside the file, as configurations are, or among the label files that come with the program.
  static fs::path findBase(const std::string& name, const fs::path& referringFile) {
    if (fs::exists(referringFile.parent_path() / name)) return referringFile.parent_path() / name;
    try {
      return core::findDataFile(fs::path("labels") / name);
    } catch (const core::InputError&) {
      return core::findDataFile(name, referringFile);
    }
  }

  static void readNames(core::LabelSpace& labels, const ConfigNode& root, int depth) {
    if (const auto extends = root.child("extends"); extends.exists()) {
      if (depth == kMaxNesting) extends.fail("label files extend each other in a circle");
      if (!extends.yaml().IsScalar()) extends.fail("the name of a label file is expected here");
      const auto base = findBase(extends.yaml().Scalar(), root.file());
      readNames(labels, ConfigNode::fromFile(base), depth + 1);
    }
    const auto names = root.child("names");
    if (!names.exists()) return;
    if (!names.yaml().IsMap()) names.fail("a mapping (id: name) is expected here");
    std::map<std::string, int> given;
    std::map<int, std::string> taken;
    for (const auto& entry : names.yaml()) {
      const int id = keyNumber(names, entry.first, 1, kMaxId);
      const ConfigNode value(entry.second, names.file(), names.key() + "." + std::to_string(id));
      const std::string name = value.exists() && value.yaml().IsScalar() ? value.yaml().Scalar() : "";
      if (name.empty()) value.fail("a name is expected here");
      if (!taken.emplace(id, name).second) value.fail("this id is named twice");
      const auto [other, isNew] = given.emplace(name, id);
      if (!isNew) value.fail("'" + name + "' is the name of class " + std::to_string(other->second) + " already");
      labels.rename(static_cast<core::ClassId>(id), name);
    }
  }

  static void readClasses(LabelMap& map, const ConfigNode& classes) {
    if (!classes.exists()) return;
    if (!classes.yaml().IsSequence() && !classes.yaml().IsMap()) {
      classes.fail("a list ([person, chair]) or a mapping (index: name) is expected here");
    }
    map.ids_.clear();
    const bool isList = classes.yaml().IsSequence();
    map.extent_ = isList ? LabelMap::Extent::Exactly : LabelMap::Extent::AtLeast;
    isList ? readList(map, classes) : readMapping(map, classes);
  }

  static void readList(LabelMap& map, const ConfigNode& classes) {
    for (std::size_t i = 0; i < classes.yaml().size(); ++i) {
      map.ids_.push_back(idOf(map.labels_, classes.item(i)));
    }
  }

  static void readMapping(LabelMap& map, const ConfigNode& classes) {
    std::map<std::size_t, core::ClassId> given;
    for (const auto& entry : classes.yaml()) {
      const int index = keyNumber(classes, entry.first, 0, kMaxIndex);
      const ConfigNode value(entry.second, classes.file(), classes.key() + "." + std::to_string(index));
      const bool isNew = given.emplace(index, idOf(map.labels_, value)).second;
      if (!isNew) value.fail("this index is given twice");
    }
    for (const auto& [index, id] : given) {
      map.ids_.resize(index + 1, core::ClassId{0});
      map.ids_.back() = id;
    }
  }

  static core::ClassId idOf(const core::LabelSpace& labels, const ConfigNode& value) {
    if (!value.exists()) return 0;
    if (!value.yaml().IsScalar()) value.fail("a name, an id or ~ is expected here");
    if (const auto id = numberIn(value, 0, kMaxId)) return static_cast<core::ClassId>(*id);
    const std::string name = value.yaml().Scalar();
    if (const auto id = labels.find(name)) return *id;
    value.fail("'" + name + "' is not the name of a class; did you mean '" + core::nearestName(name, namesOf(labels)) +
               "'? New names are given an id under 'names'");
  }
};

LabelMap LabelMap::consecutive(core::LabelSpace labels, int firstId) {
  LabelMap map;
  map.labels_ = std::move(labels);
  for (int id = firstId; id <= kMaxId; ++id) map.ids_.push_back(static_cast<core::ClassId>(id));
  return map;
}

LabelMap LabelMap::fromFile(const fs::path& file, int firstId) {
  const fs::path found = locate(file);
  return isYaml(found) ? LabelFileReader::read(found, firstId)
                       : consecutive(core::LabelSpace::cocoWith(found), firstId);
}

LabelMap LabelMap::fromNames(const std::vector<std::string>& names, const std::string& network) {
  static const core::LabelSpace kHospital = fromFile("labels/hospital.yaml").labels();
  LabelMap map;
  map.extent_ = Extent::Exactly;
  int nextOwn = kFirstOwnId;
  for (const std::string& name : names) {
    const auto known = findAlike(kHospital, name);
    if (known && map.labels_.name(*known).empty()) map.labels_.rename(*known, kHospital.name(*known));
    auto id = known ? known : map.labels_.find(name);
    if (!id && !name.empty()) {
      if (nextOwn > kMaxId) {
        throw core::InputError(network + ": names more classes of its own than there are ids (" +
                               std::to_string(kMaxId - kFirstOwnId + 1) +
                               "); say with --classes which of them are wanted");
      }
      id = static_cast<core::ClassId>(nextOwn++);
      map.labels_.rename(*id, name);
    }
    map.ids_.push_back(id.value_or(core::ClassId{0}));
  }
  return map;
}

LabelMap LabelMap::forNetwork(int classes, const fs::path& file, const std::string& network,
                              const std::vector<std::string>& names, Family family) {
  const auto fail = [&](const std::string& what) {
    throw core::InputError(network + ": knows " + std::to_string(classes) + " classes, " + what +
                           " (segmentation.classes)");
  };
  static const std::map<int, const char*> kKnown = {
      {21, "labels/voc21.yaml"}, {90, "labels/coco90.yaml"}, {150, "labels/ade150.yaml"}};
  if (file.empty() && !names.empty()) {
    if (static_cast<int>(names.size()) != classes) {
      fail("but names " + std::to_string(names.size()) + "; name them in a label file: --classes FILE");
    }
    return fromNames(names, network);
  }
  if (file.empty()) {
    if (classes == 80) return consecutive(core::LabelSpace::coco());
    const auto known = kKnown.find(classes);
    if (family == Family::Other && known != kKnown.end()) return fromFile(known->second);
    fail(family == Family::Yolo
             ? "brings no names for them, and they are not COCO's; name them in a label file: --classes FILE"
             : "which are not those of COCO, Pascal VOC or ADE20K; name them in a label file: --classes FILE");
  }
  LabelMap map = fromFile(file);
  const std::size_t listed = map.ids_.size();
  const auto known = static_cast<std::size_t>(classes);
  if (map.extent_ == Extent::Exactly && listed != known) {
    fail("but " + file.string() + " lists " + std::to_string(listed) + "; give the label file of this network");
  }
  if (map.extent_ == Extent::AtLeast && listed > known) {
    fail("but " + file.string() + " gives class " + std::to_string(listed - 1) +
         " a meaning; give the label file of this network");
  }
  return map;
}

cv::Mat LabelMap::apply(const cv::Mat& indices) const {
  cv::Mat ids(indices.size(), CV_8UC1);
  if (indices.depth() == CV_8U) {
    cv::Mat table(1, 256, CV_8UC1);
    for (int i = 0; i < table.cols; ++i) table.at<core::ClassId>(0, i) = classOf(i);
    cv::LUT(indices, table, ids);
    return ids;
  }
  ids.forEach<core::ClassId>([&](core::ClassId& id, const int* position) {
    const float index = indices.at<float>(position[0], position[1]);
    id = index >= 0.0F && index <= static_cast<float>(kMaxIndex) ? classOf(static_cast<int>(std::lround(index))) : 0;
  });
  return ids;
}

}  // namespace wardslam::segmentation

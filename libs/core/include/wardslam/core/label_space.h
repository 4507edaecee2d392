#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include "wardslam/core/segmentation.h"

namespace wardslam::core {

/// The names of the class ids: COCO's 80 classes as 1..80 (P3) and, where a file brings them, hospital things
/// without a COCO class from 100 on.
class LabelSpace {
 public:
  /// 0 "unclassified", 1 "person" … 80 "toothbrush", in the order of the 80-class COCO list.
  [[nodiscard]] static LabelSpace coco();

  /// COCO extended or overruled by a text file of "<id> <name>" lines. Throws InputError with file and line on an id
  /// outside 1..255, a missing name, or an id or a name that the file gives twice with different meanings.
  [[nodiscard]] static LabelSpace cocoWith(const std::filesystem::path& classesFile);

  /// Names an id; another id that had this name is left without one.
  void rename(ClassId id, const std::string& name);

  /// Empty when the id has no name.
  [[nodiscard]] const std::string& name(ClassId id) const { return names_[id]; }
  [[nodiscard]] std::optional<ClassId> find(const std::string& name) const;

 private:
  std::array<std::string, 256> names_;
};

}  // namespace wardslam::core

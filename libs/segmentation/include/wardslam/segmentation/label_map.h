#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "wardslam/core/label_space.h"
#include "wardslam/core/segmentation.h"

namespace wardslam::segmentation {

/// What the class indices of a network mean: the one place where numbers of networks become ids of ours.
///
/// A label file gives the meanings (config/labels/*.yaml):
///
///     extends: hospital.yaml       # optional: takes the names of that file, found beside this one
///     names: {140: drip_bag}       # names for ids that have none yet, or other names
///     classes: [~, person, drip_bag]   # by index: a name, an id, or ~ for what is to stay unclassified;
///                                      # or a mapping {1: person, 2: drip_bag} that leaves the others out
class LabelMap {
 public:
  /// Index i is id i + `firstId`, as far as there are ids.
  [[nodiscard]] static LabelMap consecutive(core::LabelSpace labels, int firstId = 1);

  /// `file`: a label file (.yaml, .yml), or a text file of "<id> <name>" lines. Looked for as given, then among the
  /// installed data. Without `classes`, index i is id i + `firstId`. Throws core::InputError with file, line and key.
  [[nodiscard]] static LabelMap fromFile(const std::filesystem::path& file, int firstId = 1);

  /// Names that a network brings, by index: those of COCO and of labels/hospital.yaml have the ids they have there
  /// (whatever the case, '_' or ' '), others get ids of their own from 150 on. Throws core::InputError, beginning with
  /// the name of the `network`, when there are more than there are ids.
  [[nodiscard]] static LabelMap fromNames(const std::vector<std::string>& names, const std::string& network);

  /// Networks that count their classes alike.
  enum class Family { Yolo, Other };

  /// For a network of so many classes: from `file` where one is given; else from the `names` it brings; else what the
  /// number tells: 80 COCO, and of others than YOLO 21 Pascal VOC, 90 COCO with its gaps, 150 ADE20K. Throws
  /// core::InputError, beginning with the name of the `network`, when it tells nothing or the file does not fit.
  [[nodiscard]] static LabelMap forNetwork(int classes, const std::filesystem::path& file, const std::string& network,
                                           const std::vector<std::string>& names = {}, Family family = Family::Other);

  /// 0 (unclassified) for indices without a meaning, negative ones too.
  [[nodiscard]] core::ClassId classOf(int index) const {
    const auto i = static_cast<std::size_t>(index);  // negative ones become large
    return i < ids_.size() ? ids_[i] : core::ClassId{0};
  }
  /// How many classes there are, where that is told (by a list, or the names that a network brings).
  [[nodiscard]] std::optional<std::size_t> listed() const {
    return extent_ == Extent::Exactly ? std::optional(ids_.size()) : std::nullopt;
  }
  [[nodiscard]] const core::LabelSpace& labels() const { return labels_; }

  /// Class ids in place of indices; same size, CV_8UC1. `indices`: CV_32FC1 (whole numbers) or CV_8UC1.
  [[nodiscard]] cv::Mat apply(const cv::Mat& indices) const;

 private:
  /// How many classes the file says there are: as many as it lists (a list), or more than its highest index (a
  /// mapping).
  enum class Extent { Any, Exactly, AtLeast };
  friend class LabelFileReader;

  core::LabelSpace labels_ = core::LabelSpace::coco();
  std::vector<core::ClassId> ids_;
  Extent extent_ = Extent::Any;
};

}  // namespace wardslam::segmentation

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "wardslam/segmentation/label_map.h"
#include "wardslam/segmentation/segmenter.h"
#include "wardslam/segmentation/stamped_files.h"

namespace wardslam::segmentation {

struct RecordedMasksOptions {
  std::string folder;
  double tolerance_ms = 5.0;
  int min_region_px = 100;
  double rate_hz = 30.0;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit);
};

/// Segmentation that was made before: a folder of class-id PNGs (0 = none; 8-bit, or what readMaskFile() makes 8-bit)
/// named by the stamp of the colour image. Instance ids come from the sibling folder instances/ (8- or 16-bit PNGs of
/// the same names), or else from the regions of equal class; names from the sibling file classes.txt, where there is
/// one, on top of COCO's. A label file may give the grey values other meanings.
///
/// Events: "segmentation.mask_missing" and "segmentation.mask_unreadable" (also: not 8-bit single-channel, other size
/// than the image) with an empty result; "segmentation.instances_unreadable" where regions had to replace instances;
/// "segmentation.class_without_name" where grey values that name no class were taken for 0, with an empty result where
/// the mask holds no others (pictures of two grey levels, say).
class RecordedMasks : public Segmenter {
 public:
  /// So many images from the start without a usable mask, and the folder is taken to belong to another recording.
  static constexpr std::size_t kPatience = 30;

  /// `classesFile`: read in place of the sibling classes.txt when not empty. Throws core::InputError.
  explicit RecordedMasks(const RecordedMasksOptions& options, const std::filesystem::path& classesFile = {});

  [[nodiscard]] Result segment(const SegmenterInput& input) override;
  void finish() override;
  [[nodiscard]] const core::LabelSpace& labelSpace() const override { return labels_.labels(); }

  /// What had to be assumed of the masks, one sentence each.
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

 private:
  [[nodiscard]] cv::Mat readInstanceIds(const std::filesystem::path& maskFile, const cv::Mat& classIds,
                                        core::EventCounts& events) const;
  [[nodiscard]] Result miss(const char* event, const std::string& reason);
  [[nodiscard]] std::string describeNoMatch(double stamp_s) const;

  std::filesystem::path folder_;
  std::filesystem::path instancesFolder_;  ///< Empty: there is none.
  RecordedMasksOptions options_;
  StampedFiles masks_;
  LabelMap labels_;
  std::vector<std::string> notes_;

  bool usedAny_ = false;
  std::size_t missesFromStart_ = 0;
  std::string firstMiss_;
};

template <class Self, class Visitor>
void RecordedMasksOptions::describe(Self& self, Visitor& visit) {
  visit("folder", self.folder,
        "class-id PNGs named by the stamp of the colour image; instances/ and classes.txt beside");
  visit("tolerance", self.tolerance_ms, {0.0, 1000.0}, "ms", "how far the stamps of image and mask may differ");
  visit("rate", self.rate_hz, {0.1, 1000.0}, "Hz",
        "images a second, for masks whose names number the images instead of telling their time");
  visit("min_region", self.min_region_px, {1, 1000000}, "px",
        "without instances/: smallest region of one class that counts as an instance");
}

}  // namespace wardslam::segmentation

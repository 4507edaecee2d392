#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "wardslam/segmentation/label_map.h"
#include "wardslam/segmentation/network.h"
#include "wardslam/segmentation/segmenter.h"
#include "wardslam/segmentation/yolo_decoder.h"

namespace wardslam::segmentation {

struct YoloOptions {
  std::string model;
  YoloDecoderOptions decoder;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit);
};

/// A YOLO-seg network (layout of YOLOv5-seg or YOLOv8-seg, or end to end; ONNX, input of fixed size). What its classes
/// are it says itself as a rule: the file's metadata has their names.
///
/// Event "segmentation.network_failed": the network could not be run on this image; the result is empty.
class YoloSegmenter : public Segmenter {
 public:
  /// Loads the network and runs it once. `classesFile`: label file; may be empty where the number of classes says
  /// enough (see LabelMap::forNetwork). Throws core::InputError when the file is missing, damaged, not for this OpenCV
  /// or not a YOLO-seg network, or the labels do not fit.
  explicit YoloSegmenter(const YoloOptions& options, const std::filesystem::path& classesFile = {},
                         Backend backend = Backend::OpenCv);

  /// With a network that is open already; `source` is for error messages.
  YoloSegmenter(const YoloOptions& options, OpenedNetwork opened, const NetworkSource& source,
                const std::filesystem::path& classesFile = {});

  [[nodiscard]] Result segment(const SegmenterInput& input) override;
  [[nodiscard]] const core::LabelSpace& labelSpace() const override { return labels_.labels(); }

  /// What the network takes.
  [[nodiscard]] const cv::Size& inputSize_px() const { return input_px_; }

 private:
  void chooseOutputs(const std::vector<cv::Mat>& outputs, std::optional<std::size_t> named);

  YoloDecoderOptions options_;
  std::unique_ptr<Network> network_;
  cv::Size input_px_;
  std::string model_;                ///< For sentences.
  std::size_t detectionsIndex_ = 0;  ///< Which of the outputs …
  std::size_t prototypesIndex_ = 1;
  YoloLayout layout_;
  LabelMap labels_;
};

template <class Self, class Visitor>
void YoloOptions::describe(Self& self, Visitor& visit) {
  visit("model", self.model, "ONNX file of a YOLO-seg network (v5, v8 to v12, or with suppression inside, as yolo26)");
  YoloDecoderOptions::describe(self.decoder, visit);
}

}  // namespace wardslam::segmentation

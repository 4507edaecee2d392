#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "wardslam/segmentation/segmenter.h"
#include "wardslam/segmentation/yolo_decoder.h"

namespace wardslam::segmentation {

struct YoloOptions {
  std::string model;
  YoloDecoderOptions decoder;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit);
};

/// A YOLO-seg network (YOLOv5-seg or YOLOv8-seg layout, ONNX, input of fixed size) on cv::dnn, on the CPU.
///
/// Event "segmentation.network_failed": the network could not be run on this image; the result is empty.
class YoloSegmenter : public Segmenter {
 public:
  /// Loads the network and runs it once. `classesFile`: names in place of COCO's; needed unless the network knows 80
  /// classes. Throws core::InputError when the file is missing, damaged, not for this OpenCV or not a YOLO-seg network.
  explicit YoloSegmenter(const YoloOptions& options, const std::filesystem::path& classesFile = {});
  ~YoloSegmenter() override;

  [[nodiscard]] Result segment(const cv::Mat& color_bgr, double stamp_s) override;
  [[nodiscard]] const core::LabelSpace& labelSpace() const override { return labelSpace_; }

  /// What the network takes.
  [[nodiscard]] cv::Size inputSize_px() const;

 private:
  class Network;

  YoloDecoderOptions options_;
  std::unique_ptr<Network> network_;
  core::LabelSpace labelSpace_;
};

template <class Self, class Visitor>
void YoloOptions::describe(Self& self, Visitor& visit) {
  visit("model", self.model, "ONNX file of a YOLOv5-seg or YOLOv8-seg network");
  YoloDecoderOptions::describe(self.decoder, visit);
}

}  // namespace wardslam::segmentation

#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "wardslam/segmentation/mask_rcnn_decoder.h"
#include "wardslam/segmentation/network.h"
#include "wardslam/segmentation/segmenter.h"

namespace wardslam::segmentation {

struct MaskRcnnOptions {
  std::string model;
  std::string graph;
  int input_width_px = 0;
  int input_height_px = 0;
  MaskRcnnDecoderOptions decoder;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit);
};

/// The network of the paper (P3): Mask R-CNN from the TensorFlow object detection API, a frozen graph with OpenCV's
/// description of it, on cv::dnn. The image is stretched to the size of the input.
///
/// Event "segmentation.network_failed": the network could not be run on this image; the result is empty.
class MaskRcnnSegmenter : public Segmenter {
 public:
  /// Loads the network and runs it once. `classesFile`: label file; empty: the network knows COCO's 90 or 80 classes.
  /// Throws core::InputError when a file is missing, damaged or not that of a Mask R-CNN, or the labels do not fit.
  explicit MaskRcnnSegmenter(const MaskRcnnOptions& options, const std::filesystem::path& classesFile = {},
                             Backend backend = Backend::OpenCv);

  /// With a network that is open already; `source` is for error messages.
  MaskRcnnSegmenter(MaskRcnnOptions options, OpenedNetwork opened, const NetworkSource& source,
                    const std::filesystem::path& classesFile = {});

  [[nodiscard]] Result segment(const SegmenterInput& input) override;
  [[nodiscard]] const core::LabelSpace& labelSpace() const override { return labels_.labels(); }

 private:
  [[nodiscard]] cv::Mat blobOf(const cv::Mat& color_bgr) const;

  MaskRcnnOptions options_;
  std::unique_ptr<Network> network_;
  LabelMap labels_;
};

template <class Self, class Visitor>
void MaskRcnnOptions::describe(Self& self, Visitor& visit) {
  visit("model", self.model, "frozen TensorFlow graph of a Mask R-CNN (frozen_inference_graph.pb)");
  visit("graph", self.graph, "OpenCV's description of that graph (.pbtxt)");
  visit("input_width", self.input_width_px, {0, 4096}, "px", "size the image is scaled to; 0: that of the image");
  visit("input_height", self.input_height_px, {0, 4096}, "px", "size the image is scaled to; 0: that of the image");
  MaskRcnnDecoderOptions::describe(self.decoder, visit);
}

}  // namespace wardslam::segmentation

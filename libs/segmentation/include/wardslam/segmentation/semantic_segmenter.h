#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "wardslam/segmentation/network.h"
#include "wardslam/segmentation/segmenter.h"
#include "wardslam/segmentation/semantic_decoder.h"

namespace wardslam::segmentation {

struct SemanticOptions {
  /// What the numbers 0..255 of the image become before the network sees them.
  enum class Normalisation : std::uint8_t { None, ZeroToOne, MinusOneToOne, ImageNet };

  std::string model;
  std::string graph;
  std::string output;
  Normalisation normalisation = Normalisation::ImageNet;
  int input_width_px = 0;
  int input_height_px = 0;
  int min_region_px = 100;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit);
};

/// The numbers a network is trained with: CV_32F [1, 3, height, width], channels in the order RGB.
[[nodiscard]] cv::Mat normalised(const cv::Mat& image_bgr, SemanticOptions::Normalisation normalisation);

/// A network that tells the class of every pixel and knows no instances (DeepLab, FCN, PP-HumanSeg): ONNX, or a frozen
/// TensorFlow graph. The image is fitted into the input with its proportions kept.
///
/// Event "segmentation.network_failed": the network could not be run on this image; the result is empty.
class SemanticSegmenter : public Segmenter {
 public:
  /// Loads the network and runs it once. `classesFile`: label file; may be empty where the number of classes says
  /// enough (see LabelMap::forNetwork). Throws core::InputError when a file is missing, damaged or not that of a
  /// semantic network, the size of the input is not known, or the labels do not fit.
  explicit SemanticSegmenter(const SemanticOptions& options, const std::filesystem::path& classesFile = {},
                             Backend backend = Backend::OpenCv);

  /// With a network that is open already; `source` is for error messages.
  SemanticSegmenter(const SemanticOptions& options, OpenedNetwork opened, const NetworkSource& source,
                    const std::filesystem::path& classesFile = {});

  [[nodiscard]] Result segment(const SegmenterInput& input) override;
  [[nodiscard]] const core::LabelSpace& labelSpace() const override { return labels_.labels(); }

  /// What the network takes.
  [[nodiscard]] const cv::Size& inputSize_px() const { return input_px_; }

 private:
  SemanticOptions options_;
  std::unique_ptr<Network> network_;
  cv::Size input_px_;
  SemanticLayout layout_;
  LabelMap labels_;
};

template <class Self, class Visitor>
void SemanticOptions::describe(Self& self, Visitor& visit) {
  visit("model", self.model, "ONNX file or frozen TensorFlow graph of a network that tells the class of every pixel");
  visit("graph", self.graph, "OpenCV's description (.pbtxt) of a frozen graph, where it needs one");
  visit("output", self.output, "name of the output to use; empty: the first");
  visit("normalisation", self.normalisation, {"none", "zero_to_one", "minus_one_to_one", "imagenet"},
        "what the network expects in place of 0 to 255; imagenet: less ImageNet's mean, over its deviation");
  visit("input_width", self.input_width_px, {0, 4096}, "px", "size of the input; 0: as the file says");
  visit("input_height", self.input_height_px, {0, 4096}, "px", "size of the input; 0: as the file says");
  visit("min_region", self.min_region_px, {1, 1000000}, "px",
        "smallest region of one class that counts as an instance");
}

}  // namespace wardslam::segmentation

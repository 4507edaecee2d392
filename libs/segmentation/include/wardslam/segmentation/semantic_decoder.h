#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "wardslam/core/segmentation.h"
#include "wardslam/segmentation/label_map.h"
#include "wardslam/segmentation/letterbox.h"

namespace wardslam::segmentation {

/// How a semantic network lays out what it knows about each pixel.
struct SemanticLayout {
  enum class Kind {
    ScoresFirst,  ///< [1, classes, height, width], as PyTorch has it
    ScoresLast,   ///< [1, height, width, classes], as TensorFlow has it
    ClassMap      ///< [1, height, width], [1, 1, height, width] or [1, height, width, 1]: the index of the best class
  };

  Kind kind = Kind::ScoresFirst;
  int classes = 0;  ///< 0: not told (ClassMap).
  cv::Size size;

  /// Empty when the shape is none of those. Scores are laid out the way that gives their picture the proportions of the
  /// input, which tells the two kinds apart.
  [[nodiscard]] static std::optional<SemanticLayout> fromShape(const std::vector<int>& shape, const cv::Size& input_px);
};

/// Turns the output tensor (CV_32F) into a segmentation of the image: scores are resampled linearly before the best
/// class is chosen per pixel (classes that are best nowhere at the resolution of the output are left out of it), a
/// class map to the nearest. Such networks know no instances: each 8-connected region of one class and at least
/// `minRegion_px` is one, with confidence 1.
[[nodiscard]] core::Segmentation decodeSemantic(const cv::Mat& output, const SemanticLayout& layout,
                                                const Letterbox& letterbox, const LabelMap& labels, int minRegion_px);

}  // namespace wardslam::segmentation

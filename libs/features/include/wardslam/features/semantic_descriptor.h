#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "wardslam/core/keypoint.h"

namespace wardslam::features {

/// The local semantic descriptor D (Eq. 1–2, P4) of one key point: n×n class ids (CV_8UC1, n odd) of the pixels
/// around it, the patch rotated by the key point's orientation (Eq. 3–5, P5) so that turning the image leaves it
/// unchanged. Cells outside the image are 0 (unclassified).
///
/// `classIds`: CV_8UC1, raw image. `n`: side length in pixels, odd, > 0.
[[nodiscard]] cv::Mat describeSemantics(const cv::Mat& classIds, const core::Keypoint& keypoint, int n);

/// The descriptors of many key points at once: row i (n² columns, the patch row by row) belongs to keypoints[i].
[[nodiscard]] cv::Mat describeSemantics(const cv::Mat& classIds, const std::vector<core::Keypoint>& keypoints, int n);

/// The descriptors of an image's key points, each read out of the class image only when somebody compares it: making
/// this costs nothing, whatever n. What compares them is core::differenceOf() (P6): it counts cells that differ, as the
/// paper's example and its use as an outlier test need, where Eq. 6 as printed counts *equal* ones.
class SemanticDescriptors : public core::SemanticDescriptorSource {
 public:
  /// `classIds`, `n`: as above. Keeps a reference to the image, which must not change any more.
  SemanticDescriptors(const cv::Mat& classIds, int n) : classIds_(classIds), n_(n) {}
  /// The n² cells, row by row.
  [[nodiscard]] core::SemanticDescriptor of(const core::Keypoint& keypoint) const override;

 private:
  cv::Mat classIds_;
  int n_;
};

}  // namespace wardslam::features

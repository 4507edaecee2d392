#pragma once

#include <memory>
#include <optional>
#include <string>

#include "wardslam/filters/dynamic_test.h"
#include "wardslam/filters/observation_filter.h"
#include "wardslam/knowledge/motion_rules.h"

namespace wardslam::filters {

struct SemanticDynamicOptions {
  DynamicTestOptions test;
  int margin_px = 3;
  bool annotate = true;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    DynamicTestOptions::describe(self.test, visit);
    visit("margin_px", self.margin_px, {0, 100}, "px",
          "moving things are taken to be this much wider, as networks cut contours short; 0 = as segmented");
    visit("annotate", self.annotate, "write pixelLabels and confidenceImage of the observation");
  }
};

/// Segments every frame and rejects what moves, by who can move what (P1, P7):
///
///     filters:
///       - class_name: wardslam::filters::SemanticDynamicFilter
///         params:
///           n: 21
///           delta: 55
///           margin_px: 3
///           annotate: true
///
/// Needs a segmenter and a knowledge graph. Segments in begin(), beside the extraction of key points; apply() waits
/// for the masks, stores them in Frame::segmentation, sets Keypoint::motion and annotates Frame::observation.
/// A frame without masks stays static and counts as "filters.no_segmentation"; masks of another size than the image
/// ("filters.segmentation_size") count as none. An observation whose range image is not of the size of the colour
/// image is not annotated ("filters.annotation_size").
class SemanticDynamicFilter : public ObservationFilter {
  DEFINE_MRPT_OBJECT(SemanticDynamicFilter, wardslam::filters)

 public:
  void initialize(const core::ConfigNode& parameters, const FilterContext& context) override;
  void begin(const core::Frame& frame) override;
  void apply(core::Frame& frame) override;
  [[nodiscard]] std::string parameters(int indent) const override;

 private:
  void receiveSegmentation(core::Frame& frame);
  void markMotion(core::Frame& frame);
  void annotate(core::Frame& frame, const cv::Mat& movingMask);

  SemanticDynamicOptions options_;
  std::shared_ptr<segmentation::AsyncSegmenter> segmenter_;
  std::optional<knowledge::MotionRules> rules_;
  std::optional<DynamicTest> test_;
  cv::Mat movingIds_;  ///< 1×256: the id of each class that moves by itself, 0 of the others.
  bool isSubmitted_ = false;
};

}  // namespace wardslam::filters

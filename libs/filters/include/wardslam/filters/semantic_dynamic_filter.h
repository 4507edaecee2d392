#pragma once

#include <memory>
#include <optional>
#include <string>

#include "wardslam/filters/dynamic_test.h"
#include "wardslam/filters/mask_feed.h"
#include "wardslam/filters/observation_filter.h"
#include "wardslam/knowledge/motion_rules.h"

namespace wardslam::filters {

struct SemanticDynamicOptions {
  MaskFeedOptions masks;
  DynamicTestOptions test;
  int margin_px = 3;
  bool annotate = true;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    MaskFeedOptions::describe(self.masks, visit);
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
///           mode: propagate
///           n: 21
///           delta: 55
///           margin_px: 3
///           annotate: true
///
/// Needs a segmenter and a knowledge graph. Segmentation starts in begin(), beside the extraction of key points;
/// apply() gets the masks from its MaskFeed (which waits for them, or carries older ones here), stores them in
/// Frame::segmentation, sets Keypoint::motion and annotates Frame::observation. A frame without masks stays static and
/// counts as "filters.no_segmentation". An observation whose range image is not of the size of the colour
/// image is not annotated ("filters.annotation_size").
class SemanticDynamicFilter : public ObservationFilter {
  DEFINE_MRPT_OBJECT(SemanticDynamicFilter, wardslam::filters)

 public:
  void initialize(const core::ConfigNode& parameters, const FilterContext& context) override;
  void begin(const core::Frame& frame) override;
  void apply(core::Frame& frame) override;
  [[nodiscard]] std::string parameters(int indent) const override;

 private:
  void markMotion(core::Frame& frame);
  void annotate(core::Frame& frame, const cv::Mat& movingMask);

  SemanticDynamicOptions options_;
  std::unique_ptr<MaskFeed> masks_;
  std::optional<knowledge::MotionRules> rules_;
  std::optional<DynamicTest> test_;
  cv::Mat movingIds_;  ///< 1×256: the id of each class that moves by itself, 0 of the others.
  bool isBegun_ = false;
};

}  // namespace wardslam::filters

#pragma once

#include <memory>
#include <optional>
#include <string>

#include "dynamic_test.h"
#include "movable_judge.h"
#include "wardslam/filters/observation_filter.h"
#include "wardslam/knowledge/motion_rules.h"
#include "wardslam/masks/mask_feed.h"

namespace wardslam::filters {

struct SemanticDynamicOptions {
  enum class Rule : std::uint8_t { Observed, Paper };

  masks::MaskFeedOptions masks;
  Rule rule = Rule::Observed;
  MovableJudgeOptions judge;
  DynamicTestOptions test;
  int margin_px = 3;
  bool annotate = true;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    masks::MaskFeedOptions::describe(self.masks, visit);
    visit("rule", self.rule, {"observed", "paper"},
          "what makes a movable thing dynamic: that it is seen to move, suspected while somebody who can move it is "
          "near, or how many pixels of such movers are around (n, delta)");
    MovableJudgeOptions::describe(self.judge, visit);
    DynamicTestOptions::describe(self.test, visit);
    visit("margin_px", self.margin_px, {0, 100}, "px",
          "what moves is taken to be this much wider, as networks cut contours short; 0 = as segmented");
    visit("annotate", self.annotate, "write pixelLabels and confidenceImage of the observation");
  }
};

/// Segments every frame and rejects what moves, by who can move what (P1, P7):
///
///     filters:
///       - class_name: wardslam::filters::SemanticDynamicFilter
///         params:
///           mode: propagate
///           rule: observed
///           margin_px: 3
///           annotate: true
///
/// Needs a segmenter and a knowledge graph. Segmentation starts in begin(), beside the extraction of key points;
/// apply() gets the masks from its MaskFeed (which waits for them, or carries older ones here), stores them in
/// Frame::segmentation, sets Keypoint::motion and Features::signatures (P4-P6), and annotates Frame::observation. A
/// frame without masks stays static and counts as "filters.no_segmentation". An observation whose range image is not of
/// the size of the colour image is not annotated ("filters.annotation_size").
class SemanticDynamicFilter : public ObservationFilter {
  DEFINE_MRPT_OBJECT(SemanticDynamicFilter, wardslam::filters)

 public:
  void initialize(const core::ConfigNode& parameters, const FilterContext& context) override;
  void begin(const core::Frame& frame) override;
  void apply(core::Frame& frame) override;
  void end(const core::Frame& frame, const std::optional<Eigen::Isometry3d>& T_map_cam) override;
  [[nodiscard]] std::string parameters(int indent) const override;

 private:
  void markByPaper(core::Frame& frame, const cv::Mat& movers);
  void markByObservation(core::Frame& frame, const cv::Mat& movers);
  /// Returns the movers with their margin, and has the test ask about them.
  cv::Mat setTestImage(const cv::Mat& classIds, const cv::Mat& movers);
  void annotate(core::Frame& frame, const cv::Mat& dynamicMask);

  SemanticDynamicOptions options_;
  std::unique_ptr<masks::MaskFeed> masks_;
  std::optional<knowledge::MotionRules> rules_;
  std::optional<DynamicTest> test_;
  std::optional<MovableJudge> judge_;
  cv::Mat movingIds_;  ///< 1×256: the id of each class that moves by itself, 0 of the others.
  bool isBegun_ = false;
};

}  // namespace wardslam::filters

#pragma once

#include <memory>
#include <optional>
#include <string>

#include "dynamic_test.h"
#include "movable_judge.h"
#include "wardslam/core/side_job.h"
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
  }
};

/// Segments every frame and rejects what moves, by who can move what (P1, P7):
///
///     filters:
///       - class_name: wardslam::filters::SemanticDynamicFilter
///         params:
///           mode: wait            # for the masks of each image; propagate: take the newest there are, carried here
///           latency_frames: 0     # propagate: masks come so many frames late; 0 = once they are ready
///           bridge_s: 0.5         # what the segmenter misses stays for so long
///           rule: observed        # movable things are judged as wholes; paper: by the movers around each pixel
///           min_probability: 0.3  # rule observed: from which a movable thing counts as moving
///           n: 21                 # px, rule paper: side of the square that is searched for movers,
///           delta: 55             # px, and how many of them it must hold more than
///           margin_px: 3          # what moves is taken to be this much wider
///
/// Needs a segmenter and a knowledge graph. Segmentation starts in begin(), beside the extraction of key points;
/// apply() gets the masks from its MaskFeed (which waits for them, or carries older ones here), stores them in
/// Frame::segmentation, sets Keypoint::motion and Features::semanticDescriptors (P4-P6), and adds to Frame::labelBits
/// what every pixel shows: Person for a class that moves by itself, Movable for one that can be moved, Thing for any
/// class but those that move, Dynamic where something moves; and to Frame::mayMove what is suspected. A frame without
/// masks stays static and counts as "filters.no_segmentation".
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

  SemanticDynamicOptions options_;
  std::unique_ptr<masks::MaskFeed> masks_;
  std::optional<knowledge::MotionRules> rules_;
  std::optional<DynamicTest> test_;
  std::optional<MovableJudge> judge_;
  cv::Mat movingIds_;    ///< 1×256: the id of each class that moves by itself, 0 of the others.
  cv::Mat classLabels_;  ///< 1×256: bits of PixelLabel for each class.
  bool isBegun_ = false;
  core::SideJob<void> learning_;  ///< From the last image, until the next is judged.
};

}  // namespace wardslam::filters

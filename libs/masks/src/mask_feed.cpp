#include "wardslam/masks/mask_feed.h"

#include <optional>
#include <utility>

#include "mask_propagator.h"
#include "wardslam/core/side_job.h"
#include "wardslam/masks/async_segmenter.h"
#include "wardslam/masks/image_motion.h"

namespace wardslam::masks {
namespace {

/// Over a longer way the warp gets vague; it is better to go on from the masks carried so far.
constexpr int kMaxSteps = 10;

core::Segmentation copyOf(const core::Segmentation& masks) {
  return {masks.classIds.clone(), masks.instanceIds.clone(), masks.instances};
}

/// The masks, if they can belong to an image of this size.
core::Segmentation accept(segmentation::Segmenter::Result result, cv::Size image, core::EventCounts& events) {
  core::accumulate(events, result.events);
  if (result.segmentation.empty() || result.segmentation.classIds.size() == image) return result.segmentation;
  ++events["filters.segmentation_size"];
  return {};
}

SmallPicture smallPictureOf(const core::Frame& frame) { return shrink(frame.gray, frame.depth_m, frame.stamp_s); }

class PlainFeed : public MaskFeed {
 public:
  explicit PlainFeed(std::shared_ptr<AsyncSegmenter> segmenter) : segmenter_(std::move(segmenter)) {}

  void begin(const core::Frame& frame) override { segmenter_->submit(segmentation::inputOf(frame)); }
  void fill(core::Frame& frame) override {
    frame.segmentation = accept(segmenter_->wait(), frame.color_bgr.size(), frame.events);
  }

 private:
  std::shared_ptr<AsyncSegmenter> segmenter_;
};

class BridgingFeed : public MaskFeed {
 public:
  BridgingFeed(const MaskFeedOptions& options, std::shared_ptr<AsyncSegmenter> segmenter)
      : segmenter_(std::move(segmenter)), tracker_(options.tracker) {}

  void begin(const core::Frame& frame) override {
    segmenter_->submit(segmentation::inputOf(frame));
    carrying_.start([this, frame] { return carryLast(frame); });
  }

  void fill(core::Frame& frame) override {
    const core::Segmentation carried = carrying_.take();
    const core::Segmentation detected = accept(segmenter_->wait(), frame.color_bgr.size(), frame.events);
    frame.segmentation = tracker_.update(detected, carried, frame.stamp_s);
    last_ = copyOf(frame.segmentation);
  }

 private:
  core::Segmentation carryLast(const core::Frame& frame) {
    Trail trail(motion_.picture());
    motion_.advance(smallPictureOf(frame));
    if (motion_.step().empty()) return {};
    trail.follow(motion_.step());
    return carryMasks(last_, trail, motion_.picture());
  }

  std::shared_ptr<AsyncSegmenter> segmenter_;
  masks::InstanceTracker tracker_;
  masks::ImageMotion motion_;
  core::Segmentation last_;
  core::SideJob<core::Segmentation> carrying_;
};

class PropagatingFeed : public MaskFeed {
 public:
  PropagatingFeed(const MaskFeedOptions& options, std::shared_ptr<AsyncSegmenter> segmenter)
      : segmenter_(std::move(segmenter)), tracker_(options.tracker), latency_frames_(options.latency_frames) {}

  void begin(const core::Frame& frame) override {
    if (isDue()) finished_ = latency_frames_ > 0 ? segmenter_->wait() : segmenter_->tryTake();
    isSubmitted_ = !segmenter_->isExpected();
    if (isSubmitted_) segmenter_->submit(segmentation::inputOf(frame));
  }

  void fill(core::Frame& frame) override {
    advance(frame);
    if (auto result = std::exchange(finished_, std::nullopt); result && pending_) adopt(std::move(*result), frame);
    if (!newest_) waitForFirst(frame);
    frame.segmentation = carry();
    frame.segmentationAge_s = frame.stamp_s - newest_->stamp_s;
    frame.segmentationAge_frames = static_cast<int>(frame.index - newest_->frame);

    if (isSubmitted_) pending_ = anchorAt(frame, frame.segmentation);
    if (newest_->trail.steps() >= kMaxSteps) {
      newest_->trail = Trail(motion_.picture());
      newest_->masks = copyOf(frame.segmentation);
    }
  }

 private:
  /// Masks, the image they belong to, and the way from there to the present.
  struct Anchor {
    Trail trail;
    core::Segmentation masks;
    std::uint64_t frame = 0;  ///< Whose image the segmenter saw,
    double stamp_s = 0.0;     ///< and when.
  };

  [[nodiscard]] bool isDue() const {
    return pending_ && (latency_frames_ == 0 || pending_->trail.steps() + 1 >= latency_frames_);
  }

  void advance(const core::Frame& frame) {
    motion_.advance(smallPictureOf(frame));
    if (motion_.step().empty()) {  // the first image, or one of another size
      newest_.reset();
      pending_.reset();
    }
    if (newest_) newest_->trail.follow(motion_.step());
    if (pending_) pending_->trail.follow(motion_.step());
  }

  /// The segmenter's masks of the pending image: from now on these are carried.
  void adopt(segmentation::Segmenter::Result result, core::Frame& frame) {
    const core::Segmentation detected = accept(std::move(result), frame.color_bgr.size(), frame.events);
    pending_->masks = tracker_.update(detected, pending_->masks, pending_->stamp_s);
    newest_ = std::exchange(pending_, std::nullopt);
  }

  void waitForFirst(core::Frame& frame) {
    if (!isSubmitted_) {  // it works on an image that was before
      (void)segmenter_->wait();
      segmenter_->submit(segmentation::inputOf(frame));
    }
    const core::Segmentation detected = accept(segmenter_->wait(), frame.color_bgr.size(), frame.events);
    newest_ = anchorAt(frame, tracker_.update(detected, {}, frame.stamp_s));
    isSubmitted_ = false;
  }

  [[nodiscard]] Anchor anchorAt(const core::Frame& frame, const core::Segmentation& masks) const {
    return {Trail(motion_.picture()), copyOf(masks), frame.index, frame.stamp_s};
  }

  /// The newest masks as they are to be now; shares no pixels.
  [[nodiscard]] core::Segmentation carry() const {
    if (!newest_) return {};
    if (newest_->trail.steps() == 0) return copyOf(newest_->masks);
    return carryMasks(newest_->masks, newest_->trail, motion_.picture());
  }

  std::shared_ptr<AsyncSegmenter> segmenter_;
  masks::InstanceTracker tracker_;
  masks::ImageMotion motion_;
  int latency_frames_ = 0;
  std::optional<Anchor> newest_;                             ///< The last masks that came.
  std::optional<Anchor> pending_;                            ///< The image in work, with the masks carried to it.
  std::optional<segmentation::Segmenter::Result> finished_;  ///< Of the pending image, not yet adopted.
  bool isSubmitted_ = false;                                 ///< The present image is with the segmenter.
};

}  // namespace

std::unique_ptr<MaskFeed> makeMaskFeed(const MaskFeedOptions& options, std::shared_ptr<AsyncSegmenter> segmenter) {
  if (options.mode == MaskFeedOptions::Mode::Propagate) {
    return std::make_unique<PropagatingFeed>(options, std::move(segmenter));
  }
  if (options.keepsIds || options.tracker.bridge_s > 0)
    return std::make_unique<BridgingFeed>(options, std::move(segmenter));
  return std::make_unique<PlainFeed>(std::move(segmenter));
}

}  // namespace wardslam::masks

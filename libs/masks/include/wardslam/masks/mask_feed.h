#pragma once

#include <cstdint>
#include <memory>

#include "wardslam/core/frame.h"
#include "wardslam/masks/instance_tracker.h"

namespace wardslam::masks {

class AsyncSegmenter;

struct MaskFeedOptions {
  enum class Mode : std::uint8_t { Wait, Propagate };

  Mode mode = Mode::Wait;
  int latency_frames = 0;
  InstanceTrackerOptions tracker;
  bool keepsIds = true;  ///< False: in Wait, without a bridge, ids are those of the segmenter. Not for the user to say.

  [[nodiscard]] bool isRepeatable() const { return mode == Mode::Wait || latency_frames > 0; }

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("mode", self.mode, {"wait", "propagate"},
          "tracking waits for the masks of each image, or takes the newest there are, carried to the image");
    visit("latency_frames", self.latency_frames, {0, 1000}, "frames",
          "propagate: masks come just so many frames after their image, for runs that repeat; 0 = once they are ready");
    InstanceTrackerOptions::describe(self.tracker, visit);
  }
};

/// Where the masks of a frame come from.
///  - Wait: the segmenter gets every image, and the caller waits for it (P1).
///  - Propagate: the segmenter works behind, on the newest image whenever it is free. Its newest masks are carried to
///    the frame (carryMasks). Only those of the first frame are waited for: a map begins with it.
/// In both, instances keep their ids over time, and what the segmenter misses stays for a while
/// (InstanceTracker).
class MaskFeed {
 public:
  virtual ~MaskFeed() = default;

  /// The images of the next frame are there. Does not block, unless `latency_frames` asks for it.
  virtual void begin(const core::Frame& frame) = 0;

  /// After begin(): sets Frame::segmentation, which stays empty where there are no masks, and its age. Masks of
  /// another size than the image ("filters.segmentation_size") count as none.
  virtual void fill(core::Frame& frame) = 0;
};

[[nodiscard]] std::unique_ptr<MaskFeed> makeMaskFeed(const MaskFeedOptions& options,
                                                     std::shared_ptr<AsyncSegmenter> segmenter);

}  // namespace wardslam::masks

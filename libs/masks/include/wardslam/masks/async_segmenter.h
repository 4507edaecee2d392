#pragma once

#include <condition_variable>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "wardslam/masks/contour_refiner.h"
#include "wardslam/segmentation/segmenter.h"

namespace wardslam::masks {

/// Runs a Segmenter in a thread of its own, so that the caller can extract key points meanwhile (P1). At most one
/// image waits: a newer one takes the place of one that was not begun. For one calling thread. Contours are refined
/// there too, where a refiner is given.
class AsyncSegmenter {
 public:
  explicit AsyncSegmenter(std::unique_ptr<segmentation::Segmenter> segmenter,
                          std::optional<ContourRefiner> refiner = std::nullopt);
  ~AsyncSegmenter();  ///< Waits for the image in work, drops the one that waits.
  AsyncSegmenter(const AsyncSegmenter&) = delete;
  AsyncSegmenter& operator=(const AsyncSegmenter&) = delete;

  /// Returns at once. Keeps a reference to the pixels: do not change them before its result was taken.
  void submit(const segmentation::SegmenterInput& input);

  /// The result of the last submit(), once for each; throws what the segmenter threw. Throws std::logic_error when
  /// nothing was submitted since.
  [[nodiscard]] segmentation::Segmenter::Result wait();

  /// As wait(), but returns at once: nothing while the work goes on, or when nothing is expected.
  [[nodiscard]] std::optional<segmentation::Segmenter::Result> tryTake();

  /// Whether the result of the last submit() was not taken yet.
  [[nodiscard]] bool isExpected() const { return result_.valid(); }

  /// Segmenter::finish(), after all work is done.
  void finish();

  [[nodiscard]] const core::LabelSpace& labelSpace() const { return segmenter_->labelSpace(); }

 private:
  using Task = std::packaged_task<segmentation::Segmenter::Result()>;
  void work();

  [[nodiscard]] segmentation::Segmenter::Result segment(const segmentation::SegmenterInput& input);

  std::unique_ptr<segmentation::Segmenter> segmenter_;
  std::optional<ContourRefiner> refiner_;
  std::future<segmentation::Segmenter::Result> result_;

  std::mutex mutex_;  // of the two members that follow
  Task pending_;
  bool stopping_ = false;
  std::condition_variable changed_;
  std::thread worker_;
};

}  // namespace wardslam::masks

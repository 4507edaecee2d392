#include "wardslam/masks/async_segmenter.h"

#include <chrono>
#include <stdexcept>
#include <utility>

namespace wardslam::masks {

AsyncSegmenter::AsyncSegmenter(std::unique_ptr<segmentation::Segmenter> segmenter,
                               std::optional<ContourRefiner> refiner)
    : segmenter_(std::move(segmenter)), refiner_(refiner), worker_([this] { work(); }) {}

AsyncSegmenter::~AsyncSegmenter() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_one();
  worker_.join();
}

void AsyncSegmenter::submit(const segmentation::SegmenterInput& input) {
  Task task([this, input] { return segment(input); });
  result_ = task.get_future();
  {
    const std::lock_guard lock(mutex_);
    pending_ = std::move(task);
  }
  changed_.notify_one();
}

segmentation::Segmenter::Result AsyncSegmenter::wait() {
  if (!result_.valid()) throw std::logic_error("AsyncSegmenter::wait() without a submit() before it");
  return result_.get();
}

std::optional<segmentation::Segmenter::Result> AsyncSegmenter::tryTake() {
  if (!result_.valid() || result_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
  return result_.get();
}

void AsyncSegmenter::finish() {
  if (result_.valid()) result_.wait();
  segmenter_->finish();
}

segmentation::Segmenter::Result AsyncSegmenter::segment(const segmentation::SegmenterInput& input) {
  auto result = segmenter_->segment(input);
  if (refiner_) {
    result.segmentation =
        refiner_->refine(input.color_bgr, input.depth_m, input.camera.depthNoise, result.segmentation);
  }
  return result;
}

void AsyncSegmenter::work() {
  while (true) {
    Task task;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [this] { return stopping_ || pending_.valid(); });
      if (stopping_) return;
      task = std::exchange(pending_, Task());
    }
    task();  // what it throws reaches wait() through the future
  }
}

}  // namespace wardslam::masks

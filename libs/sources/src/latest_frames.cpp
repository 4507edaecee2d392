#include "wardslam/sources/latest_frames.h"

#include <utility>

namespace wardslam::sources {

void LatestFrames::push(std::string frame) {
  {
    const std::lock_guard lock(mutex_);
    ++pushed_;
    waiting_.push_back(std::move(frame));
    if (waiting_.size() > capacity_) {
      waiting_.pop_front();
      ++skipped_;
    }
  }
  changed_.notify_one();
}

std::optional<std::string> LatestFrames::pop(std::chrono::milliseconds patience) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, patience, [this] { return !waiting_.empty() || isClosed_; });
  if (waiting_.empty()) return std::nullopt;
  std::string frame = std::move(waiting_.front());
  waiting_.pop_front();
  return frame;
}

void LatestFrames::close() {
  {
    const std::lock_guard lock(mutex_);
    isClosed_ = true;
  }
  changed_.notify_all();
}

void LatestFrames::discard() {
  const std::lock_guard lock(mutex_);
  skipped_ += waiting_.size();
  waiting_.clear();
}

bool LatestFrames::isDrained() const {
  const std::lock_guard lock(mutex_);
  return isClosed_ && waiting_.empty();
}

std::size_t LatestFrames::pushed() const {
  const std::lock_guard lock(mutex_);
  return pushed_;
}

std::size_t LatestFrames::skipped() const {
  const std::lock_guard lock(mutex_);
  return skipped_;
}

}  // namespace wardslam::sources

#include "prefetching_source.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <utility>

namespace wardslam::sources {

PrefetchingSource::PrefetchingSource(const Opener& open, WarningSink warn, std::size_t capacity)
    : warn_(std::move(warn)),
      capacity_(capacity),
      inner_(open([this](const std::string& sentence) { collectedWarnings_.push_back(sentence); })),
      size_(inner_->size()),
      traits_(inner_->sensorTraits()),
      rate_hz_(inner_->rate_hz()),
      damage_(inner_->damage()),
      sensors_(inner_->sensors()) {
  deliverWarnings(std::exchange(collectedWarnings_, {}));
  thread_ = std::thread([this] { produce(); });
}

PrefetchingSource::~PrefetchingSource() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

std::shared_ptr<mrpt::obs::CObservation3DRangeScan> PrefetchingSource::next() {
  if (ended_) return nullptr;
  Delivery delivery;
  {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !ready_.empty(); });
    delivery = std::move(ready_.front());
    ready_.pop_front();
  }
  changed_.notify_all();

  ended_ = delivery.isLast();
  damage_ = std::move(delivery.damage);
  sensors_ = std::move(delivery.sensors);
  deliverWarnings(delivery.warnings);
  if (delivery.error) std::rethrow_exception(delivery.error);
  return delivery.observation;
}

void PrefetchingSource::produce() {
  for (bool isLast = false; !isLast;) {
    Delivery delivery = fetch();
    isLast = delivery.isLast();
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return stopping_ || ready_.size() < capacity_; });
    if (stopping_) return;
    ready_.push_back(std::move(delivery));
    lock.unlock();
    changed_.notify_all();
  }
}

PrefetchingSource::Delivery PrefetchingSource::fetch() {
  Delivery delivery;
  try {
    delivery.observation = inner_->next();
  } catch (...) {
    delivery.error = std::current_exception();
  }
  delivery.damage = inner_->damage();
  delivery.sensors = inner_->sensors();
  delivery.warnings = std::exchange(collectedWarnings_, {});
  return delivery;
}

void PrefetchingSource::deliverWarnings(const std::vector<std::string>& warnings) const {
  if (!warn_) return;
  for (const std::string& sentence : warnings) warn_(sentence);
}

}  // namespace wardslam::sources

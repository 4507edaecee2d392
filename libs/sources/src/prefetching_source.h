#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "wardslam/sources/observation_source.h"

namespace wardslam::sources {

/// Reads another source ahead in a thread of its own. What it delivers – observations, damage, warnings, exceptions –
/// comes in the same order and at the same call of next() as without it.
class PrefetchingSource : public ObservationSource {
 public:
  using Opener = std::function<std::unique_ptr<ObservationSource>(WarningSink)>;

  /// Opens the inner source, in the calling thread, with a warning sink that leads to `warn`. At most `capacity`
  /// observations are kept ready.
  PrefetchingSource(const Opener& open, WarningSink warn, std::size_t capacity = 2);
  ~PrefetchingSource() override;

  [[nodiscard]] std::shared_ptr<mrpt::obs::CObservation3DRangeScan> next() override;
  [[nodiscard]] std::optional<std::size_t> size() const override { return size_; }
  [[nodiscard]] const core::EventCounts& damage() const override { return damage_; }
  [[nodiscard]] SensorCounts sensors() const override { return sensors_; }
  [[nodiscard]] core::SensorTraits sensorTraits() const override { return traits_; }
  [[nodiscard]] double rate_hz() const override { return rate_hz_; }

 private:
  /// What one call of the inner next() brought.
  struct Delivery {
    std::shared_ptr<mrpt::obs::CObservation3DRangeScan> observation;
    core::EventCounts damage;
    SensorCounts sensors;
    std::vector<std::string> warnings;
    std::exception_ptr error;

    [[nodiscard]] bool isLast() const { return observation == nullptr; }
  };

  void produce();
  [[nodiscard]] Delivery fetch();
  void deliverWarnings(const std::vector<std::string>& warnings) const;

  WarningSink warn_;
  std::size_t capacity_;
  std::vector<std::string> collectedWarnings_;  ///< By the thread that calls the inner source.
  std::unique_ptr<ObservationSource> inner_;
  std::optional<std::size_t> size_;
  core::SensorTraits traits_;
  double rate_hz_;
  core::EventCounts damage_;
  SensorCounts sensors_;
  bool ended_ = false;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Delivery> ready_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace wardslam::sources

#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "wardslam/core/event_counts.h"
#include "wardslam/sources/observation_source.h"

namespace wardslam::sources {

/// One observation cannot be read; the rest of the input may be sound. what() is a sentence without its full stop.
class InputDamage : public std::runtime_error {
 public:
  InputDamage(std::string event, const std::string& sentence)
      : std::runtime_error(sentence), event_(std::move(event)) {}

  [[nodiscard]] const std::string& event() const { return event_; }  ///< "sources.image_missing"

 private:
  std::string event_;
};

/// Counts damage by kind and warns of the first of each kind.
class DamageLog {
 public:
  explicit DamageLog(WarningSink warn) : warn_(std::move(warn)) {}

  void add(const std::string& event, const std::string& sentence) {
    if (++counts_[event] == 1 && warn_) warn_(sentence);
  }
  [[nodiscard]] const core::EventCounts& counts() const { return counts_; }

 private:
  WarningSink warn_;
  core::EventCounts counts_;
};

}  // namespace wardslam::sources

#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace wardslam::bags {

/// A part of a bag cannot be read; the rest may be sound. what() is a sentence without its full stop.
class BagDamage : public std::runtime_error {
 public:
  BagDamage(std::string event, const std::string& sentence) : std::runtime_error(sentence), event_(std::move(event)) {}

  [[nodiscard]] const std::string& event() const { return event_; }  ///< "sources.bag_truncated"

 private:
  std::string event_;
};

}  // namespace wardslam::bags

#pragma once

#include <string>

#include "wardslam/core/digest.h"

namespace wardslam::fleet {

using core::digestOf;

/// Of a whole that comes in parts: that of the parts' digests.
class DigestOfParts {
 public:
  void add(const std::string& digest) { digests_ += digest; }
  [[nodiscard]] std::string result() const { return digestOf(digests_); }

 private:
  std::string digests_;
};

}  // namespace wardslam::fleet

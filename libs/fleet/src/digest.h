#pragma once

#include <string>
#include <string_view>

namespace wardslam::fleet {

/// SHA-256 of bytes, in lower-case hexadecimal.
[[nodiscard]] std::string digestOf(std::string_view bytes);

/// Of a whole that comes in parts: that of the parts' digests.
class DigestOfParts {
 public:
  void add(const std::string& digest) { digests_ += digest; }
  [[nodiscard]] std::string result() const { return digestOf(digests_); }

 private:
  std::string digests_;
};

}  // namespace wardslam::fleet

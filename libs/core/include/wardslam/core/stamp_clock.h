#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wardslam::core {

/// What the stamps of a list or in the names of files count.
enum class StampUnit { Seconds, Milliseconds, Microseconds, Nanoseconds, Frames };

/// The double nearest to it, which the same time written in seconds is read as.
[[nodiscard]] double secondsOf(std::int64_t stamp_ns);

/// Tells the time by stamps as other programs write them: "1305031102.1754" (s), "1305031102175" (ms), … , "42" (the
/// 43rd image).
class StampClock {
 public:
  StampClock() = default;
  /// `rate_hz`: images per second, for StampUnit::Frames.
  explicit StampClock(StampUnit unit, double rate_hz = 30.0) : unit_(unit), rate_hz_(rate_hz) {}

  /// Seconds by the clock; nothing where the word is no finite number.
  [[nodiscard]] std::optional<double> seconds(std::string_view word) const;

  [[nodiscard]] StampUnit unit() const { return unit_; }
  [[nodiscard]] bool isSeconds() const { return unit_ == StampUnit::Seconds; }

  /// "counts nanoseconds", "numbers the images, which are taken at 30 a second"; the end of a sentence about a list.
  [[nodiscard]] std::string sentencePart() const;

 private:
  StampUnit unit_ = StampUnit::Seconds;
  double rate_hz_ = 30.0;
};

/// Tells the clock by its stamps, in their order; nothing where they could mean one thing as well as another.
///
/// Stamps of today tell by their size: seconds have 10 digits before the point, milliseconds 13, microseconds 16,
/// nanoseconds 19. Clocks that began with the recording or the computer tell by the steps from image to image: what
/// counts by one ("722", or ten and more like "722.000000") or is filled up with zeros, numbers images; steps of about
/// 33 that jitter are milliseconds, of more than 5000 micro- or nanoseconds.
[[nodiscard]] std::optional<StampUnit> recogniseStampUnit(const std::vector<std::string_view>& stamps);

}  // namespace wardslam::core

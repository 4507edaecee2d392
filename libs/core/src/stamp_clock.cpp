#include "wardslam/core/stamp_clock.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <sstream>

namespace wardslam::core {
namespace {

constexpr double kLargestSeconds = 1e11;  // the year 5138
constexpr double kLargestMilliseconds = 1e14;
constexpr double kLargestMicroseconds = 1e17;
constexpr double kLargestFrame = 1e8;  // at 30 a second, 38 days
constexpr std::size_t kLeastWithPoint = 10;
constexpr double kShortestStep_ms = 15.0;
constexpr double kLongestStep_ms = 200.0;
constexpr double kShortestStep_us = 5e3;
constexpr double kShortestStep_ns = 5e6;
constexpr double kLongestStep_ns = 5e9;

std::optional<double> numberIn(std::string_view word) {
  double number = 0.0;
  const char* const end = word.data() + word.size();
  const auto [parsedTo, error] = std::from_chars(word.data(), end, number);
  if (error != std::errc() || parsedTo != end || !std::isfinite(number)) return std::nullopt;
  return number;
}

/// "722" and "722.000000", not "722.5" nor "7e2".
bool isWhole(std::string_view stamp) {
  const std::size_t point = stamp.find('.');
  return stamp.find_first_of("eE") == std::string_view::npos &&
         (point == std::string_view::npos || stamp.find_first_not_of('0', point + 1) == std::string_view::npos);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double perSecond(StampUnit unit, double rate_hz) {
  switch (unit) {
    case StampUnit::Milliseconds:
      return 1e3;
    case StampUnit::Microseconds:
      return 1e6;
    case StampUnit::Nanoseconds:
      return 1e9;
    case StampUnit::Frames:
      return rate_hz;
    case StampUnit::Seconds:
      break;
  }
  return 1.0;
}

/// By the steps of whole numbers that are too small to be the time of day.
std::optional<StampUnit> unitBySteps(const std::vector<double>& numbers) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    if (numbers[i] != numbers[i - 1]) steps.push_back(std::abs(numbers[i] - numbers[i - 1]));
  }
  if (steps.empty()) return StampUnit::Seconds;
  const double step = median(steps);
  const bool isEven = std::all_of(steps.begin(), steps.end(), [&](double other) { return other == step; });
  if (numbers.back() >= kLargestFrame && step <= 10.0) return StampUnit::Seconds;  // UNIX time at a leisurely rate
  if (step == 1.0 || (isEven && step <= 10.0)) return StampUnit::Frames;
  if (step >= kShortestStep_ns && step <= kLongestStep_ns) return StampUnit::Nanoseconds;
  if (step >= kShortestStep_us && step < kShortestStep_ns) return StampUnit::Microseconds;
  // About the rate of a camera, and jittering as time does; numbers of chosen images jump farther.
  const bool jitters = !isEven && std::all_of(steps.begin(), steps.end(),
                                              [&](double other) { return other > 0.5 * step && other < 2.5 * step; });
  if (jitters && step >= kShortestStep_ms && step <= kLongestStep_ms) return StampUnit::Milliseconds;
  return std::nullopt;
}

}  // namespace

/// In two parts, as 19 digits are more than a double holds.
double secondsOf(std::int64_t stamp_ns) {
  constexpr std::int64_t kSecond_ns = 1'000'000'000;
  const std::int64_t whole_s = stamp_ns / kSecond_ns;
  return static_cast<double>(whole_s) + static_cast<double>(stamp_ns % kSecond_ns) / 1e9;
}

std::optional<double> StampClock::seconds(std::string_view word) const {
  const std::string_view whole = word.substr(0, word.find_first_of(".eE"));
  std::int64_t count = 0;
  const char* const end = whole.data() + whole.size();
  const auto [parsedTo, error] = std::from_chars(whole.data(), end, count);
  const auto number = numberIn(word);
  if (!number) return std::nullopt;
  const bool isPlain = error == std::errc() && parsedTo == end && word.find_first_of("eE") == std::string_view::npos;
  if (unit_ == StampUnit::Seconds || unit_ == StampUnit::Frames || !isPlain) {
    return *number / perSecond(unit_, rate_hz_);
  }
  // In two parts, as 19 digits are more than a double holds.
  const auto units = static_cast<std::int64_t>(perSecond(unit_, rate_hz_));
  const double fraction =
      (static_cast<double>(count % units) + (*number - std::floor(*number))) / static_cast<double>(units);
  const std::int64_t wholeSeconds = count / units;
  return static_cast<double>(wholeSeconds) + fraction;
}

std::string StampClock::sentencePart() const {
  switch (unit_) {
    case StampUnit::Milliseconds:
      return "counts milliseconds";
    case StampUnit::Microseconds:
      return "counts microseconds";
    case StampUnit::Nanoseconds:
      return "counts nanoseconds";
    case StampUnit::Frames: {
      std::ostringstream text;
      text << "numbers the images instead of telling the time, so they are taken at " << rate_hz_ << " a second";
      return text.str();
    }
    case StampUnit::Seconds:
      break;
  }
  return "counts seconds";
}

std::optional<StampUnit> recogniseStampUnit(const std::vector<std::string_view>& stamps) {
  std::vector<double> numbers;
  bool areWhole = true;
  bool arePadded = false;
  bool havePoints = false;
  for (const std::string_view stamp : stamps) {
    const auto number = numberIn(stamp);
    if (!number) continue;  // whoever reads the list tells of it
    numbers.push_back(*number);
    areWhole = areWhole && isWhole(stamp);
    havePoints = havePoints || stamp.find('.') != std::string_view::npos;
    arePadded = arePadded || (stamp.find('.') == std::string_view::npos && stamp.size() > 1 && stamp.front() == '0');
  }
  if (numbers.empty()) return StampUnit::Seconds;
  const double size = median(numbers);
  if (size >= kLargestMicroseconds) return StampUnit::Nanoseconds;
  if (size >= kLargestMilliseconds) return StampUnit::Microseconds;
  if (size >= kLargestSeconds) return StampUnit::Milliseconds;
  // A few whole seconds may be just these; nobody takes images for long exactly at every full second.
  if (!areWhole || (havePoints && numbers.size() < kLeastWithPoint)) return StampUnit::Seconds;
  return arePadded && numbers.size() > 1 ? StampUnit::Frames : unitBySteps(numbers);
}

}  // namespace wardslam::core

#include "depth_scale_check.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <limits>
#include <sstream>

namespace wardslam::sources {
namespace {

constexpr std::size_t kImages = 5;
constexpr int kStep_px = 4;
// Where cameras of rooms measure: what lies outside is rare, and little lies close to the near end.
constexpr double kNear_m = 0.5;
constexpr double kClose_m = 1.5;
constexpr double kFar_m = 8.0;
constexpr double kBeyond_m = 10.0;
constexpr double kMany = 0.1;  // of what was measured
constexpr double kHardlyAny = 0.01;

std::string sentence(const char* where, double unitsPerMetre) {
  std::ostringstream text;
  text
      << where << ", with " << unitsPerMetre
      << " units a metre; if that is the wrong unit, give the right one: --depth-factor 1000 for millimetres, 5000 for "
         "the TUM benchmark's";
  return text.str();
}

}  // namespace

std::optional<std::string> DepthScaleCheck::add(mrpt::obs::CObservation3DRangeScan& scan) {
  if (images_ >= kImages) return std::nullopt;
  ++images_;
  const auto rows = static_cast<int>(scan.rangeImage.rows());
  const auto columns = static_cast<int>(scan.rangeImage.cols());
  for (int y = 0; y < rows; y += kStep_px) {
    for (int x = 0; x < columns; x += kStep_px) {
      const std::uint16_t units = scan.rangeImage(y, x);
      if (units == 0 || units == std::numeric_limits<std::uint16_t>::max()) continue;
      const double range_m = units * static_cast<double>(scan.rangeUnits);
      ++measured_;
      if (range_m < kNear_m) ++near_;
      if (range_m > kClose_m) ++notClose_;
      if (range_m > kFar_m) ++far_;
      if (range_m > kBeyond_m) ++beyond_;
    }
  }
  if (images_ < kImages) return std::nullopt;
  const double unitsPerMetre = 1.0 / static_cast<double>(scan.rangeUnits);
  const auto share = [this](std::size_t count) { return static_cast<double>(count) / static_cast<double>(measured_); };
  if (measured_ == 0) return std::nullopt;
  if (share(near_) > 0.5) return sentence("most depths lie nearer than 0.5 m", unitsPerMetre);
  if (share(far_) > 0.5) return sentence("most depths lie farther than 8 m", unitsPerMetre);
  if (share(near_) > kMany && share(notClose_) < kHardlyAny)
    return sentence("hardly any depth lies farther than 1.5 m, and many nearer than 0.5 m", unitsPerMetre);
  if (share(beyond_) > kMany)
    return sentence("many depths lie farther than 10 m, where few cameras measure", unitsPerMetre);
  return std::nullopt;
}

}  // namespace wardslam::sources

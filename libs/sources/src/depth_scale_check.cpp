#include "depth_scale_check.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <limits>
#include <sstream>

namespace wardslam::sources {
namespace {

constexpr std::size_t kImages = 5;
constexpr int kStep_px = 4;
constexpr double kNear_m = 0.5;
constexpr double kFar_m = 8.0;

std::string sentence(const char* where, double unitsPerMetre) {
  std::ostringstream text;
  text
      << "most depths lie " << where << ", with " << unitsPerMetre
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
      if (range_m > kFar_m) ++far_;
    }
  }
  if (images_ < kImages) return std::nullopt;
  const double unitsPerMetre = 1.0 / static_cast<double>(scan.rangeUnits);
  if (2 * near_ > measured_) return sentence("nearer than 0.5 m", unitsPerMetre);
  if (2 * far_ > measured_) return sentence("farther than 8 m", unitsPerMetre);
  return std::nullopt;
}

}  // namespace wardslam::sources

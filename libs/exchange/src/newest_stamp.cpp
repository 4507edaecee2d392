#include "newest_stamp.h"

#include <algorithm>
#include <ctime>

namespace wardslam::exchange {

std::string newestStampOf(const mapping::SemanticMap& map) {
  double newest_s = 0.0;
  for (const auto& [id, keyframe] : map.keyframes) newest_s = std::max(newest_s, keyframe.stamp_s);
  const auto seconds = static_cast<std::time_t>(newest_s);
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S.000Z", &utc);
  return text;
}

}  // namespace wardslam::exchange

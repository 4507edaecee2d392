#include "sensors/mishaps.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace wardslam::synth {

Cover parseCover(const std::string& text) {
  std::istringstream in(text);
  Cover cover;
  char colon = 0;
  const bool isRead = static_cast<bool>(in >> cover.from_s >> colon >> cover.seconds) && in.peek() == EOF;
  if (!isRead || colon != ':' || !(cover.from_s >= 0) || !(cover.seconds > 0)) {
    throw std::invalid_argument("'" + text + "' is not FROM:SECONDS, as in 12.5:3");
  }
  return cover;
}

double coveredShare(const std::vector<Cover>& covers, double t_s) {
  double most = 0.0;
  for (const Cover& cover : covers) {
    const double since_s = t_s - cover.from_s;
    const double left_s = cover.from_s + cover.seconds - t_s;
    most = std::max(most, std::min(1.0, std::min(since_s, left_s) / kHand_s));
  }
  return most;
}

int firstCoveredRow(double share, int rows) { return rows - static_cast<int>(std::lround(share * rows)); }

void coverColor(cv::Mat& light_bgr, double share) {
  const cv::Scalar skinAgainstTheLight(5, 4, 12);
  light_bgr.rowRange(firstCoveredRow(share, light_bgr.rows), light_bgr.rows).setTo(skinAgainstTheLight);
}

std::vector<bool> lostFrames(std::size_t total, double share, std::uint32_t seed) {
  std::vector<bool> lost(total, false);
  if (share <= 0) return lost;
  cv::RNG rng((static_cast<std::uint64_t>(seed) << 32U) + 0xD20B5U);
  const double ends = 1.0 / kBurst;
  const double begins = std::min(1.0, ends * share / (1.0 - share));
  for (std::size_t i = 1; i < total; ++i) lost[i] = rng.uniform(0.0, 1.0) < (lost[i - 1] ? 1.0 - ends : begins);
  return lost;
}

}  // namespace wardslam::synth

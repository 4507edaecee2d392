#pragma once

#include <cstddef>
#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

/// What happens to recordings of real cameras.
namespace wardslam::synth {

/// A hand over the lens.
struct Cover {
  double from_s = 0.0;
  double seconds = 1.0;
};

/// "FROM:SECONDS". Throws std::invalid_argument with a sentence.
[[nodiscard]] Cover parseCover(const std::string& text);

struct MishapOptions {
  std::vector<Cover> covers;
  double lostShare = 0.0;  ///< Of the frames, which the recorder did not keep.
};

/// How much of the image the hand hides at that moment, 0 to 1: it comes from below and goes back within kHand_s.
[[nodiscard]] double coveredShare(const std::vector<Cover>& covers, double t_s);
constexpr double kHand_s = 0.15;

/// Rows of the image that a hand covers are those from here on.
[[nodiscard]] int firstCoveredRow(double share, int rows);

/// Lets the hand hide the lower part of a picture (CV_8UC3, before noise): near black, a little red.
void coverColor(cv::Mat& light_bgr, double share);

/// Which frames are lost; the first never is. They are lost in bursts of kBurst on average (Gilbert's two-state model),
/// as when a disk is busy.
[[nodiscard]] std::vector<bool> lostFrames(std::size_t total, double share, std::uint32_t seed);
constexpr double kBurst = 3.0;

}  // namespace wardslam::synth

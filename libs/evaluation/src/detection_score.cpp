#include "wardslam/evaluation/detection_score.h"

#include <limits>

namespace wardslam::evaluation {
namespace {

double share(std::uint64_t part, std::uint64_t rest) {
  if (part + rest == 0) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(part) / static_cast<double>(part + rest);
}

std::uint64_t count(const cv::Mat& mask) { return static_cast<std::uint64_t>(cv::countNonZero(mask)); }

}  // namespace

void DetectionScore::add(bool detected, bool isTrue) {
  if (isTrue) {
    ++(detected ? truePositives : falseNegatives);
  } else {
    ++(detected ? falsePositives : trueNegatives);
  }
}

DetectionScore& DetectionScore::operator+=(const DetectionScore& other) {
  truePositives += other.truePositives;
  falsePositives += other.falsePositives;
  falseNegatives += other.falseNegatives;
  trueNegatives += other.trueNegatives;
  return *this;
}

double DetectionScore::precision() const { return share(truePositives, falsePositives); }
double DetectionScore::recall() const { return share(truePositives, falseNegatives); }
double DetectionScore::spared() const { return share(trueNegatives, falsePositives); }
double DetectionScore::iou() const { return share(truePositives, falsePositives + falseNegatives); }

DetectionScore comparePixels(const cv::Mat& detected, const cv::Mat& truth) {
  CV_Assert(detected.type() == CV_8UC1 && truth.type() == CV_8UC1 && detected.size() == truth.size());
  const std::uint64_t allDetected = count(detected);
  const std::uint64_t allTrue = count(truth);
  DetectionScore score;
  score.truePositives = count((detected != 0) & (truth != 0));
  score.falsePositives = allDetected - score.truePositives;
  score.falseNegatives = allTrue - score.truePositives;
  score.trueNegatives = truth.total() - allTrue - score.falsePositives;
  return score;
}

}  // namespace wardslam::evaluation

#include "depth_decoder.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace wardslam::segmentation {
namespace {

/// Probabilities, one row per pixel of the scores and one column per class.
cv::Mat softmax(const cv::Mat& scores) {
  const int classes = scores.size[1];
  const cv::Mat planes(classes, scores.size[2] * scores.size[3], CV_32F, const_cast<float*>(scores.ptr<float>()));
  cv::Mat probabilities = planes.t();
  for (int i = 0; i < probabilities.rows; ++i) {
    auto* row = probabilities.ptr<float>(i);
    const float most = *std::max_element(row, row + classes);
    for (int c = 0; c < classes; ++c) row[c] -= most;
  }
  cv::exp(probabilities, probabilities);
  for (int i = 0; i < probabilities.rows; ++i) {
    auto* row = probabilities.ptr<float>(i);
    float sum = 0.0F;
    for (int c = 0; c < classes; ++c) sum += row[c];
    for (int c = 0; c < classes; ++c) row[c] = std::isfinite(sum) ? row[c] / sum : 0.0F;
  }
  return probabilities;
}

/// Where pixels of a long line lie between those of a short one.
struct Places {
  std::vector<int> first;
  std::vector<int> second;
  std::vector<float> share;  ///< Of the second.

  Places(int from, int to) {
    for (int i = 0; i < to; ++i) {
      const double at = std::clamp((i + 0.5) * from / to - 0.5, 0.0, from - 1.0);
      first.push_back(static_cast<int>(at));
      second.push_back(std::min(first.back() + 1, from - 1));
      share.push_back(static_cast<float>(at - first.back()));
    }
  }
};

int bestOf(const float* values, int count) {
  return static_cast<int>(std::max_element(values, values + count) - values);
}

/// Decides row by row of the picture.
class RowDecoder {
 public:
  RowDecoder(int classes, int person, const PersonThresholds& thresholds, Places columns, int nodes)
      : classes_(classes),
        person_(person),
        thresholds_(thresholds),
        columns_(std::move(columns)),
        row_(static_cast<std::size_t>(nodes) * static_cast<std::size_t>(classes)),
        best_(static_cast<std::size_t>(nodes)),
        here_(static_cast<std::size_t>(classes)) {}

  /// `above`, `below`: probabilities of the rows of scores that the row lies between, by pixel and class.
  void set(const float* above, const float* below, float shareBelow) {
    for (std::size_t i = 0; i < row_.size(); ++i) row_[i] = above[i] + shareBelow * (below[i] - above[i]);
    for (std::size_t i = 0; i < best_.size(); ++i) best_[i] = bestOf(node(static_cast<int>(i)), classes_);
  }

  void decode(const float* depth_m, std::uint8_t* indices, float* probability) {
    for (std::size_t u = 0; u < columns_.first.size(); ++u) {
      left_ = node(columns_.first[u]);
      right_ = node(columns_.second[u]);
      share_ = columns_.share[u];
      const int same = best_[static_cast<std::size_t>(columns_.first[u])];
      const bool isSame = same == best_[static_cast<std::size_t>(columns_.second[u])];
      const int chosen = choose(depth_m[u] > 0.0F, isSame ? same : -1);
      indices[u] = static_cast<std::uint8_t>(chosen);
      probability[u] = at(chosen);
    }
  }

 private:
  [[nodiscard]] const float* node(int i) const { return row_.data() + static_cast<std::ptrdiff_t>(i) * classes_; }
  [[nodiscard]] float at(int c) const { return left_[c] + share_ * (right_[c] - left_[c]); }

  /// `same`: the best class on both sides, which is the best in between as well; -1: they differ.
  int choose(bool isMeasured, int same) {
    if (person_ < 0) return same >= 0 ? same : bestOfHere();
    const auto threshold = static_cast<float>(isMeasured ? thresholds_.measured : thresholds_.unmeasured);
    if (at(person_) >= threshold) return person_;
    return same >= 0 && same != person_ ? same : bestOfHere();
  }

  int bestOfHere() {
    for (int c = 0; c < classes_; ++c) here_[static_cast<std::size_t>(c)] = at(c);
    if (person_ >= 0) here_[static_cast<std::size_t>(person_)] = -1.0F;
    return bestOf(here_.data(), classes_);
  }

  int classes_;
  int person_;
  PersonThresholds thresholds_;
  Places columns_;
  std::vector<float> row_;
  std::vector<int> best_;
  std::vector<float> here_;
  const float* left_ = nullptr;
  const float* right_ = nullptr;
  float share_ = 0.0F;
};

}  // namespace

PixelClasses decodeDepthScores(const cv::Mat& scores, const cv::Mat& depth_m, int person,
                               const PersonThresholds& thresholds) {
  const int classes = scores.size[1];
  const int width = scores.size[3];
  const cv::Mat probabilities = softmax(scores);
  const Places rows(scores.size[2], depth_m.rows);
  RowDecoder decoder(classes, person, thresholds, Places(width, depth_m.cols), width);
  PixelClasses result{cv::Mat(depth_m.size(), CV_8UC1), cv::Mat(depth_m.size(), CV_32FC1)};
  for (int v = 0; v < depth_m.rows; ++v) {
    const auto i = static_cast<std::size_t>(v);
    decoder.set(probabilities.ptr<float>(rows.first[i] * width), probabilities.ptr<float>(rows.second[i] * width),
                rows.share[i]);
    decoder.decode(depth_m.ptr<float>(v), result.indices.ptr<std::uint8_t>(v), result.probability.ptr<float>(v));
  }
  return result;
}

}  // namespace wardslam::segmentation

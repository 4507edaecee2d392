#include "depth_surfaces.h"

#include <algorithm>
#include <vector>

namespace wardslam::masks {
namespace {

/// Labels known to be the same surface, with the smallest as representative.
class Equivalences {
 public:
  int add() {
    parent_.push_back(static_cast<int>(parent_.size()));
    return parent_.back();
  }

  void unite(int a, int b) {
    const int first = find(a);
    const int second = find(b);
    at(std::max(first, second)) = std::min(first, second);
  }

  /// Of every label the number of its class, in order of first appearance.
  std::vector<int> numbered(int& count) {
    std::vector<int> numbers(parent_.size());
    count = 0;
    for (int i = 0; i < static_cast<int>(parent_.size()); ++i) {
      const int root = find(i);
      numbers[static_cast<std::size_t>(i)] = root == i ? count++ : numbers[static_cast<std::size_t>(root)];
    }
    return numbers;
  }

 private:
  int find(int i) {
    while (at(i) != i) i = at(i) = at(at(i));
    return i;
  }
  int& at(int i) { return parent_[static_cast<std::size_t>(i)]; }

  std::vector<int> parent_;
};

}  // namespace

cv::Mat inverseDepth(const cv::Mat& depth_m) {
  cv::Mat inverse(depth_m.size(), CV_32FC1);
  for (int y = 0; y < depth_m.rows; ++y) {
    const auto* z = depth_m.ptr<float>(y);
    auto* w = inverse.ptr<float>(y);
    for (int x = 0; x < depth_m.cols; ++x) w[x] = z[x] > 0 ? 1.0F / z[x] : 0.0F;
  }
  return inverse;
}

Surfaces findSurfaces(const cv::Mat& inverseDepth, const cv::Mat& parts, const core::DepthNoise& noise) {
  Surfaces surfaces;
  surfaces.labels = cv::Mat(inverseDepth.size(), CV_32SC1, cv::Scalar(0));
  Equivalences same;
  same.add();  // 0: not measured
  for (int y = 0; y < inverseDepth.rows; ++y) {
    const int above = std::max(y - 1, 0);
    const auto* w = inverseDepth.ptr<float>(y);
    const auto* wAbove = inverseDepth.ptr<float>(above);
    const auto* part = parts.ptr<std::uint8_t>(y);
    const auto* partAbove = parts.ptr<std::uint8_t>(above);
    auto* label = surfaces.labels.ptr<int>(y);
    const auto* labelAbove = surfaces.labels.ptr<int>(above);
    for (int x = 0; x < inverseDepth.cols; ++x) {
      if (!(w[x] > 0)) continue;
      if (x > 0 && part[x] == part[x - 1] && isContinuous(w[x], w[x - 1], noise)) label[x] = label[x - 1];
      if (y > 0 && part[x] == partAbove[x] && isContinuous(w[x], wAbove[x], noise)) {
        if (label[x] == 0) label[x] = labelAbove[x];
        if (label[x] != labelAbove[x]) same.unite(label[x], labelAbove[x]);
      }
      if (label[x] == 0) label[x] = same.add();
    }
  }
  const std::vector<int> numbers = same.numbered(surfaces.count);
  for (int y = 0; y < surfaces.labels.rows; ++y) {
    auto* label = surfaces.labels.ptr<int>(y);
    for (int x = 0; x < surfaces.labels.cols; ++x) label[x] = numbers[static_cast<std::size_t>(label[x])];
  }
  return surfaces;
}

}  // namespace wardslam::masks

#pragma once

#include <utility>
#include <vector>

#include "wardslam/segmentation/network.h"

namespace wardslam::test {

/// What a FakeNetwork shows of itself; outlives it.
struct FakeNetworkState {
  std::vector<cv::Mat> outputs;  ///< Whatever the input.
  bool fails = false;
  cv::Mat lastBlob;
};

class FakeNetwork : public segmentation::Network {
 public:
  explicit FakeNetwork(FakeNetworkState& state) : state_(state) {}

  std::vector<cv::Mat> infer(const cv::Mat& blob) override {
    state_.lastBlob = blob.clone();
    if (state_.fails) throw segmentation::NetworkError("is out of order");
    return state_.outputs;
  }

 private:
  FakeNetworkState& state_;
};

/// Tensor of zeros.
inline cv::Mat tensor(const std::vector<int>& shape) { return {shape, CV_32F, cv::Scalar(0)}; }

/// The number of an element of a blob [1, channels, height, width].
inline float blobAt(const cv::Mat& blob, int channel, int y, int x) {
  return blob.at<float>(cv::Vec4i(0, channel, y, x));
}

}  // namespace wardslam::test

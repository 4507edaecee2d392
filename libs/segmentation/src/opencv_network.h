#pragma once

#include <opencv2/dnn.hpp>
#include <string>
#include <vector>

#include "wardslam/segmentation/network.h"

namespace wardslam::segmentation {

/// A network on OpenCV's dnn module, on the CPU.
class OpenCvNetwork : public Network {
 public:
  /// `model`, `graph`: bytes of the files. Throws core::InputError.
  OpenCvNetwork(const NetworkSource& source, const std::string& model, const std::string& graph = {});

  [[nodiscard]] std::vector<cv::Mat> infer(const cv::Mat& blob) override;

 private:
  cv::dnn::Net net_;
  std::vector<cv::String> outputs_;
};

}  // namespace wardslam::segmentation

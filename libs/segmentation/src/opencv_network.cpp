#include "opencv_network.h"

#include <algorithm>
#include <opencv2/core/utils/logger.hpp>
#include <regex>

#include "wardslam/core/errors.h"

namespace wardslam::segmentation {
namespace {

/// cv::dnn logs what it throws; the exception says it already.
class SilentOpenCv {
 public:
  SilentOpenCv() : before_(cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT)) {}
  ~SilentOpenCv() { cv::utils::logging::setLogLevel(before_); }
  SilentOpenCv(const SilentOpenCv&) = delete;
  SilentOpenCv& operator=(const SilentOpenCv&) = delete;

 private:
  cv::utils::logging::LogLevel before_;
};

bool isTensorFlow(const NetworkSource& source) { return source.model.extension() == ".pb"; }

std::string explainLoadFailure(const cv::Exception& error, const NetworkSource& source) {
  const std::string message = error.what();
  for (const char* damage : {"Failed to parse", "has_graph", "netBinSize"}) {
    if (message.find(damage) == std::string::npos) continue;
    return isTensorFlow(source) ? "not a complete TensorFlow graph, or its description is; download both again"
                                : "not a complete ONNX file; download or export it again";
  }
  std::smatch node;
  const std::regex inMessage(R"(Node \[([^@\]]+)[^\]]*\]:\((?:onnx_node!)?([^)]*)\))");
  const bool isKnown = std::regex_search(message, node, inMessage);
  const std::string what =
      isKnown ? "its operation " + node[1].str() + " (" + node[2].str() + ")" : "it (" + error.err + ")";
  return "OpenCV " CV_VERSION " cannot load " + what + source.advice;
}

cv::dnn::Net load(const NetworkSource& source, const std::string& model, const std::string& graph) {
  const SilentOpenCv silence;
  try {
    return isTensorFlow(source) ? cv::dnn::readNetFromTensorflow(model.data(), model.size(), graph.data(), graph.size())
                                : cv::dnn::readNetFromONNX(model.data(), model.size());
  } catch (const cv::Exception& error) {
    throw core::InputError(source.model.string() + ": " + explainLoadFailure(error, source));
  }
}

}  // namespace

OpenCvNetwork::OpenCvNetwork(const NetworkSource& source, const std::string& model, const std::string& graph)
    : net_(load(source, model, graph)), outputs_(source.outputs.begin(), source.outputs.end()) {
  const auto layers = net_.getLayerNames();
  for (const auto& output : outputs_) {
    if (std::find(layers.begin(), layers.end(), output) != layers.end()) continue;
    throw core::InputError(source.model.string() + ": has no output '" + output + "'" + source.advice);
  }
  if (outputs_.empty()) outputs_ = net_.getUnconnectedOutLayersNames();
}

std::vector<cv::Mat> OpenCvNetwork::infer(const cv::Mat& blob) {
  const SilentOpenCv silence;
  try {
    net_.setInput(blob);
    std::vector<cv::Mat> outputs;
    net_.forward(outputs, outputs_);
    for (auto& output : outputs) {
      if (output.depth() != CV_32F) output.convertTo(output, CV_32F);
    }
    return outputs;
  } catch (const cv::Exception& error) {
    throw NetworkError("OpenCV " CV_VERSION " cannot run it (" + error.err + ")");
  }
}

}  // namespace wardslam::segmentation

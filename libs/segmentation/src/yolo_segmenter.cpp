#include "wardslam/segmentation/yolo_segmenter.h"

#include <fstream>
#include <iterator>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/dnn.hpp>
#include <regex>

#include "wardslam/core/errors.h"
#include "wardslam/segmentation/onnx_file.h"

namespace wardslam::segmentation {
namespace {

namespace fs = std::filesystem;

constexpr int kCocoClasses = 80;
constexpr std::int64_t kMaxInput_px = 8192;

[[noreturn]] void fail(const fs::path& file, const std::string& what) {
  throw core::InputError(file.string() + ": " + what);
}

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

std::string readBytes(const fs::path& file) {
  if (file.empty()) throw core::InputError("a YOLO network needs its ONNX file (yolo.model)");
  std::ifstream in(file, std::ios::binary);
  if (!in || fs::is_directory(file))
    fail(file, "cannot be opened for reading; give the ONNX file of a YOLO-seg network");
  return {std::istreambuf_iterator<char>(in), {}};
}

constexpr const char* kAdvice =
    "; official YOLOv8-seg exports need OpenCV 4.7 or newer and opset=12, YOLOv5-seg exports (export.py --include onnx "
    "--opset 12) run on OpenCV 4.6 too";

std::string explainLoadFailure(const cv::Exception& error) {
  const std::string message = error.what();
  for (const char* damage : {"Failed to parse", "has_graph"}) {
    if (message.find(damage) != std::string::npos) return "not a complete ONNX file; download or export it again";
  }
  std::smatch node;
  const std::regex inMessage(R"(Node \[([^@\]]+)[^\]]*\]:\((?:onnx_node!)?([^)]*)\))");
  const bool isKnown = std::regex_search(message, node, inMessage);
  const std::string what =
      isKnown ? "its operation " + node[1].str() + " (" + node[2].str() + ")" : "it (" + error.err + ")";
  return "OpenCV " CV_VERSION " cannot load " + what + kAdvice;
}

cv::dnn::Net loadNet(const fs::path& file, const std::string& bytes) {
  const SilentOpenCv silence;
  try {
    return cv::dnn::readNetFromONNX(bytes.data(), bytes.size());
  } catch (const cv::Exception& error) {
    fail(file, explainLoadFailure(error));
  }
}

cv::Size readInputSize(const fs::path& file, const std::string& bytes) {
  const auto shape = onnxImageInput(bytes);
  if (!shape) fail(file, "takes no image of three channels; give a YOLO-seg network");
  const std::int64_t height = (*shape)[2];
  const std::int64_t width = (*shape)[3];
  if (std::min(height, width) < 1 || std::max(height, width) > kMaxInput_px) {
    fail(file, "leaves the size of its input open; export it with a fixed one (imgsz=256,320 dynamic=False)");
  }
  return {static_cast<int>(width), static_cast<int>(height)};
}

std::vector<int> shapeOf(const cv::Mat& tensor) { return {tensor.size.p, tensor.size.p + tensor.dims}; }

std::string shapesText(const std::vector<cv::Mat>& tensors) {
  std::string text;
  for (const auto& tensor : tensors) {
    text += text.empty() ? "[" : ", [";
    for (int i = 0; i < tensor.dims; ++i) text += (i > 0 ? "," : "") + std::to_string(tensor.size[i]);
    text += "]";
  }
  return text;
}

}  // namespace

class YoloSegmenter::Network {
 public:
  struct Output {
    cv::Mat detections;
    cv::Mat prototypes;
  };

  explicit Network(const fs::path& file) {
    const std::string bytes = readBytes(file);
    net_ = loadNet(file, bytes);
    input_px_ = readInputSize(file, bytes);
    names_ = net_.getUnconnectedOutLayersNames();
    layout_ = findLayout(file);
  }

  // The tensors are valid until the next call.
  [[nodiscard]] Output run(const cv::Mat& input_bgr) {
    const auto outputs = forward(input_bgr);
    return {outputs[detectionsIndex_], outputs[1 - detectionsIndex_]};
  }

  [[nodiscard]] const cv::Size& input_px() const { return input_px_; }
  [[nodiscard]] const YoloLayout& layout() const { return layout_; }

 private:
  std::vector<cv::Mat> forward(const cv::Mat& input_bgr) {
    constexpr bool kSwapToRgb = true;
    net_.setInput(cv::dnn::blobFromImage(input_bgr, 1.0 / 255.0, {}, {}, kSwapToRgb));
    std::vector<cv::Mat> outputs;
    net_.forward(outputs, names_);
    return outputs;
  }

  // By running it: the shapes a file declares are optional, those that come out count.
  YoloLayout findLayout(const fs::path& file) {
    std::vector<cv::Mat> outputs;
    try {
      const SilentOpenCv silence;
      outputs = forward(cv::Mat(input_px_, CV_8UC3, cv::Scalar::all(0)));
    } catch (const cv::Exception& error) {
      fail(file, "OpenCV " CV_VERSION " cannot run it (" + error.err + ")" + kAdvice);
    }
    if (outputs.size() == 2) {
      detectionsIndex_ = outputs[0].dims == 3 ? 0 : 1;
      const auto layout =
          YoloLayout::fromShapes(shapeOf(outputs[detectionsIndex_]), shapeOf(outputs[1 - detectionsIndex_]));
      if (layout) return *layout;
    }
    fail(file, "its outputs " + shapesText(outputs) +
                   " are not those of a YOLO-seg network (detections and mask prototypes); give a segmentation model "
                   "such as yolov8n-seg or yolov5n-seg");
  }

  cv::dnn::Net net_;
  cv::Size input_px_;
  std::vector<cv::String> names_;
  std::size_t detectionsIndex_ = 0;
  YoloLayout layout_;
};

YoloSegmenter::YoloSegmenter(const YoloOptions& options, const fs::path& classesFile)
    : options_(options.decoder),
      network_(std::make_unique<Network>(options.model)),
      labelSpace_(classesFile.empty() ? core::LabelSpace::coco() : core::LabelSpace::cocoWith(classesFile)) {
  const int classes = network_->layout().classes;
  if (classes != kCocoClasses && classesFile.empty()) {
    fail(options.model, "knows " + std::to_string(classes) +
                            " classes, which are not COCO's 80; name them in a file (segmentation.classes)");
  }
}

YoloSegmenter::~YoloSegmenter() = default;

cv::Size YoloSegmenter::inputSize_px() const { return network_->input_px(); }

Segmenter::Result YoloSegmenter::segment(const cv::Mat& color_bgr, double /*stamp_s*/) {
  try {
    const Letterbox letterbox(color_bgr.size(), network_->input_px());
    const auto [detections, prototypes] = network_->run(letterbox.apply(color_bgr));
    return {decodeYolo(detections, prototypes, network_->layout(), letterbox, options_), {}};
  } catch (const cv::Exception&) {
    return {{}, {{"segmentation.network_failed", 1}}};
  }
}

}  // namespace wardslam::segmentation

#include "wardslam/segmentation/network.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string_view>

#include "class_names.h"
#include "onnx_file.h"
#include "onnxruntime_network.h"
#include "opencv_network.h"
#include "wardslam/core/errors.h"

namespace wardslam::segmentation {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kMaxInput_px = 8192;

[[noreturn]] void fail(const fs::path& file, const std::string& what) {
  throw core::InputError(file.string() + ": " + what);
}

/// `wanted`: what the file should be, for the error message.
std::string readBytes(const fs::path& file, const std::string& wanted) {
  std::ifstream in(file, std::ios::binary);
  if (!in || fs::is_directory(file)) fail(file, "cannot be opened for reading; give " + wanted);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string readModel(const NetworkSource& source) {
  if (source.model.empty()) throw core::InputError("a " + source.kind + " network needs its file (" + source.key + ")");
  return readBytes(source.model, "the file of a " + source.kind + " network");
}

/// Empty where the file leaves it open.
cv::Size onnxInputSize(const NetworkSource& source, std::string_view bytes) {
  const auto shape = onnxImageInput(bytes, source.channels);
  const std::string channels = source.channels == 3 ? "three" : std::to_string(source.channels);
  if (!shape) fail(source.model, "takes no image of " + channels + " channels; give a " + source.kind + " network");
  const std::int64_t height = (*shape)[2];
  const std::int64_t width = (*shape)[3];
  if (std::min(height, width) < 1 || std::max(height, width) > kMaxInput_px) return {};
  return {static_cast<int>(width), static_cast<int>(height)};
}

/// Networks in the files of other libraries, by their first bytes.
void refuseOtherFormats(const NetworkSource& source, std::string_view bytes) {
  const auto startsWith = [&](std::string_view mark) { return bytes.substr(0, mark.size()) == mark; };
  if (startsWith("PK\x03\x04")) {
    fail(source.model,
         "is an archive, as PyTorch writes networks; export it as ONNX (with Ultralytics: yolo export model=" +
             source.model.filename().string() + " format=onnx opset=12)");
  }
  const char* const library = startsWith("ftrt")                                 ? "TensorRT"
                              : startsWith("<?xml")                              ? "OpenVINO"
                              : bytes.size() > 8 && bytes.substr(4, 4) == "TFL3" ? "TensorFlow Lite"
                                                                                 : nullptr;
  if (library == nullptr) return;
  fail(source.model, std::string("is a file for ") + library + "; export the network it was made of as ONNX");
}

/// What no library could run, said in other words than a library's.
void refuseUnfitOnnx(const NetworkSource& source, std::string_view bytes) {
  if (takesHalfFloats(bytes)) fail(source.model, "takes 16-bit floating-point numbers; export it with half=False");
  const auto shape = onnxImageInput(bytes, source.channels);
  if (source.needsFixedInput && shape && std::min((*shape)[2], (*shape)[3]) < 1) {
    fail(source.model, "leaves the size of its input open; export it with a fixed one (imgsz=256,320 dynamic=False)");
  }
}

OpenedNetwork openOnnx(NetworkSource source) {
  const std::string bytes = readModel(source);
  refuseOtherFormats(source, bytes);
  refuseUnfitOnnx(source, bytes);
  if (source.outputs.empty()) source.outputs = onnxOutputs(bytes);
  OpenedNetwork opened;
  if constexpr (hasOnnxRuntime()) {
    if (source.backend == Backend::OnnxRuntime) opened.network = makeOnnxRuntimeNetwork(source, bytes);
  }
  if (!opened.network) opened.network = std::make_unique<OpenCvNetwork>(source, bytes);
  opened.input_px = onnxInputSize(source, bytes);
  const auto metadata = onnxMetadata(bytes);
  if (const auto names = metadata.find("names"); names != metadata.end()) {
    opened.classNames = parseClassNames(names->second);
  }
  return opened;
}

OpenedNetwork openTensorFlow(const NetworkSource& source) {
  if (source.backend != Backend::OpenCv) {
    fail(source.model, "ONNX Runtime runs ONNX files only; set segmentation.backend to opencv");
  }
  const std::string bytes = readModel(source);
  const auto graph =
      source.graph.empty() ? "" : readBytes(source.graph, "OpenCV's description (.pbtxt) of " + source.model.string());
  return {std::make_unique<OpenCvNetwork>(source, bytes, graph), {}};
}

}  // namespace

OpenedNetwork openNetwork(const NetworkSource& source) {
  if (source.backend == Backend::OnnxRuntime && !hasOnnxRuntime()) {
    throw core::InputError(
        "this build has no ONNX Runtime; set segmentation.backend to opencv, or build with "
        "-D WARDSLAM_ONNXRUNTIME_ROOT=<folder of ONNX Runtime>");
  }
  return source.model.extension() == ".pb" ? openTensorFlow(source) : openOnnx(source);
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

std::vector<cv::Mat> tryNetwork(Network& network, const cv::Mat& blob, const NetworkSource& source) {
  try {
    return network.infer(blob);
  } catch (const NetworkError& error) {
    fail(source.model, error.what() + source.advice);
  }
}

}  // namespace wardslam::segmentation

#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace wardslam::segmentation {

/// Which library runs a network: OpenCV's dnn module, or ONNX Runtime where the build found it.
enum class Backend : std::uint8_t { OpenCv, OnnxRuntime };

/// A network cannot be run on this input; says why in part of a sentence.
class NetworkError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A network that is loaded, whichever library runs it: same tensors in, same tensors out. Not thread-safe.
class Network {
 public:
  virtual ~Network() = default;

  /// `blob`: CV_32F [1, channels, height, width]. The outputs, all CV_32F, in the order asked for at opening; valid
  /// until the next call. Throws NetworkError.
  [[nodiscard]] virtual std::vector<cv::Mat> infer(const cv::Mat& blob) = 0;
};

/// Where a network comes from and what is wanted of it.
struct NetworkSource {
  std::filesystem::path model;       ///< ONNX file, or TensorFlow frozen graph (.pb).
  std::filesystem::path graph;       ///< OpenCV's description (.pbtxt) of a frozen graph; empty: none needed.
  std::vector<std::string> outputs;  ///< Names; empty: all, in the order of the file.
  Backend backend = Backend::OpenCv;
  int channels = 3;              ///< Of the image that it must take.
  std::string kind;              ///< For error messages: "YOLO-seg".
  std::string key;               ///< For error messages: the option that names the model, "yolo.model".
  std::string advice;            ///< For error messages: what to do when the library cannot load it; may be empty.
  bool needsFixedInput = false;  ///< A file that leaves the size of its input open is refused.
};

struct OpenedNetwork {
  std::unique_ptr<Network> network;
  cv::Size input_px;  ///< As the file declares it; 0x0 where that is left open or not told (TensorFlow).
  std::vector<std::string> classNames = {};  ///< By class index, as the file brings them; mostly empty.
};

/// Throws core::InputError when a file is missing, damaged, not one the library can load, or takes no image of so many
/// channels; or when the backend is not part of this build.
[[nodiscard]] OpenedNetwork openNetwork(const NetworkSource& source);

/// Of a tensor with any number of dimensions.
[[nodiscard]] std::vector<int> shapeOf(const cv::Mat& tensor);

/// "[1,116,1680], [1,32,64,80]"
[[nodiscard]] std::string shapesText(const std::vector<cv::Mat>& tensors);

/// infer() during set-up, to see what comes out. Throws core::InputError in place of NetworkError.
[[nodiscard]] std::vector<cv::Mat> tryNetwork(Network& network, const cv::Mat& blob, const NetworkSource& source);

}  // namespace wardslam::segmentation

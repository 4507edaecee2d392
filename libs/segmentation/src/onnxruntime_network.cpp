#include "onnxruntime_network.h"

#include <onnxruntime_cxx_api.h>

#include <algorithm>
#include <cstdint>
#include <iostream>
#include <mutex>
#include <vector>

#include "repeated_schema_filter.h"
#include "wardslam/core/errors.h"

namespace wardslam::segmentation {
namespace {

/// `type`: of the OpenCV matrix that holds numbers of type T.
template <class T>
cv::Mat toFloat(const Ort::Value& value, const std::vector<int>& shape, int type) {
  cv::Mat tensor;
  const cv::Mat view(shape, type, const_cast<T*>(value.GetTensorData<T>()));
  view.convertTo(tensor, CV_32F);
  return tensor;
}

/// Class maps come as 64-bit numbers, which cv::Mat has no type for.
cv::Mat fromInt64(const Ort::Value& value, const std::vector<int>& shape) {
  cv::Mat tensor(shape, CV_32F);
  const auto* numbers = value.GetTensorData<std::int64_t>();
  std::transform(numbers, numbers + tensor.total(), tensor.ptr<float>(),
                 [](std::int64_t number) { return static_cast<float>(number); });
  return tensor;
}

cv::Mat toTensor(const Ort::Value& value) {
  const auto info = value.GetTensorTypeAndShapeInfo();
  const auto sizes = info.GetShape();
  const std::vector<int> shape(sizes.begin(), sizes.end());
  switch (info.GetElementType()) {
    case ONNX_TENSOR_ELEMENT_DATA_TYPE_FLOAT:
      return toFloat<float>(value, shape, CV_32F);
    case ONNX_TENSOR_ELEMENT_DATA_TYPE_INT32:
      return toFloat<std::int32_t>(value, shape, CV_32S);
    case ONNX_TENSOR_ELEMENT_DATA_TYPE_UINT8:
      return toFloat<std::uint8_t>(value, shape, CV_8U);
    case ONNX_TENSOR_ELEMENT_DATA_TYPE_INT64:
      return fromInt64(value, shape);
    default:
      throw NetworkError("puts out numbers of a type that is not supported (float, int32, int64 and uint8 are)");
  }
}

/// The first session of a process registers the operators again, not without noise (repeated_schema_filter.h).
Ort::Session openSession(const Ort::Env& environment, const std::string& bytes) {
  static std::mutex oneAtATime;
  const std::lock_guard<std::mutex> lock(oneAtATime);
  static RepeatedSchemaFilter filter(*std::cerr.rdbuf());
  const FilterGuard guard(filter);
  return {environment, bytes.data(), bytes.size(), Ort::SessionOptions()};
}

class OnnxRuntimeNetwork : public Network {
 public:
  OnnxRuntimeNetwork(const NetworkSource& source, const std::string& bytes)
      : session_(openSession(environment_, bytes)), outputs_(source.outputs) {
    const Ort::AllocatorWithDefaultOptions allocator;
    input_ = session_.GetInputNameAllocated(0, allocator).get();
  }

  [[nodiscard]] std::vector<cv::Mat> infer(const cv::Mat& blob) override {
    try {
      return run(blob);
    } catch (const Ort::Exception& error) {
      throw NetworkError(std::string("ONNX Runtime cannot run it (") + error.what() + ")");
    }
  }

 private:
  std::vector<cv::Mat> run(const cv::Mat& blob) {
    const std::vector<std::int64_t> shape(blob.size.p, blob.size.p + blob.dims);
    const auto memory = Ort::MemoryInfo::CreateCpu(OrtArenaAllocator, OrtMemTypeDefault);
    const auto input = Ort::Value::CreateTensor<float>(memory, const_cast<float*>(blob.ptr<float>()), blob.total(),
                                                       shape.data(), shape.size());
    std::vector<const char*> outputNames;
    for (const auto& output : outputs_) outputNames.push_back(output.c_str());
    const char* inputName = input_.c_str();
    std::vector<cv::Mat> tensors;
    for (const auto& value :
         session_.Run(Ort::RunOptions{nullptr}, &inputName, &input, 1, outputNames.data(), outputNames.size())) {
      tensors.push_back(toTensor(value));
    }
    return tensors;
  }

  Ort::Env environment_{ORT_LOGGING_LEVEL_ERROR, "wardslam"};
  Ort::Session session_;
  std::string input_;
  std::vector<std::string> outputs_;
};

}  // namespace

std::unique_ptr<Network> makeOnnxRuntimeNetwork(const NetworkSource& source, const std::string& bytes) {
  try {
    return std::make_unique<OnnxRuntimeNetwork>(source, bytes);
  } catch (const Ort::Exception& error) {
    throw core::InputError(source.model.string() + ": ONNX Runtime cannot load it (" + error.what() + ")");
  }
}

}  // namespace wardslam::segmentation

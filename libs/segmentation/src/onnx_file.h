#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wardslam::segmentation {

/// Shape of the first image-like ([batch, channels, height, width]) input of so many channels that an ONNX file
/// declares; a dimension the file leaves open is 0. cv::dnn knows it, but does not tell. Empty when there is none or
/// the bytes are not ONNX.
///
/// Walks the protobuf message ModelProto by its field numbers, see onnx.proto: no more of it is needed here.
[[nodiscard]] std::optional<std::vector<std::int64_t>> onnxImageInput(std::string_view bytes, int channels = 3);

/// Names of the outputs that an ONNX file declares, in its order, which cv::dnn does not keep. Empty when the bytes are
/// not ONNX.
[[nodiscard]] std::vector<std::string> onnxOutputs(std::string_view bytes);

/// Shapes of the outputs that an ONNX file declares, in its order; an open dimension is 0.
[[nodiscard]] std::vector<std::vector<std::int64_t>> onnxOutputShapes(std::string_view bytes);

/// What the writer of an ONNX file noted, by key ("names", "stride"). Empty when the bytes are not ONNX.
[[nodiscard]] std::map<std::string, std::string> onnxMetadata(std::string_view bytes);

/// Whether the image that it takes is to be of 16-bit floating-point numbers.
[[nodiscard]] bool takesHalfFloats(std::string_view bytes);

}  // namespace wardslam::segmentation

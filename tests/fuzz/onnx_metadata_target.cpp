#include "fuzz_input.h"
#include "onnx_file.h"

// What a network's file says of itself.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  (void)wardslam::segmentation::onnxImageInput(bytes);
  (void)wardslam::segmentation::onnxImageInput(bytes, 1);
  (void)wardslam::segmentation::onnxOutputs(bytes);
  (void)wardslam::segmentation::onnxOutputShapes(bytes);
  (void)wardslam::segmentation::onnxMetadata(bytes);
  (void)wardslam::segmentation::takesHalfFloats(bytes);
  return 0;
}

#pragma once

#include <memory>
#include <string>

#include "wardslam/segmentation/network.h"

namespace wardslam::segmentation {

/// Whether ONNX Runtime was there at build time.
[[nodiscard]] constexpr bool hasOnnxRuntime() {
#ifdef WARDSLAM_WITH_ONNXRUNTIME
  return true;
#else
  return false;
#endif
}

/// A network on ONNX Runtime, on the CPU. `bytes`: of the ONNX file. Throws core::InputError.
/// Defined only where hasOnnxRuntime().
[[nodiscard]] std::unique_ptr<Network> makeOnnxRuntimeNetwork(const NetworkSource& source, const std::string& bytes);

}  // namespace wardslam::segmentation

#pragma once

#include <cstddef>

#include "output/sequence_writer.h"
#include "places/place.h"
#include "rendering/renderer.h"
#include "synthesis/synthesis.h"

namespace wardslam::synth {

/// Takes the pictures of a sequence. Each depends on its number alone, so that any number of threads can share the
/// work of one camera.
class RecordingCamera {
 public:
  /// Keeps references. Throws core::InputError when nothing can be rendered.
  RecordingCamera(const Setting& setting, const SynthesisOptions& options);

  [[nodiscard]] SequenceFrame shoot(std::size_t index) const;

 private:
  [[nodiscard]] cv::Mat smeared(double t_s, const Eigen::Isometry3d& T_cam_eye) const;
  [[nodiscard]] cv::Mat measured(const Rendering& rendering, double coveredShare, std::uint64_t seed) const;

  const Setting& setting_;
  const SynthesisOptions& options_;
  core::CameraModel model_;
  Renderer renderer_;
};

}  // namespace wardslam::synth

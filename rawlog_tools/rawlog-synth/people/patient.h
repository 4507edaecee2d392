#pragma once

#include <opencv2/core.hpp>

#include "scene/scene.h"

namespace wardslam::synth {

/// Who lies in a bed of makeBed(): head on the pillow, arms on the blanket. In the bed's frame.
[[nodiscard]] Surfaces makePatient(int variant);
/// What such a bed's blanket then looks like, in addition.
[[nodiscard]] Surfaces makeCoveredBody(cv::RNG& rng);

}  // namespace wardslam::synth

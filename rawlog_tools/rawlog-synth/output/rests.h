#pragma once

#include <string>

#include "scene/scene.h"

namespace wardslam::synth {

/// rests.csv: every place where something that is moved at times stood until `until_s`, in order of instance and time.
/// Columns: instance_id, name, class_id, class_name, from_s, until_s (empty: it stands there still), then centre and
/// bounds in the world frame as in objects.csv. Seconds after the start, metres.
[[nodiscard]] std::string restsText(const Scene& scene, double until_s);

}  // namespace wardslam::synth

#pragma once

#include <string>

#include "wardslam/pipeline/slam_options.h"

namespace mrpt::config {
class CConfigFileBase;
}

namespace wardslam::pipeline {

/// Options from a section of an `.ini` file, as MRPT programs have them:
///
///     [WardSLAM]
///     config = wardslam.yaml            ; optional; the keys below overrule it
///     features.key_points = 1500        ; any option by its path in the YAML
///     zones.file = zones.yaml
///
/// Filters are configured in the YAML file; `rawlog-grabber-ignore` is passed over. A relative `config` lies beside the
/// `.ini` file. Throws core::InputError naming section and key.
[[nodiscard]] SlamOptions readSlamOptions(const mrpt::config::CConfigFileBase& ini, const std::string& section);

}  // namespace wardslam::pipeline

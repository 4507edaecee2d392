#pragma once

#include <memory>

#include "wardslam/mapping/semantic_map.h"

namespace mrpt::opengl {
class CBox;
class CPointCloudColoured;
class CText;
}  // namespace mrpt::opengl

/// Parts of a map as MRPT draws them, in the map frame.
namespace wardslam::exchange {

/// Of the points of a cloud: as the camera saw them, or that of their class, grey where they have none.
enum class CloudColor { Image, Class };

/// Named "cloud".
[[nodiscard]] std::shared_ptr<mrpt::opengl::CPointCloudColoured> drawCloud(const mapping::SemanticMap& map,
                                                                           CloudColor color = CloudColor::Image,
                                                                           float pointSize_px = 2.0F);

/// The outline of the oriented box, in the colour of the class; named "object ID".
[[nodiscard]] std::shared_ptr<mrpt::opengl::CBox> drawBox(const mapping::MapObject& object);

/// Its class and id, above it.
[[nodiscard]] std::shared_ptr<mrpt::opengl::CText> drawName(const mapping::MapObject& object,
                                                            const core::LabelSpace& labels);

}  // namespace wardslam::exchange

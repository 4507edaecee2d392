#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "wardslam/bags/bag_reader.h"
#include "wardslam/sources/bag_topics.h"
#include "wardslam/sources/observation_source.h"

namespace wardslam::sources {

/// The topics of a recording that an RGB-D camera and its robot are read from, by their index.
struct BagStreams {
  std::size_t color = 0;
  std::size_t depth = 0;
  std::optional<std::size_t> colorInfo;  ///< Nothing: there is none, and none is needed.
  std::optional<std::size_t> depthInfo;
  std::optional<std::size_t> odometry;
  std::vector<std::size_t> imus;
  std::vector<std::size_t> transforms;
  std::optional<std::size_t> colorPlace;  ///< Where RealSense's own recorder says that the cameras sit …
  std::optional<std::size_t> depthPlace;
  std::optional<std::size_t> depthUnit;  ///< … and what a unit of depth is.
};

/// Finds them by type, name and the encoding of the first image; a topic in `wishes` is taken as it is. Colour comes
/// before grey, depth that is registered to colour (by its name) before other, a topic of images before its compressed
/// twin. `note` hears of odometries that could not be chosen among. Throws ChoiceNeeded, and core::InputError where
/// there is none.
[[nodiscard]] BagStreams findStreams(bags::BagReader& bag, const BagTopics& wishes, bool needsInfo,
                                     const std::string& file, const NoteSink& note);

/// "/device_0/sensor_1/Color_0" of a topic of images of RealSense's own recorder (librealsense, RealSense Viewer),
/// which writes recordings by rules of its own; empty: of another.
[[nodiscard]] std::string realSenseStream(const std::string& imageTopic);

/// Whether the name of a depth topic says that its images are registered to the colour camera.
[[nodiscard]] bool isRegisteredByName(const std::string& depthTopic);

}  // namespace wardslam::sources

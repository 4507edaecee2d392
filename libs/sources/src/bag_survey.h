#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bag_streams.h"
#include "bag_transforms.h"
#include "wardslam/bags/bag_reader.h"
#include "wardslam/bags/messages.h"
#include "wardslam/sources/input_damage.h"

namespace wardslam::sources {

/// A message of a topic: when its content was measured, and where it stands.
struct BagMessage {
  double stamp_s = 0.0;
  std::size_t entry = 0;
};

/// What one reading of a recording tells before any image is unpacked.
struct BagSurvey {
  std::vector<BagMessage> colors;  ///< Each list in order of the stamps, without doubles.
  std::vector<BagMessage> depths;
  std::vector<BagMessage> odometries;
  std::vector<BagMessage> imus;
  std::vector<std::pair<std::size_t, std::size_t>> pairs;  ///< Indices into colors and depths.

  std::string colorFrame;
  std::string depthFrame;
  std::string robotFrame;  ///< As odometry calls it; empty: there is none.
  std::optional<bags::CameraInfo> colorInfo;
  std::optional<bags::CameraInfo> depthInfo;
  std::optional<double> depthUnit_m;  ///< Where the recording tells it.
  bool infoChanges = false;
  bool hasNoStamps = false;  ///< Images have no stamps: when they were recorded is taken.
  BagTransforms transforms;
};

/// "topic /camera/color/image_raw, message recorded at 1700000000.123456 s".
[[nodiscard]] std::string nameOf(const bags::BagReader& bag, std::size_t entry);

/// Reads through all that `streams` names, and associates colour and depth. `damage` gets what cannot be read. Throws
/// core::InputError where no image belongs to another.
[[nodiscard]] BagSurvey survey(bags::BagReader& bag, const BagStreams& streams, const std::string& file,
                               DamageLog& damage);

}  // namespace wardslam::sources

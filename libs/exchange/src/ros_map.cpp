#include "wardslam/exchange/ros_map.h"

#include <yaml-cpp/yaml.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "wardslam/core/errors.h"

// MRPT reads such files too, but moves the corner of the map to a multiple of its resolution.

namespace wardslam::exchange {
namespace {

using mapping::FloorPlan;

struct Thresholds {
  bool isNegated = false;
  double occupied = 0.65;
  double free = 0.196;
};

/// map_server's rule ("trinary"); its first row is the farthest along y.
cv::Mat cellsOf(const cv::Mat& image, const Thresholds& thresholds) {
  cv::Mat kinds(1, 256, CV_8UC1);
  for (int value = 0; value < 256; ++value) {
    const double occupied = (thresholds.isNegated ? value : 255 - value) / 255.0;
    kinds.at<unsigned char>(value) = occupied > thresholds.occupied ? FloorPlan::kOccupied
                                     : occupied < thresholds.free   ? FloorPlan::kFree
                                                                    : FloorPlan::kUnknown;
  }
  cv::Mat cells;
  cv::LUT(image, kinds, cells);
  cv::flip(cells, cells, 0);
  return cells;
}

FloorPlan planOf(const YAML::Node& yaml, const std::filesystem::path& file) {
  const auto origin = yaml["origin"].as<std::vector<double>>();
  if (origin.size() != 3) throw core::InputError(file.string() + ": origin must be [x, y, yaw]");
  if (origin[2] != 0.0) {
    throw core::InputError(file.string() + ": the map lies turned in its frame (origin, yaw); turn its image instead");
  }
  const auto imageFile = file.parent_path() / yaml["image"].as<std::string>();
  const cv::Mat image = cv::imread(imageFile.string(), cv::IMREAD_GRAYSCALE);
  if (image.empty()) throw core::InputError(imageFile.string() + ": cannot be read as the image of " + file.string());
  FloorPlan plan;
  plan.resolution_m = yaml["resolution"].as<double>();
  if (!(plan.resolution_m > 0.0)) throw core::InputError(file.string() + ": resolution must be above 0 m");
  plan.origin_m = {origin[0], origin[1]};
  plan.cells = cellsOf(image, {yaml["negate"].as<int>(0) != 0, yaml["occupied_thresh"].as<double>(0.65),
                               yaml["free_thresh"].as<double>(0.196)});
  return plan;
}

}  // namespace

FloorPlan readRosMap(const std::filesystem::path& file) {
  try {
    return planOf(YAML::LoadFile(file.string()), file);
  } catch (const YAML::Exception& error) {
    throw core::InputError(file.string() + ": is no map of ROS map_server (" + error.what() + ")");
  }
}

}  // namespace wardslam::exchange

#include "truth.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "wardslam/core/errors.h"
#include "wardslam/evaluation/absolute_trajectory_error.h"
#include "wardslam/exchange/tum_trajectory.h"

namespace wardslam::nav_demo {
namespace fs = std::filesystem;
namespace {

/// A floor plan as map_server has it, with the three values that exportRosMap() writes.
mapping::FloorPlan readRosMap(const fs::path& file) {
  if (!fs::exists(file))
    throw core::InputError(file.string() + ": is missing; rawlog-synth writes it beside the rawlog (make it anew)");
  mapping::FloorPlan plan;
  fs::path image;
  try {
    const YAML::Node yaml = YAML::LoadFile(file.string());
    plan.resolution_m = yaml["resolution"].as<double>();
    plan.origin_m = {yaml["origin"][0].as<double>(), yaml["origin"][1].as<double>()};
    image = file.parent_path() / yaml["image"].as<std::string>();
  } catch (const YAML::Exception& error) {
    throw core::InputError(file.string() + ": is no map for map_server: " + error.what());
  }
  const cv::Mat grey = cv::imread(image.string(), cv::IMREAD_GRAYSCALE);
  if (grey.empty()) throw core::InputError(image.string() + ": cannot be read as an image");
  constexpr int kFree = 254;
  constexpr int kOccupied = 0;
  plan.cells = cv::Mat(grey.size(), CV_8UC1, cv::Scalar(mapping::FloorPlan::kUnknown));
  plan.cells.setTo(mapping::FloorPlan::kFree, grey == kFree);
  plan.cells.setTo(mapping::FloorPlan::kOccupied, grey == kOccupied);
  cv::flip(plan.cells, plan.cells, 0);  // its first row is the farthest along y
  return plan;
}

std::vector<std::string> fieldsOf(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream text(line);
  for (std::string field; std::getline(text, field, ',');) fields.push_back(field);
  return fields;
}

std::vector<TrueThing> readThings(const fs::path& file) {
  std::ifstream in(file);
  if (!in) throw core::InputError(file.string() + ": cannot be read");
  std::string line;
  std::getline(in, line);
  std::map<std::string, std::size_t> column;
  for (const auto& name : fieldsOf(line)) column.emplace(name, column.size());
  std::vector<TrueThing> things;
  for (int number = 2; std::getline(in, line); ++number) {
    const auto fields = fieldsOf(line);
    try {
      const auto at = [&](const char* name) { return std::stod(fields.at(column.at(name))); };
      things.push_back(
          {fields.at(column.at("class_name")),
           Eigen::AlignedBox2d(Eigen::Vector2d(at("xmin"), at("ymin")), Eigen::Vector2d(at("xmax"), at("ymax")))});
    } catch (const std::logic_error&) {
      throw core::InputError(file.string() + ":" + std::to_string(number) +
                             ": columns class_name, xmin, ymin, xmax, ymax are needed");
    }
  }
  return things;
}

/// What a rigid motion in space does to the floor.
Eigen::Isometry2d onFloor(const Eigen::Isometry3d& T) {
  return Eigen::Translation2d(T.translation().head<2>()) * Eigen::Rotation2Dd(std::atan2(T(1, 0), T(0, 0)));
}

core::Trajectory keyframesOf(const mapping::SemanticMap& map) {
  core::Trajectory trajectory;
  for (const auto& [id, keyframe] : map.keyframes) trajectory.push_back({keyframe.stamp_s, keyframe.T_map_cam});
  std::sort(trajectory.begin(), trajectory.end(), [](const auto& a, const auto& b) { return a.stamp_s < b.stamp_s; });
  return trajectory;
}

}  // namespace

Truth readTruth(const fs::path& rawlog, const mapping::SemanticMap& map) {
  const fs::path stem = rawlog.parent_path() / rawlog.stem();
  const fs::path labels = stem.string() + "_labels";
  Truth truth;
  truth.floor = readRosMap(labels / "floor.yaml");
  truth.things = readThings(labels / "objects.csv");
  const auto groundTruth = exchange::readTumTrajectory(stem.string() + ".groundtruth.txt");
  const auto alignment = evaluation::absoluteTrajectoryError(groundTruth, keyframesOf(map));
  truth.T_world_map = onFloor(alignment.T_groundtruth_estimate);
  truth.mapError_m = alignment.translation_m.rmse;
  truth.source = "the scene that " + rawlog.filename().string() + " was rendered from";
  return truth;
}

Truth truthFromMap(const mapping::SemanticMap& map) {
  Truth truth;
  truth.floor = map.floorPlan;
  for (const auto& [id, object] : map.objects) {
    if (object.state == mapping::ObjectState::Gone) continue;
    truth.things.push_back(
        {map.labels.name(object.classId), Eigen::AlignedBox2d(Eigen::Vector2d(object.box_m.min().head<2>()),
                                                              Eigen::Vector2d(object.box_m.max().head<2>()))});
  }
  truth.source = "the map itself (no --truth)";
  return truth;
}

}  // namespace wardslam::nav_demo

// Makes MRPT's metric maps, a CSemanticMap among them, of an annotated rawlog:
//   metric_map EMBEDDED.rawlog TRAJECTORY.txt MAPS.ini PREFIX
#include <mrpt/config/CConfigFile.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CRawlog.h>
#include <wardslam/core/mrpt_compat.h>
#include <wardslam/exchange/tum_trajectory.h>
#include <wardslam/mrpt_plugin/register_all.h>
#include <wardslam/mrpt_plugin/semantic_metric_map.h>

#include <cmath>
#include <exception>
#include <iostream>

namespace {

/// Where the camera was at this time; null where nobody knows.
const wardslam::core::StampedPose* poseAt(const wardslam::core::Trajectory& trajectory, double stamp_s) {
  for (const auto& pose : trajectory) {
    if (std::abs(pose.stamp_s - stamp_s) < 1e-3) return &pose;
  }
  return nullptr;
}

void run(char** arguments) {
  wardslam::mrpt_plugin::registerAll();  // or load libwardslam-mrpt.so as a plug-in
  mrpt::maps::TSetOfMetricMapInitializers definitions;
  definitions.loadFromConfigFile(mrpt::config::CConfigFile(arguments[3]), "MappingApplication");
  mrpt::maps::CMultiMetricMap maps(definitions);

  const auto trajectory = wardslam::exchange::readTumTrajectory(arguments[2]);
  mrpt::obs::CRawlog rawlog;
  if (!rawlog.loadFromRawLogFile(arguments[1])) throw std::runtime_error("the rawlog cannot be read");
  mrpt::poses::CPose3D T_map_robot;
  bool isPlaced = false;
  for (std::size_t i = 0; i < rawlog.size(); ++i) {
    if (rawlog.getType(i) != mrpt::obs::CRawlog::etObservation) continue;
    const auto observation = rawlog.getAsObservation(i);
    if (const auto scan = std::dynamic_pointer_cast<mrpt::obs::CObservation3DRangeScan>(observation)) {
      const auto* camera = poseAt(trajectory, wardslam::core::fromMrptTime(scan->timestamp));
      isPlaced = camera != nullptr;
      if (!isPlaced) continue;
      const auto T_robot_camera = scan->sensorPose + scan->relativePoseIntensityWRTDepth;
      T_map_robot = wardslam::core::toMrpt(camera->T_map_cam) + (-T_robot_camera);
    }
    if (isPlaced) maps.insertObservation(*observation, T_map_robot);  // scans, and what their images show
  }

  for (const auto& map : maps) std::cout << map->asString() << "\n";
  const auto semantic = maps.mapByClass<wardslam::mrpt_plugin::CSemanticMap>();
  for (const auto& [id, object] : semantic->objects())
    std::cout << semantic->map().labels.name(object.classId) << " #" << id << ": " << toString(object.state) << "\n";
  maps.saveMetricMapRepresentationToFile(arguments[4]);
}

}  // namespace

int main(int count, char** arguments) try {
  if (count != 5) throw std::runtime_error("usage: metric_map EMBEDDED.rawlog TRAJECTORY.txt MAPS.ini PREFIX");
  run(arguments);
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 1;
}

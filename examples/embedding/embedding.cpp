// usage: embedding RECORDING MASKS embedding.ini
//
// A program of somebody else's with WardSLAM in it: feeds it observations, hears of every frame, asks the map, and
// gives MRPT's navigation its obstacles. docs/embedding.md explains.

#include <mrpt/config/CConfigFile.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <wardslam/core/mrpt_compat.h>
#include <wardslam/navigation/obstacles.h>
#include <wardslam/pipeline/ini_options.h>
#include <wardslam/pipeline/slam_system.h>
#include <wardslam/query/drivable_floor.h>
#include <wardslam/query/map_query.h>
#include <wardslam/query/route.h>
#include <wardslam/sources/observation_source.h>

#include <exception>
#include <iostream>

namespace {

using namespace wardslam;

/// Hears of every frame: where the robot is, and how sure of it.
class Robot : public pipeline::FrameObserver {
 public:
  void onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) override {
    if (!odometry.hasPose()) return;
    T_map_base_ = odometry.T_map_cam * frame.T_base_cam.inverse();
    ++frames_;
  }

  [[nodiscard]] const Eigen::Isometry3d& T_map_base() const { return T_map_base_; }
  [[nodiscard]] Eigen::Vector2d place_m() const { return T_map_base_.translation().head<2>(); }
  [[nodiscard]] int frames() const { return frames_; }

 private:
  Eigen::Isometry3d T_map_base_ = Eigen::Isometry3d::Identity();
  int frames_ = 0;
};

/// What CRobot2NavInterface::senseObstacles() of a navigation program returns.
bool senseObstacles(const navigation::Obstacles& obstacles, const Eigen::Isometry3d& T_map_base,
                    mrpt::maps::CSimplePointsMap& points, mrpt::system::TTimeStamp& stamp) {
  const auto sensed = obstacles.sense(T_map_base);
  navigation::fill(sensed, points, stamp);
  return sensed.stamp_s > 0.0;
}

void askTheMap(const mapping::SemanticMap& map, const Robot& robot) {
  const query::MapQuery query(map);
  std::cout << "objects: " << query.objects().size() << "\n";
  const auto nearest = query.nearest(robot.place_m(), {});
  if (!nearest) return;
  std::cout << "nearest: " << map.labels.name(nearest->object->classId) << ", " << nearest->distance_m << " m\n";

  const query::DrivableFloor floor(map.floorPlan, {0.25, {}, false});
  const auto spot = floor.spotBeside(*nearest->object, 0.6);
  if (!spot) return;
  const auto route = query::planRoute(floor, robot.place_m(), spot->p_map_m);
  std::cout << "a spot beside it: " << spot->p_map_m.transpose() << (route ? "" : ", no way leads there") << "\n";
}

int run(const std::string& recording, const std::string& masks, const std::string& iniFile) {
  auto options = pipeline::readSlamOptions(mrpt::config::CConfigFile(iniFile), "WardSLAM");
  options.segmentation.type = segmentation::SegmentationOptions::Type::RecordedMasks;  // on a robot: a network
  options.segmentation.recorded_masks.folder = masks;
  pipeline::SlamSystem slam(options);
  Robot robot;
  navigation::Obstacles obstacles(mapping::FloorPlan{});  // of a map, where there is one already: its floor plan
  slam.addObserver(robot);
  slam.addObserver(obstacles);

  const auto source = sources::openSource(recording, {});  // or observations from sensors of your own
  while (const auto observation = source->next()) slam.process(observation);
  slam.finish();

  mrpt::maps::CSimplePointsMap points;
  mrpt::system::TTimeStamp stamp;
  const bool sensed = senseObstacles(obstacles, robot.T_map_base(), points, stamp);
  std::cout << "frames: " << robot.frames() << "\nobstacle points: " << points.size() << "\n";
  askTheMap(slam.semanticMap(), robot);
  return robot.frames() > 0 && sensed ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "usage: embedding RECORDING MASKS embedding.ini\n";
    return 2;
  }
  try {
    return run(argv[1], argv[2], argv[3]);
  } catch (const std::exception& error) {
    std::cerr << "embedding: " << error.what() << "\n";
    return 1;
  }
}

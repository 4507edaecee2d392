// A program in the manner of MRPT's icp-slam, with WardSLAM in the place of ICP:
//   map_builder MAP_BUILDER.ini RECORDING.rawlog PREFIX [EARLIER.simplemap]
// goes on in an earlier simple map if there is one (whose images the .ini had written), and writes PREFIX.simplemap,
// the metric maps that the .ini file asks for, and the poses PREFIX_live.txt (as they were told while the robot drove)
// and PREFIX.txt (the camera's, by the map in the end).
#include <mrpt/config/CConfigFile.h>
#include <mrpt/img/CImage.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <wardslam/core/mrpt_compat.h>
#include <wardslam/exchange/tum_trajectory.h>
#include <wardslam/mrpt_slam/semantic_map_builder.h>
#include <wardslam/sources/external_images.h>

#include <exception>
#include <fstream>
#include <iostream>
#include <string>

namespace {

using mrpt::obs::CRawlog;

/// One entry of a rawlog of either format. A pair of actions and observations comes as two entries.
void feed(const CRawlog& rawlog, std::size_t entry, wardslam::mrpt_slam::CMetricMapBuilderSemantic& builder) {
  if (rawlog.getType(entry) == CRawlog::etObservation) {
    builder.processObservation(rawlog.getAsObservation(entry));
  } else if (rawlog.getType(entry) == CRawlog::etSensoryFrame) {
    const bool hasActions = entry > 0 && rawlog.getType(entry - 1) == CRawlog::etActionCollection;
    mrpt::obs::CActionCollection none;
    auto& actions = hasActions ? *rawlog.getAsAction(entry - 1) : none;
    builder.processActionObservation(actions, *rawlog.getAsObservations(entry));
  }
}

mrpt::maps::CSimpleMap readSimpleMap(const std::string& file) {
  mrpt::maps::CSimpleMap simple;
  if (!simple.loadFromFile(file)) throw std::runtime_error(file + ": cannot be read");
  return simple;
}

void run(const std::string& iniFile, const std::string& rawlogFile, const std::string& prefix,
         const mrpt::maps::CSimpleMap& earlier) {
  wardslam::mrpt_slam::CMetricMapBuilderSemantic builder;  // was: mrpt::slam::CMetricMapBuilderICP builder;
  builder.loadFromConfigFile(mrpt::config::CConfigFile(iniFile), "MappingApplication");
  builder.initialize(earlier);

  CRawlog rawlog;
  if (!rawlog.loadFromRawLogFile(rawlogFile)) throw std::runtime_error(rawlogFile + ": cannot be read");
  if (const auto images = wardslam::sources::findImageFolder(rawlogFile))  // where they lie outside
    mrpt::img::CImage::setImagesPathBase(images->string());
  std::ofstream live(prefix + "_live.txt");
  for (std::size_t entry = 0; entry < rawlog.size(); ++entry) {
    feed(rawlog, entry, builder);
    mrpt::poses::CPose3D robot;
    builder.getCurrentPoseEstimation()->getMean(robot);
    live << entry << " " << robot.asString() << "\n";
  }
  builder.finish();  // what MRPT's own do not have: the last adjustment

  mrpt::maps::CSimpleMap simple;
  builder.getCurrentlyBuiltMap(simple);
  if (!simple.saveToFile(prefix + ".simplemap")) throw std::runtime_error(prefix + ".simplemap: cannot be written");
  const auto& maps = wardslam::core::metricMapOf(builder.getCurrentlyBuiltMetricMap());
  for (const auto& map : maps) std::cout << map->asString() << "\n";
  maps.saveMetricMapRepresentationToFile(prefix);
  builder.saveCurrentEstimationToImage(prefix + ".png");
  wardslam::exchange::TumTrajectoryWriter trajectory(prefix + ".txt");
  for (const auto& pose : builder.trajectory()) trajectory.write(pose);
  trajectory.finish();
  std::cout << simple.size() << " keyframes\n";
}

}  // namespace

int main(int count, char** arguments) try {
  if (count != 4 && count != 5)
    throw std::runtime_error("usage: map_builder MAP_BUILDER.ini RECORDING.rawlog PREFIX [EARLIER.simplemap]");
  run(arguments[1], arguments[2], arguments[3], count == 5 ? readSimpleMap(arguments[4]) : mrpt::maps::CSimpleMap());
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 1;
}

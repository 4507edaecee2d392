#include "wardslam/mrpt_slam/simple_map_file.h"

#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDF.h>

#include <optional>
#include <string>
#include <vector>

#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/exchange/simple_map.h"
#include "wardslam/pipeline/slam_system.h"
#include "wardslam/sources/external_images.h"
#include "wardslam/sources/input_damage.h"
#include "wardslam/storage/map_file_writer.h"

namespace wardslam::mrpt_slam {
namespace {

using mrpt::obs::CObservation3DRangeScan;

/// What one entry shows, and from where.
struct View {
  std::string name;  ///< For sentences.
  Eigen::Isometry3d T_map_base;
  CObservation3DRangeScan::Ptr scan;

  [[nodiscard]] Eigen::Isometry3d T_base_cam() const {
    return core::fromMrpt(scan->sensorPose) * core::fromMrpt(scan->relativePoseIntensityWRTDepth);
  }
};

[[noreturn]] void refuse(const std::string& entry, const std::string& why) {
  throw core::InputError(entry + " of the simple map " + why +
                         ", so that no place can be recognised by it; give a simple map whose scans have their images "
                         "(`images` of the map builder), or the .wardmap of the same run");
}

CObservation3DRangeScan::Ptr scanAmong(const mrpt::obs::CSensoryFrame& observed, const std::string& label) {
  for (const auto& observation : observed) {
    const auto scan = std::dynamic_pointer_cast<CObservation3DRangeScan>(observation);
    if (scan && (label.empty() || scan->sensorLabel == label)) return scan;
  }
  return nullptr;
}

std::vector<View> viewsOf(const mrpt::maps::CSimpleMap& simple, std::string label) {
  std::vector<View> views;
  for (const auto& entry : simple) {
    const std::string name = "keyframe " + std::to_string(views.size());
    const auto scan = entry.sf ? scanAmong(*entry.sf, label) : nullptr;
    if (!scan) refuse(name, "has no RGB-D scan" + (label.empty() ? "" : " of the sensor '" + label + "'"));
    if (!scan->hasIntensityImage || !scan->hasRangeImage) refuse(name, "has a scan without colour and range image");
    label = scan->sensorLabel;
    if (!views.empty() && scan->timestamp <= views.back().scan->timestamp)
      refuse(name, "was not taken after the one before it");
    views.push_back({name, core::fromMrpt(entry.pose->getMeanVal()), scan});
  }
  return views;
}

pipeline::SlamOptions optionsFor(pipeline::SlamOptions options, const View& first) {
  options.mapping.enabled = true;
  options.map_frame.start_pose.clear();
  options.map_frame.level_with_floor = false;  // the simple map says where it is
  options.map_frame.T_map_base = first.T_map_base;
  return options;
}

/// By what the simple map says, whatever the images before have led to.
odometry::MotionPrior motionTo(const View& view, const Eigen::Isometry3d& T_map_base) {
  odometry::MotionPrior motion;
  motion.T_previous_now = T_map_base.inverse() * view.T_map_base;
  motion.covariance *= exchange::kKeyframePoseSigma * exchange::kKeyframePoseSigma;
  return motion;
}

/// Looks at all views. Images outside are in memory for as long as they are worked on.
void track(const std::vector<View>& views, pipeline::SlamSystem& slam) {
  Eigen::Isometry3d T_map_base = views.front().T_map_base;
  for (const View& view : views) {
    try {
      sources::loadImages(*view.scan);
      const auto motion = &view == &views.front() ? std::nullopt : std::optional(motionTo(view, T_map_base));
      const auto odometry = slam.process(view.scan, motion);
      T_map_base = odometry.covariance ? odometry.T_map_cam * view.T_base_cam().inverse() : view.T_map_base;
    } catch (const sources::InputDamage& damage) {
      refuse(view.name, std::string("cannot be used (") + damage.what() + ")");
    } catch (const core::FrameError& error) {
      refuse(view.name, std::string("cannot be used (") + error.what() + ")");
    }
    view.scan->unload();
  }
}

}  // namespace

std::size_t makeMapFile(const mrpt::maps::CSimpleMap& simple, const pipeline::SlamOptions& options,
                        const std::string& sensorLabel, const std::filesystem::path& wardmap) {
  const auto views = viewsOf(simple, sensorLabel);
  if (views.empty()) throw core::InputError("the simple map is empty; there is nothing to go on in");
  std::optional<storage::MapFileWriter> writer;  // outlives the system that writes to it
  pipeline::SlamSystem slam(optionsFor(options, views.front()), {}, pipeline::WhenBehind::Waits);
  writer.emplace(wardmap, storage::MapHeader{slam.labelSpace(), slam.configuration()});
  slam.writeTo(*writer);
  track(views, slam);
  slam.finish();
  const std::size_t placed = slam.trajectory().size();
  const auto least = static_cast<std::size_t>(options.odometry.min_initial_points);
  if (placed == 0 || slam.mapper().graph().points().size() < least) {  // surfaces alone tell no place from another
    throw core::InputError("none of the " + std::to_string(views.size()) +
                           " keyframes of the simple map shows enough to recognise a place by");
  }
  writer->finish(*slam.mapBuilder(), slam.mapper());
  return placed;
}

}  // namespace wardslam::mrpt_slam

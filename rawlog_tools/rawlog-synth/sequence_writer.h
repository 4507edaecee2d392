#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scene.h"
#include "wardslam/core/camera_model.h"
#include "wardslam/mapping/floor_plan.h"

namespace wardslam::synth {

/// One recorded frame with all that is known about it.
struct SequenceFrame {
  double stamp_s = 0.0;  ///< UNIX time in whole microseconds.
  cv::Mat color_bgr;     ///< CV_8UC3
  cv::Mat depth_m;       ///< CV_32FC1, as measured; 0 = none. Of an RGB-D camera,
  cv::Mat right_bgr;     ///< CV_8UC3; or this, of a stereo camera.
  cv::Mat instanceIds;   ///< CV_16UC1
  cv::Mat dynamic;       ///< CV_8UC1, 255 where something truly moves at that moment.
  Eigen::Isometry3d T_world_cam = Eigen::Isometry3d::Identity();
};

/// What recorded the sequence: an RGB-D camera or, with a baseline, a rectified stereo camera.
struct SequenceCamera {
  core::CameraModel model;
  std::optional<double> stereoBaseline_m;
};

/// A static object of the scene, for objects.csv.
struct StaticObject {
  Label label;
  Eigen::AlignedBox3f box_m;  ///< World frame.
  double restsFrom_s = 0.0;   ///< Seconds after the start; 0 = always.
};

/// Writes, for FILE.rawlog:
///   FILE.rawlog           CObservation3DRangeScan: colour and depth; or CObservationStereoImages; gzip
///   FILE.groundtruth.txt  TUM format, T_world_cam (optical)
///   FILE_labels/          masks/ (8-bit class ids), instances/ (16-bit), dynamic/ (255 = moving), each <stamp>.png;
///                         classes.txt; objects.csv; floor.yaml and floor.pgm, the true floor plan for map_server
/// All appears under ".partial" names first; finish() gives everything its name at once. Without it nothing is left.
class SequenceWriter {
 public:
  /// Throws core::InputError when something cannot be created, or when FILE_labels exists and is not such a folder.
  SequenceWriter(const std::filesystem::path& rawlog, const SequenceCamera& camera, std::vector<Label> labels);
  ~SequenceWriter();
  SequenceWriter(const SequenceWriter&) = delete;
  SequenceWriter& operator=(const SequenceWriter&) = delete;

  /// Throws core::InputError when the disk does not take it.
  void write(const SequenceFrame& frame);
  /// `writeMore` puts more truth into the folder of labels that it gets.
  void finish(const std::vector<StaticObject>& objects, const mapping::FloorPlan& floor,
              const std::function<void(const std::filesystem::path&)>& writeMore);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// FILE.groundtruth.txt and FILE_labels for FILE.rawlog.
[[nodiscard]] std::filesystem::path groundTruthFile(const std::filesystem::path& rawlog);
[[nodiscard]] std::filesystem::path labelsFolder(const std::filesystem::path& rawlog);

}  // namespace wardslam::synth

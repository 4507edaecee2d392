#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "output/output_options.h"
#include "output/recording.h"
#include "scene/scene.h"
#include "wardslam/mapping/floor_plan.h"

namespace wardslam::synth {

/// A static object of the scene, for objects.csv.
struct StaticObject {
  Label label;
  Eigen::AlignedBox3f box_m;                       ///< World frame.
  double restsFrom_s = 0.0;                        ///< Seconds after the start; 0 = always.
  std::optional<std::string> room = std::nullopt;  ///< Id of the room around its middle, where rooms are known.
  std::optional<int> storey = std::nullopt;        ///< Where there are several.
};

/// A frame as it goes to the disk.
struct EncodedFrame {
  double stamp_s = 0.0;
  Eigen::Isometry3d T_world_cam = Eigen::Isometry3d::Identity();
  std::vector<Bytes> recorded;  ///< Empty: the recorder lost it.
  std::vector<Bytes> labels;    ///< masks, instances, dynamic; as many as `recorded` has.
};

/// Writes, for FILE.rawlog or the folder FILE:
///   what the robot records (Recording)
///   FILE.groundtruth.txt  TUM format, T_world_cam (optical), of lost frames too; in a folder of the TUM layout it is
///                         its groundtruth.txt
///   FILE_labels/          masks/ (8-bit class ids), instances/ (16-bit), dynamic/ (255 = moving), each <stamp>.png;
///                         classes.txt; objects.csv; floor.yaml and floor.pgm, the true floor plan for map_server
/// All appears under ".partial" names first; finish() gives everything its name at once. Without it nothing is left.
class SequenceWriter {
 public:
  /// Throws core::InputError when something cannot be created, or when FILE_labels exists and is not such a folder.
  SequenceWriter(const OutputOptions& output, const SequenceCamera& camera, std::vector<Label> labels);
  ~SequenceWriter();
  SequenceWriter(const SequenceWriter&) = delete;
  SequenceWriter& operator=(const SequenceWriter&) = delete;

  /// Any number of threads may ask at once.
  [[nodiscard]] EncodedFrame encode(const SequenceFrame& frame) const;

  /// In order of time. Throws core::InputError when the disk does not take it.
  void write(const EncodedFrame& frame);
  [[nodiscard]] Recording& recording();
  /// `writeMore` puts more truth into the folder of labels that it gets.
  void finish(const std::vector<StaticObject>& objects, const mapping::FloorPlan& floor,
              const std::function<void(const std::filesystem::path&)>& writeMore);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// FILE.groundtruth.txt and FILE_labels for FILE.rawlog; of a folder of the TUM layout its groundtruth.txt, and its
/// name with "_labels".
[[nodiscard]] std::filesystem::path groundTruthFile(const OutputOptions& output);
[[nodiscard]] std::filesystem::path labelsFolder(const OutputOptions& output);

}  // namespace wardslam::synth

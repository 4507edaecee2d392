#pragma once

#include <mrpt/obs/CObservation.h>
#include <mrpt/opengl/Visualizable.h>
#include <mrpt/poses/CPose3D.h>

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "wardslam/core/camera_model.h"
#include "wardslam/core/keypoint.h"
#include "wardslam/core/segmentation.h"

namespace wardslam::mrpt_plugin {

/// What a key point lies on: nothing that moves, a thing that somebody could move, or what is moving (or moves by
/// itself).
enum class KeypointState : std::uint8_t { Static, Movable, Dynamic };

/// What the filters found out about one RGB-D image, in a rawlog beside the CObservation3DRangeScan of the same time:
/// per pixel the class, the thing and what moves, and the key points. The images themselves are not repeated.
///
/// RawLogViewer shows its text and, in 3D, its key points: green where static, orange on movable things, red where
/// dynamic.
class CObservationSemanticRGBD : public mrpt::obs::CObservation, public mrpt::opengl::Visualizable {
  DEFINE_SERIALIZABLE(CObservationSemanticRGBD, wardslam::mrpt_plugin)

 public:
  mrpt::poses::CPose3D cameraPose;  ///< The colour camera on the robot; MRPT's axes (x forward, y left, z up).
  core::CameraModel camera;

  core::Segmentation segmentation;               ///< Empty where nothing was segmented.
  std::map<core::ClassId, std::string> classes;  ///< Names of the classes that are in the image.
  cv::Mat labelBits;                             ///< CV_8UC1, bit i = core::PixelLabel i; may be empty.

  core::Features features;            ///< Key points and ORB descriptors, without semantic ones.
  std::vector<KeypointState> states;  ///< One per key point.
  int descriptorSide = 21;            ///< n of the n×n semantic descriptors; odd.

  /// The local semantic descriptors (P4): row i (n² class ids) belongs to key point i. They are windows of the class
  /// image, turned by the key point's angle, so they are read out of it and not stored. Empty where nothing was
  /// segmented.
  [[nodiscard]] cv::Mat semanticDescriptors() const;

  /// Key point in the optical frame of the camera (m); nothing where it has no depth.
  [[nodiscard]] std::optional<Eigen::Vector3d> pointInCamera(std::size_t keypoint) const;

  void getSensorPose(mrpt::poses::CPose3D& pose) const override { pose = cameraPose; }
  void setSensorPose(const mrpt::poses::CPose3D& pose) override { cameraPose = pose; }
  void getDescriptionAsText(std::ostream& out) const override;
  void getVisualizationInto(mrpt::opengl::CSetOfObjects& view) const override;
};

}  // namespace wardslam::mrpt_plugin

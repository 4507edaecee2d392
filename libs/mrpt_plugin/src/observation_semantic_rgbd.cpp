#include "wardslam/mrpt_plugin/observation_semantic_rgbd.h"

#include <array>
#include <ostream>
#include <stdexcept>

#include "archive_bytes.h"
#include "semantic_content.h"
#include "semantic_view.h"
#include "wardslam/features/semantic_descriptor.h"

namespace wardslam::mrpt_plugin {

IMPLEMENTS_SERIALIZABLE(CObservationSemanticRGBD, CObservation, wardslam::mrpt_plugin)

namespace {

constexpr std::uint8_t kVersion = 0;
constexpr std::size_t kMostLabel_bytes = 4096;
constexpr std::size_t kMostContent_bytes = 256U << 20U;

std::runtime_error damaged(const std::string& what) {
  return std::runtime_error("CObservationSemanticRGBD: the rawlog is damaged here: " + what);
}

}  // namespace

std::uint8_t CObservationSemanticRGBD::serializeGetVersion() const { return kVersion; }

void CObservationSemanticRGBD::serializeTo(mrpt::serialization::CArchive& out) const {
  out << sensorLabel.substr(0, kMostLabel_bytes) << timestamp;
  writeBytes(out, encodeContent(*this));
}

void CObservationSemanticRGBD::serializeFrom(mrpt::serialization::CArchive& in, std::uint8_t version) {
  if (version > kVersion) {
    throw std::runtime_error("CObservationSemanticRGBD: written by a newer WardSLAM, in version " +
                             std::to_string(version) + " of its format; this one reads up to version " +
                             std::to_string(kVersion) + ": update it");
  }
  try {
    sensorLabel = readText(in, kMostLabel_bytes);
    in >> timestamp;
    decodeContent(readBytes(in, in.ReadAs<std::uint32_t>(), kMostContent_bytes), *this);
  } catch (const core::BlobError& error) {
    throw damaged(error.what());
  }
}

cv::Mat CObservationSemanticRGBD::semanticDescriptors() const {
  if (segmentation.empty()) return {};
  return features::describeSemantics(segmentation.classIds, features.keypoints, descriptorSide);
}

std::optional<Eigen::Vector3d> CObservationSemanticRGBD::pointInCamera(std::size_t keypoint) const {
  const core::Keypoint& k = features.keypoints.at(keypoint);
  if (!k.hasDepth()) return std::nullopt;
  return camera.unproject({k.undistorted_px.x, k.undistorted_px.y}, k.depth_m);
}

void CObservationSemanticRGBD::getDescriptionAsText(std::ostream& out) const {
  CObservation::getDescriptionAsText(out);
  std::array<std::size_t, 3> inState{};
  for (const KeypointState state : states) ++inState[static_cast<std::size_t>(state)];
  out << "\nWhat WardSLAM's filters found in the image of this time (" << camera.width_px << "x" << camera.height_px
      << "):\n"
      << "Key points: " << features.size() << ", of which static " << inState[0] << ", on movable things " << inState[1]
      << ", dynamic " << inState[2] << "\n"
      << "Semantic descriptors: " << descriptorSide << "x" << descriptorSide << " class ids around each\n";
  if (segmentation.empty()) out << "The image was not segmented.\n";
  for (const core::Instance& instance : segmentation.instances) {
    const auto name = classes.find(instance.classId);
    out << "  thing " << instance.id << ": "
        << (name == classes.end() ? "class " + std::to_string(instance.classId) : name->second) << ", confidence "
        << instance.confidence << ", " << cv::countNonZero(segmentation.instanceIds == instance.id) << " pixels\n";
  }
  out << "Pose of the camera on the robot: " << cameraPose << "\n";
}

void CObservationSemanticRGBD::getVisualizationInto(mrpt::opengl::CSetOfObjects& view) const { addTo(view, *this); }

}  // namespace wardslam::mrpt_plugin

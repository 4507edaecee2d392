#include "wardslam/mrpt_plugin/observation_semantic_rgbd.h"

#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <array>
#include <ostream>
#include <stdexcept>

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

/// `size` bytes; takes no more memory than there is to read, whatever a damaged size says.
core::Bytes readBytes(mrpt::serialization::CArchive& in, std::size_t size) {
  constexpr std::size_t kStep = 1U << 20U;
  if (size > kMostContent_bytes) throw damaged("it should hold " + std::to_string(size) + " bytes");
  core::Bytes bytes;
  while (bytes.size() < size) {
    const std::size_t begin = bytes.size();
    const std::size_t step = std::min(kStep, size - begin);
    bytes.resize(begin + step);
    if (in.ReadBuffer(bytes.data() + begin, step) != step) throw damaged("it ends in the middle of the observation");
  }
  return bytes;
}

std::string readLabel(mrpt::serialization::CArchive& in) {
  const std::size_t size = in.ReadAs<std::uint32_t>();
  if (size > kMostLabel_bytes) throw damaged("the sensor label has " + std::to_string(size) + " letters");
  const core::Bytes bytes = readBytes(in, size);
  return {bytes.begin(), bytes.end()};
}

}  // namespace

std::uint8_t CObservationSemanticRGBD::serializeGetVersion() const { return kVersion; }

void CObservationSemanticRGBD::serializeTo(mrpt::serialization::CArchive& out) const {
  const core::Bytes content = encodeContent(*this);
  out << sensorLabel.substr(0, kMostLabel_bytes) << timestamp;
  out.WriteAs<std::uint32_t>(content.size());
  out.WriteBuffer(content.data(), content.size());
}

void CObservationSemanticRGBD::serializeFrom(mrpt::serialization::CArchive& in, std::uint8_t version) {
  if (version > kVersion) {
    throw std::runtime_error("CObservationSemanticRGBD: written by a newer WardSLAM, in version " +
                             std::to_string(version) + " of its format; this one reads up to version " +
                             std::to_string(kVersion) + ": update it");
  }
  sensorLabel = readLabel(in);
  in >> timestamp;
  const core::Bytes content = readBytes(in, in.ReadAs<std::uint32_t>());
  try {
    decodeContent(content, *this);
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

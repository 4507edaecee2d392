#include "semantic_content.h"

#include <mrpt/math/CMatrixFixed.h>

#include "wardslam/core/mrpt_compat.h"

namespace wardslam::mrpt_plugin {
namespace {

using core::BlobError;
using core::BlobKind;
using core::ByteReader;
using core::ByteWriter;
using core::Instance;
using core::Keypoint;

constexpr std::uint8_t kLayoutVersion = 1;
constexpr int kFastest = 1;  // of zstd's levels: these images are of few, large areas
constexpr int kMostSide_px = 16384;
constexpr int kOrbBytes = 32;

/// Hands every number of a record, in the order of the layout, to `field`.
template <class Field>
void forEachField(Keypoint& k, const Field& field) {
  for (float* value : {&k.raw_px.x, &k.raw_px.y, &k.undistorted_px.x, &k.undistorted_px.y, &k.depth_m, &k.angle_rad,
                       &k.response, &k.scale, &k.staticProbability}) {
    field(*value);
  }
}

template <class Field>
void forEachField(Instance& instance, const Field& field) {
  field(instance.id);
  field(instance.classId);
  field(instance.confidence);
  for (int* value : {&instance.box_px.x, &instance.box_px.y, &instance.box_px.width, &instance.box_px.height}) {
    field(*value);
  }
}

template <class Field>
void forEachField(core::CameraModel& c, const Field& field) {
  field(c.width_px);
  field(c.height_px);
  for (double* value : {&c.fx_px, &c.fy_px, &c.cx_px, &c.cy_px, &c.k1, &c.k2, &c.p1, &c.p2, &c.k3,
                        &c.depthNoise.least_m, &c.depthNoise.growth_per_m, &c.depthNoise.from_m}) {
    field(*value);
  }
}

template <class Record>
void put(ByteWriter& out, Record record) {
  forEachField(record, [&out](auto value) { out.put(value); });
}

template <class Record>
[[nodiscard]] Record get(ByteReader& in) {
  Record record;
  forEachField(record, [&in](auto& value) { value = in.get<std::decay_t<decltype(value)>>(); });
  return record;
}

void putPose(ByteWriter& out, const mrpt::poses::CPose3D& pose) {
  const Eigen::Matrix4d T = core::fromMrpt(pose).matrix();
  for (Eigen::Index i = 0; i < 12; ++i) out.put(T(i / 4, i % 4));
}

[[nodiscard]] mrpt::poses::CPose3D getPose(ByteReader& in) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  for (Eigen::Index i = 0; i < 12; ++i) T.matrix()(i / 4, i % 4) = in.get<double>();
  return core::toMrpt(T);
}

void putImage(ByteWriter& out, const cv::Mat& image) {
  out.put(static_cast<std::uint32_t>(image.rows));
  out.put(static_cast<std::uint32_t>(image.cols));
  const std::size_t row_bytes = static_cast<std::size_t>(image.cols) * image.elemSize();
  for (int row = 0; row < image.rows; ++row) out.putBytes(image.ptr(row), row_bytes);
}

[[nodiscard]] cv::Mat getImage(ByteReader& in, int type) {
  const auto rows = in.get<std::uint32_t>();
  const auto cols = in.get<std::uint32_t>();
  if (rows > kMostSide_px || cols > kMostSide_px || std::size_t{rows} * cols * CV_ELEM_SIZE(type) > in.left()) {
    throw BlobError("it ends before the last pixel");
  }
  if (rows == 0 || cols == 0) return {};
  cv::Mat image(static_cast<int>(rows), static_cast<int>(cols), type);
  in.getBytes(image.data, image.total() * image.elemSize());
  return image;
}

void putClasses(ByteWriter& out, const std::map<core::ClassId, std::string>& classes) {
  out.put(static_cast<std::uint32_t>(classes.size()));
  for (const auto& [id, name] : classes) {
    const std::string written = name.substr(0, 255);
    out.put(id);
    out.put(static_cast<std::uint8_t>(written.size()));
    out.putBytes(written.data(), written.size());
  }
}

[[nodiscard]] std::map<core::ClassId, std::string> getClasses(ByteReader& in) {
  std::map<core::ClassId, std::string> classes;
  for (std::size_t left = in.getCountOfAtLeast(2); left > 0; --left) {
    const auto id = in.get<core::ClassId>();
    std::string name(in.get<std::uint8_t>(), '\0');
    in.getBytes(name.data(), name.size());
    classes.emplace(id, std::move(name));
  }
  return classes;
}

void putFeatures(ByteWriter& out, const CObservationSemanticRGBD& observation) {
  const auto& [keypoints, descriptors, semanticDescriptors] = observation.features;
  out.put(static_cast<std::uint32_t>(keypoints.size()));
  for (const Keypoint& keypoint : keypoints) put(out, keypoint);
  out.putBytes(observation.states.data(), observation.states.size());
  for (int row = 0; row < descriptors.rows; ++row) out.putBytes(descriptors.ptr(row), kOrbBytes);
}

void getFeatures(ByteReader& in, CObservationSemanticRGBD& observation) {
  auto& [keypoints, descriptors, semanticDescriptors] = observation.features;
  keypoints.resize(in.getCountOfAtLeast(kOrbBytes));
  for (Keypoint& keypoint : keypoints) keypoint = get<Keypoint>(in);
  observation.states.resize(keypoints.size());
  for (std::size_t i = 0; i < keypoints.size(); ++i) {
    const auto state = in.get<std::uint8_t>();
    if (state > static_cast<std::uint8_t>(KeypointState::Dynamic)) throw BlobError("a key point has an unknown state");
    observation.states[i] = static_cast<KeypointState>(state);
    const bool isDynamic = observation.states[i] == KeypointState::Dynamic;
    keypoints[i].motion = isDynamic ? core::Motion::Dynamic : core::Motion::Static;
  }
  descriptors.create(static_cast<int>(keypoints.size()), kOrbBytes, CV_8UC1);
  in.getBytes(descriptors.data, descriptors.total());
}

/// What semanticDescriptors() and others who use the observation rely on; the reason why not, or nothing.
[[nodiscard]] const char* contradictionIn(const CObservationSemanticRGBD& o) {
  const auto isImage = [&](const cv::Mat& image, int type) {
    return image.empty() ||
           (image.type() == type && image.cols == o.camera.width_px && image.rows == o.camera.height_px);
  };
  if (!isImage(o.segmentation.classIds, CV_8UC1) || !isImage(o.segmentation.instanceIds, CV_16UC1) ||
      !isImage(o.labelBits, CV_8UC1)) {
    return "an image is not of the size of the camera, or not of its type";
  }
  const cv::Mat& orb = o.features.descriptors;
  const auto count = static_cast<int>(o.features.size());
  if (o.states.size() != o.features.size() || orb.rows != count ||
      (count > 0 && (orb.cols != kOrbBytes || orb.type() != CV_8UC1))) {
    return "the key points, their descriptors and their states are not of one number";
  }
  if (o.descriptorSide < 1 || o.descriptorSide > 255 || o.descriptorSide % 2 == 0) {
    return "the side of the semantic descriptors is no odd number from 1 to 255";
  }
  return nullptr;
}

}  // namespace

core::Bytes encodeContent(const CObservationSemanticRGBD& observation) {
  if (const char* why = contradictionIn(observation))
    throw std::logic_error(std::string("CObservationSemanticRGBD: ") + why);
  ByteWriter out;
  const std::size_t pixel_bytes = sizeof(core::ClassId) + sizeof(std::uint16_t) + sizeof(std::uint8_t);
  out.reserve(pixel_bytes * observation.segmentation.classIds.total() + 80 * observation.features.size() + 4096);
  putPose(out, observation.cameraPose);
  put(out, observation.camera);
  putImage(out, observation.segmentation.classIds);
  putImage(out, observation.segmentation.instanceIds);
  putImage(out, observation.labelBits);
  out.put(static_cast<std::uint32_t>(observation.segmentation.instances.size()));
  for (const Instance& instance : observation.segmentation.instances) put(out, instance);
  putClasses(out, observation.classes);
  out.put(static_cast<std::uint8_t>(observation.descriptorSide));
  putFeatures(out, observation);
  return core::pack(BlobKind::Observation, kLayoutVersion, out.bytes(), kFastest);
}

void decodeContent(const core::Bytes& blob, CObservationSemanticRGBD& observation) {
  const core::Bytes content = core::unpack(BlobKind::Observation, kLayoutVersion, blob);
  ByteReader in(content);
  observation.cameraPose = getPose(in);
  observation.camera = get<core::CameraModel>(in);
  observation.segmentation.classIds = getImage(in, CV_8UC1);
  observation.segmentation.instanceIds = getImage(in, CV_16UC1);
  observation.labelBits = getImage(in, CV_8UC1);
  observation.segmentation.instances.clear();
  for (std::size_t left = in.getCountOfAtLeast(sizeof(float)); left > 0; --left) {
    observation.segmentation.instances.push_back(get<Instance>(in));
  }
  observation.classes = getClasses(in);
  observation.descriptorSide = in.get<std::uint8_t>();
  getFeatures(in, observation);
  if (in.left() > 0) throw BlobError("it goes on behind its end");
  if (const char* why = contradictionIn(observation)) throw BlobError(why);
}

}  // namespace wardslam::mrpt_plugin

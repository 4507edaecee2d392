#include "semantic_map_encoding.h"

#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>

namespace wardslam::mrpt_plugin {
namespace {

using core::BlobError;
using core::ByteReader;
using core::ByteWriter;
using mapping::MapObject;
using mapping::SemanticMap;
using mapping::SemanticPoint;

constexpr std::uint8_t kLayoutVersion = 2;
constexpr std::uint8_t kBeforeZonesHadTypes = 1;
constexpr std::size_t kPoint_bytes = 22;
constexpr std::uint32_t kMostSide_cells = 100'000;
constexpr double kFarthest_m = 1e8;

void putText(ByteWriter& out, const std::string& text) {
  out.put(static_cast<std::uint32_t>(text.size()));
  out.putBytes(text.data(), text.size());
}

[[nodiscard]] std::string getText(ByteReader& in) {
  std::string text(in.getCountOfAtLeast(1), '\0');
  in.getBytes(text.data(), text.size());
  return text;
}

template <class Vector>
void putVector(ByteWriter& out, const Vector& v) {
  for (Eigen::Index i = 0; i < v.size(); ++i) out.put(v[i]);
}

template <class Vector>
[[nodiscard]] Vector getVector(ByteReader& in) {
  Vector v;
  for (Eigen::Index i = 0; i < v.size(); ++i) {
    v[i] = in.get<typename Vector::Scalar>();
    if (!(std::abs(static_cast<double>(v[i])) <= kFarthest_m)) throw BlobError("a place is no number, or too far off");
  }
  return v;
}

void putPose(ByteWriter& out, const Eigen::Isometry3d& T) {
  for (Eigen::Index i = 0; i < 12; ++i) out.put(T.matrix()(i / 4, i % 4));
}

[[nodiscard]] Eigen::Isometry3d getPose(ByteReader& in) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  for (Eigen::Index i = 0; i < 12; ++i) T.matrix()(i / 4, i % 4) = in.get<double>();
  const bool isRotation = (T.linear() * T.linear().transpose()).isIdentity(1e-6);
  if (!isRotation || !(T.translation().cwiseAbs().maxCoeff() <= kFarthest_m))
    throw BlobError("a pose is none, or too far off");
  return T;
}

void putLabels(ByteWriter& out, const core::LabelSpace& labels) {
  for (int id = 0; id < 256; ++id) putText(out, labels.name(static_cast<core::ClassId>(id)));
}

[[nodiscard]] core::LabelSpace getLabels(ByteReader& in) {
  auto labels = core::LabelSpace::coco();
  for (int id = 0; id < 256; ++id) labels.rename(static_cast<core::ClassId>(id), getText(in));
  return labels;
}

void put(ByteWriter& out, const std::optional<core::GroundPlane>& ground) {
  out.put(static_cast<std::uint8_t>(ground ? 1 : 0));
  if (!ground) return;
  putVector(out, ground->normal_cam);
  out.put(ground->height_m);
  putVector(out, Eigen::Map<const Eigen::Matrix<double, 9, 1>>(ground->covariance.data()));
}

[[nodiscard]] std::optional<core::GroundPlane> getGround(ByteReader& in) {
  if (in.get<std::uint8_t>() == 0) return std::nullopt;
  core::GroundPlane ground;
  ground.normal_cam = getVector<Eigen::Vector3d>(in);
  ground.height_m = getVector<Eigen::Matrix<double, 1, 1>>(in)[0];
  const auto covariance = getVector<Eigen::Matrix<double, 9, 1>>(in);
  ground.covariance = Eigen::Map<const Eigen::Matrix3d>(covariance.data());
  if (!(std::abs(ground.normal_cam.norm() - 1.0) < 1e-6)) throw BlobError("a floor has no direction");
  return ground;
}

void put(ByteWriter& out, const mapping::MappedKeyframe& keyframe) {
  out.put(keyframe.stamp_s);
  putPose(out, keyframe.T_map_cam);
  putText(out, keyframe.zone);
  out.put(keyframe.piece);
  out.put(static_cast<std::uint32_t>(keyframe.freeFan_cam_m.size()));
  for (const Eigen::Vector3f& end_m : keyframe.freeFan_cam_m) putVector(out, end_m);
  put(out, keyframe.ground);
}

[[nodiscard]] mapping::MappedKeyframe getKeyframe(ByteReader& in) {
  mapping::MappedKeyframe keyframe;
  keyframe.stamp_s = in.get<double>();
  keyframe.T_map_cam = getPose(in);
  keyframe.zone = getText(in);
  keyframe.piece = in.get<std::uint32_t>();
  keyframe.freeFan_cam_m.resize(in.getCountOfAtLeast(3 * sizeof(float)));
  for (Eigen::Vector3f& end_m : keyframe.freeFan_cam_m) end_m = getVector<Eigen::Vector3f>(in);
  keyframe.ground = getGround(in);
  return keyframe;
}

/// A point in one piece: there are millions.
void put(ByteWriter& out, const SemanticPoint& point) {
  std::array<std::uint8_t, kPoint_bytes> record{};
  std::memcpy(record.data(), point.p_cam_m.data(), 12);
  std::memcpy(record.data() + 12, point.color_rgb.data(), 3);
  record[15] = point.classId;
  std::memcpy(record.data() + 16, &point.object, 4);
  std::memcpy(record.data() + 20, &point.sightings, 2);
  out.putBytes(record.data(), record.size());
}

[[nodiscard]] SemanticPoint getPoint(ByteReader& in) {
  std::array<std::uint8_t, kPoint_bytes> record{};
  in.getBytes(record.data(), record.size());
  SemanticPoint point;
  std::memcpy(point.p_cam_m.data(), record.data(), 12);
  std::memcpy(point.color_rgb.data(), record.data() + 12, 3);
  point.classId = record[15];
  std::memcpy(&point.object, record.data() + 16, 4);
  std::memcpy(&point.sightings, record.data() + 20, 2);
  if (!point.p_cam_m.allFinite()) throw BlobError("a point is no number");
  return point;
}

void put(ByteWriter& out, const MapObject& object) {
  out.put(object.classId);
  out.put(object.probability);
  putVector(out, object.centroid_m);
  putVector(out, object.box_m.min());
  putVector(out, object.box_m.max());
  putPose(out, object.orientedBox.T_map_box);
  putVector(out, object.orientedBox.size_m);
  for (const std::uint8_t channel : object.color_rgb) out.put(channel);
  out.put(object.firstSeen_s);
  out.put(object.lastSeen_s);
  out.put(static_cast<std::int32_t>(object.views));
  putText(out, object.zone);
  out.put(static_cast<std::uint8_t>(object.state));
  out.put(object.maybeSameAs ? object.maybeSameAs->id : mapping::ObjectId{0});
  out.put(object.maybeSameAs ? object.maybeSameAs->probability : 0.0);
  out.put(object.piece);
}

[[nodiscard]] MapObject getObject(ByteReader& in) {
  MapObject object;
  object.classId = in.get<core::ClassId>();
  object.probability = in.get<double>();
  object.centroid_m = getVector<Eigen::Vector3d>(in);
  object.box_m.min() = getVector<Eigen::Vector3d>(in);
  object.box_m.max() = getVector<Eigen::Vector3d>(in);
  object.orientedBox.T_map_box = getPose(in);
  object.orientedBox.size_m = getVector<Eigen::Vector3d>(in);
  for (std::uint8_t& channel : object.color_rgb) channel = in.get<std::uint8_t>();
  object.firstSeen_s = in.get<double>();
  object.lastSeen_s = in.get<double>();
  object.views = in.get<std::int32_t>();
  object.zone = getText(in);
  const auto state = in.get<std::uint8_t>();
  if (state > static_cast<std::uint8_t>(mapping::ObjectState::Gone)) throw BlobError("a thing is in no known state");
  object.state = static_cast<mapping::ObjectState>(state);
  const auto lost = in.get<mapping::ObjectId>();
  const auto probability = in.get<double>();
  if (lost != 0) object.maybeSameAs = mapping::MaybeSame{lost, probability};
  object.piece = in.get<std::uint32_t>();
  return object;
}

void put(ByteWriter& out, const mapping::Zone& zone) {
  putText(out, zone.name);
  out.put(static_cast<std::uint32_t>(zone.polygon_m.size()));
  for (const Eigen::Vector2d& corner_m : zone.polygon_m) putVector(out, corner_m);
  out.put(static_cast<std::uint8_t>(zone.type));
  out.put(zone.maxSpeed_mps);
  out.put(zone.direction_rad);
  for (const auto* names : {&zone.actions.entry, &zone.actions.inside, &zone.actions.exit}) {
    out.put(static_cast<std::uint32_t>(names->size()));
    for (const std::string& name : *names) putText(out, name);
  }
}

void getRule(ByteReader& in, mapping::Zone& zone) {
  const auto type = in.get<std::uint8_t>();
  if (type > static_cast<std::uint8_t>(mapping::ZoneType::Release)) throw BlobError("a zone is of no known type");
  zone.type = static_cast<mapping::ZoneType>(type);
  zone.maxSpeed_mps = in.get<double>();
  zone.direction_rad = in.get<double>();
  if (!std::isfinite(zone.maxSpeed_mps) || !std::isfinite(zone.direction_rad))
    throw BlobError("a zone has a speed or direction that is no number");
  for (auto* names : {&zone.actions.entry, &zone.actions.inside, &zone.actions.exit}) {
    names->resize(in.getCountOfAtLeast(sizeof(std::uint32_t)));
    for (std::string& name : *names) name = getText(in);
  }
}

[[nodiscard]] mapping::Zone getZone(ByteReader& in, std::uint8_t version) {
  mapping::Zone zone;
  zone.name = getText(in);
  zone.polygon_m.resize(in.getCountOfAtLeast(2 * sizeof(double)));
  for (Eigen::Vector2d& corner_m : zone.polygon_m) corner_m = getVector<Eigen::Vector2d>(in);
  if (version > kBeforeZonesHadTypes) getRule(in, zone);
  return zone;
}

void put(ByteWriter& out, const mapping::FloorPlan& plan) {
  out.put(plan.resolution_m);
  putVector(out, plan.origin_m);
  out.put(static_cast<std::uint32_t>(plan.cells.rows));
  out.put(static_cast<std::uint32_t>(plan.cells.cols));
  for (int row = 0; row < plan.cells.rows; ++row)
    out.putBytes(plan.cells.ptr(row), static_cast<std::size_t>(plan.cells.cols));
}

[[nodiscard]] mapping::FloorPlan getFloorPlan(ByteReader& in) {
  mapping::FloorPlan plan;
  plan.resolution_m = in.get<double>();
  if (!(plan.resolution_m >= 0.001 && plan.resolution_m <= 100.0)) throw BlobError("the floor plan has no cells' size");
  plan.origin_m = getVector<Eigen::Vector2d>(in);
  const auto rows = in.get<std::uint32_t>();
  const auto cols = in.get<std::uint32_t>();
  if (rows > kMostSide_cells || cols > kMostSide_cells || std::size_t{rows} * cols > in.left())
    throw BlobError("the floor plan ends early");
  plan.cells.create(static_cast<int>(rows), static_cast<int>(cols), CV_8UC1);
  for (int row = 0; row < plan.cells.rows; ++row) in.getBytes(plan.cells.ptr(row), cols);
  return plan;
}

template <class Id, class Content, class Put>
void putAll(ByteWriter& out, const std::map<Id, Content>& all, const Put& putContent) {
  out.put(static_cast<std::uint32_t>(all.size()));
  for (const auto& [id, content] : all) {
    out.put(id);
    putContent(content);
  }
}

template <class Id, class Content, class Get>
void getAll(ByteReader& in, std::map<Id, Content>& all, const Get& getContent) {
  const std::size_t count = in.getCountOfAtLeast(sizeof(Id));
  for (std::size_t i = 0; i < count; ++i) {
    const Id id = in.get<Id>();
    all[id] = getContent();
  }
}

[[nodiscard]] mapping::SemanticCloudTile getTile(ByteReader& in) {
  mapping::SemanticCloudTile tile;
  tile.points.resize(in.getCountOfAtLeast(kPoint_bytes));
  for (SemanticPoint& point : tile.points) point = getPoint(in);
  return tile;
}

[[nodiscard]] std::size_t sizeOfCloud(const SemanticMap& map) {
  std::size_t size = 0;
  for (const auto& [id, tile] : map.cloud) size += tile.points.size() * kPoint_bytes;
  return size;
}

}  // namespace

core::Bytes encode(const SemanticMap& map) {
  ByteWriter out;
  constexpr std::size_t kBesidesTheCloud = 1U << 16U;
  out.reserve(sizeOfCloud(map) + map.floorPlan.cells.total() + kBesidesTheCloud);
  out.put(kLayoutVersion);
  putLabels(out, map.labels);
  out.put(map.piece);
  out.put(map.nextObjectId);
  putAll(out, map.keyframes, [&out](const mapping::MappedKeyframe& keyframe) { put(out, keyframe); });
  putAll(out, map.cloud, [&out](const mapping::SemanticCloudTile& tile) {
    out.put(static_cast<std::uint32_t>(tile.points.size()));
    for (const SemanticPoint& point : tile.points) put(out, point);
  });
  putAll(out, map.objects, [&out](const MapObject& object) { put(out, object); });
  out.put(static_cast<std::uint32_t>(map.zones.size()));
  for (const mapping::Zone& zone : map.zones) put(out, zone);
  put(out, map.floorPlan);
  return out.bytes();
}

SemanticMap decodeSemanticMap(const core::Bytes& bytes) {
  ByteReader in(bytes);
  const auto version = in.get<std::uint8_t>();
  if (version < kBeforeZonesHadTypes || version > kLayoutVersion) throw BlobError("its layout is unknown");
  SemanticMap map;
  map.labels = getLabels(in);
  map.piece = in.get<std::uint32_t>();
  map.nextObjectId = in.get<mapping::ObjectId>();
  getAll(in, map.keyframes, [&in] { return getKeyframe(in); });
  getAll(in, map.cloud, [&in] { return getTile(in); });
  getAll(in, map.objects, [&in] { return getObject(in); });
  for (auto& [id, object] : map.objects) object.id = id;
  map.zones.resize(in.getCountOfAtLeast(2 * sizeof(std::uint32_t)));
  for (mapping::Zone& zone : map.zones) zone = getZone(in, version);
  map.floorPlan = getFloorPlan(in);
  if (in.left() > 0) throw BlobError("there is more than there should be");
  return map;
}

}  // namespace wardslam::mrpt_plugin

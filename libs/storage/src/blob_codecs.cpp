#include "blob_codecs.h"

#include <cmath>
#include <string>

#include "wardslam/odometry/orb_descriptor.h"

namespace wardslam::storage {
namespace {

using core::Keypoint;
using mapping::SemanticPoint;
using odometry::OrbDescriptor;

constexpr std::uint8_t kFeaturesVersion = 1;
constexpr std::uint8_t kTileVersion = 1;
constexpr std::uint8_t kCellsVersion = 1;
constexpr std::uint8_t kFanVersion = 1;

/// Hands every field of a record, in the order of the layout, to `column`.
template <class Column>
void forEachColumn(std::vector<core::Keypoint>& keypoints, const Column& column) {
  column(keypoints, [](core::Keypoint& k) -> float& { return k.raw_px.x; });
  column(keypoints, [](core::Keypoint& k) -> float& { return k.raw_px.y; });
  column(keypoints, [](core::Keypoint& k) -> float& { return k.undistorted_px.x; });
  column(keypoints, [](core::Keypoint& k) -> float& { return k.undistorted_px.y; });
  column(keypoints, [](core::Keypoint& k) -> float& { return k.depth_m; });
  column(keypoints, [](core::Keypoint& k) -> float& { return k.angle_rad; });
  column(keypoints, [](core::Keypoint& k) -> float& { return k.response; });
  column(keypoints, [](core::Keypoint& k) -> float& { return k.scale; });
}
constexpr std::size_t kKeypointSize = 8 * sizeof(float) + sizeof(OrbDescriptor);

template <class Column>
void forEachColumn(std::vector<SemanticPoint>& points, const Column& column) {
  column(points, [](SemanticPoint& p) -> float& { return p.p_cam_m.x(); });
  column(points, [](SemanticPoint& p) -> float& { return p.p_cam_m.y(); });
  column(points, [](SemanticPoint& p) -> float& { return p.p_cam_m.z(); });
  column(points, [](SemanticPoint& p) -> std::uint8_t& { return p.color_rgb[0]; });
  column(points, [](SemanticPoint& p) -> std::uint8_t& { return p.color_rgb[1]; });
  column(points, [](SemanticPoint& p) -> std::uint8_t& { return p.color_rgb[2]; });
  column(points, [](SemanticPoint& p) -> core::ClassId& { return p.classId; });
  column(points, [](SemanticPoint& p) -> mapping::ObjectId& { return p.object; });
  column(points, [](SemanticPoint& p) -> std::uint16_t& { return p.sightings; });
}
constexpr std::size_t kPointSize = 3 * sizeof(float) + 4 + sizeof(mapping::ObjectId) + sizeof(std::uint16_t);

template <class Column>
void forEachColumn(std::vector<Eigen::Vector3f>& points, const Column& column) {
  for (const Eigen::Index axis : {0, 1, 2}) {
    column(points, [axis](Eigen::Vector3f& p) -> float& { return p[axis]; });
  }
}

template <class Record>
void putColumns(core::ByteWriter& out, std::vector<Record> records) {
  forEachColumn(records, [&out](auto& all, auto field) {
    for (auto& record : all) out.put(field(record));
  });
}

template <class Record>
void getColumns(core::ByteReader& in, std::vector<Record>& records) {
  forEachColumn(records, [&in](auto& all, auto field) {
    for (auto& record : all) field(record) = in.get<std::decay_t<decltype(field(record))>>();
  });
}

/// What a lens, a sensor and a room have room in: anything else is damage, and would be worked with for long.
constexpr float kFarthest_px = 1e6F;
constexpr float kFarthest_m = 1e4F;
constexpr float kLargestScale = 1e4F;

void require(bool isPossible, const char* what) {
  if (!isPossible) throw core::BlobError(std::string("it holds ") + what + " that is impossible");
}

void requirePossible(const core::Keypoint& k) {
  for (const float px : {k.raw_px.x, k.raw_px.y, k.undistorted_px.x, k.undistorted_px.y}) {
    require(std::abs(px) <= kFarthest_px, "a key point");
  }
  require(k.depth_m >= 0 && k.depth_m <= kFarthest_m, "a depth");
  require(std::isfinite(k.angle_rad) && std::isfinite(k.response), "an angle");
  require(k.scale > 0 && k.scale <= kLargestScale, "a scale");
}

void requirePossible(const Eigen::Vector3f& p_cam_m) {
  require(p_cam_m.cwiseAbs().maxCoeff() <= kFarthest_m && p_cam_m.allFinite(), "a point");
}

}  // namespace

core::Bytes encodeFeatures(const core::Features& features) {
  core::ByteWriter out;
  out.put(static_cast<std::uint32_t>(features.size()));
  putColumns(out, features.keypoints);
  for (std::size_t i = 0; i < features.size(); ++i) {
    out.putBytes(features.descriptors.ptr(static_cast<int>(i)), sizeof(OrbDescriptor));
  }
  return core::pack(core::BlobKind::Features, kFeaturesVersion, out.bytes());
}

core::Features decodeFeatures(const core::Bytes& blob) {
  const core::Bytes content = core::unpack(core::BlobKind::Features, kFeaturesVersion, blob);
  core::ByteReader in(content);
  core::Features features;
  features.keypoints.resize(in.getCount(kKeypointSize));
  getColumns(in, features.keypoints);
  for (const auto& keypoint : features.keypoints) requirePossible(keypoint);
  features.descriptors.create(static_cast<int>(features.size()), sizeof(OrbDescriptor), CV_8UC1);
  in.getBytes(features.descriptors.data, features.descriptors.total());
  return features;
}

core::Bytes encodeTile(const mapping::SemanticCloudTile& tile) {
  core::ByteWriter out;
  out.put(static_cast<std::uint32_t>(tile.points.size()));
  putColumns(out, tile.points);
  return core::pack(core::BlobKind::CloudTile, kTileVersion, out.bytes());
}

mapping::SemanticCloudTile decodeTile(const core::Bytes& blob) {
  const core::Bytes content = core::unpack(core::BlobKind::CloudTile, kTileVersion, blob);
  core::ByteReader in(content);
  mapping::SemanticCloudTile tile;
  tile.points.resize(in.getCount(kPointSize));
  getColumns(in, tile.points);
  for (const auto& point : tile.points) requirePossible(point.p_cam_m);
  return tile;
}

core::Bytes encodeFan(const std::vector<Eigen::Vector3f>& fan_cam_m) {
  core::ByteWriter out;
  out.put(static_cast<std::uint32_t>(fan_cam_m.size()));
  putColumns(out, fan_cam_m);
  return core::pack(core::BlobKind::FreeFan, kFanVersion, out.bytes());
}

std::vector<Eigen::Vector3f> decodeFan(const core::Bytes& blob) {
  const core::Bytes content = core::unpack(core::BlobKind::FreeFan, kFanVersion, blob);
  core::ByteReader in(content);
  std::vector<Eigen::Vector3f> fan_cam_m(in.getCount(3 * sizeof(float)));
  getColumns(in, fan_cam_m);
  for (const auto& end : fan_cam_m) requirePossible(end);
  return fan_cam_m;
}

core::Bytes encodeCells(const cv::Mat& cells) {
  core::ByteWriter out;
  out.put(static_cast<std::uint32_t>(cells.rows));
  out.put(static_cast<std::uint32_t>(cells.cols));
  for (int row = 0; row < cells.rows; ++row) out.putBytes(cells.ptr(row), static_cast<std::size_t>(cells.cols));
  return core::pack(core::BlobKind::FloorCells, kCellsVersion, out.bytes());
}

cv::Mat decodeCells(const core::Bytes& blob) {
  const core::Bytes content = core::unpack(core::BlobKind::FloorCells, kCellsVersion, blob);
  core::ByteReader in(content);
  const std::uint64_t rows = in.get<std::uint32_t>();
  const std::uint64_t columns = in.get<std::uint32_t>();
  if (rows * columns != content.size() - 2 * sizeof(std::uint32_t)) {
    throw core::BlobError("it should hold " + std::to_string(rows) + " x " + std::to_string(columns) +
                          " cells, and its size says otherwise");
  }
  if (rows * columns == 0) return {};
  cv::Mat cells(static_cast<int>(rows), static_cast<int>(columns), CV_8UC1);
  in.getBytes(cells.data, cells.total());
  return cells;
}

}  // namespace wardslam::storage

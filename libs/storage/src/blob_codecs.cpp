#include "blob_codecs.h"

#include <cmath>
#include <limits>
#include <string>

#include "wardslam/odometry/orb_descriptor.h"

namespace wardslam::storage {
namespace {

using core::Keypoint;
using mapping::PointMemory;
using mapping::SemanticPoint;
using odometry::OrbDescriptor;

constexpr std::uint8_t kFeaturesVersion = 2;
constexpr std::uint8_t kTileVersion = 1;
constexpr std::uint8_t kCellsVersion = 1;
constexpr std::uint8_t kFanVersion = 1;
constexpr std::uint8_t kTileMemoryVersion = 1;
constexpr std::uint8_t kDepthViewVersion = 1;

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

/// What the second version of the layout holds in front of the descriptors.
template <class Column>
void addedColumn(std::vector<core::Keypoint>& keypoints, const Column& column) {
  column(keypoints, [](core::Keypoint& k) -> float& { return k.depthSpread_m; });
}

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
void forEachColumn(std::vector<PointMemory>& points, const Column& column) {
  for (const Eigen::Index axis : {0, 1, 2}) {
    column(points, [axis](PointMemory& p) -> float& { return p.p_cam_m[axis]; });
  }
  for (const std::size_t i : {0U, 1U, 2U}) {
    column(points, [i](PointMemory& p) -> std::uint8_t& { return p.color_rgb[i]; });
  }
  column(points, [](PointMemory& p) -> float& { return p.precision_m2; });
  column(points, [](PointMemory& p) -> float& { return p.sigma_m; });
  for (const std::size_t i : {0U, 1U, 2U}) {
    column(points, [i](PointMemory& p) -> mapping::ObjectId& { return p.votes[i].object; });
    column(points, [i](PointMemory& p) -> float& { return p.votes[i].weight; });
  }
  column(points, [](PointMemory& p) -> mapping::ObjectId& { return p.object; });
  column(points, [](PointMemory& p) -> std::uint16_t& { return p.sightings; });
  column(points, [](PointMemory& p) -> std::int8_t& { return p.evidence; });
}
constexpr std::size_t kPointMemorySize =
    8 * sizeof(float) + 3 + 4 * sizeof(mapping::ObjectId) + sizeof(std::uint16_t) + sizeof(std::int8_t);

template <class Column>
void forEachColumn(std::vector<Eigen::Vector3f>& points, const Column& column) {
  for (const Eigen::Index axis : {0, 1, 2}) {
    column(points, [axis](Eigen::Vector3f& p) -> float& { return p[axis]; });
  }
}

auto putting(core::ByteWriter& out) {
  return [&out](auto& all, auto field) {
    for (auto& record : all) out.put(field(record));
  };
}

auto getting(core::ByteReader& in) {
  return [&in](auto& all, auto field) {
    for (auto& record : all) field(record) = in.get<std::decay_t<decltype(field(record))>>();
  };
}

template <class Record>
void putColumns(core::ByteWriter& out, std::vector<Record> records) {
  forEachColumn(records, putting(out));
}

template <class Record>
void getColumns(core::ByteReader& in, std::vector<Record>& records) {
  forEachColumn(records, getting(in));
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
  require(k.depthSpread_m >= 0 && k.depthSpread_m <= kFarthest_m, "a spread of depths");
  require(std::isfinite(k.angle_rad) && std::isfinite(k.response), "an angle");
  require(k.scale > 0 && k.scale <= kLargestScale, "a scale");
}

void requirePossible(const Eigen::Vector3f& p_cam_m) {
  require(p_cam_m.cwiseAbs().maxCoeff() <= kFarthest_m && p_cam_m.allFinite(), "a point");
}

void requirePossible(const PointMemory& point) {
  requirePossible(point.p_cam_m);
  require(point.precision_m2 >= 0 && std::isfinite(point.precision_m2), "a precision");
  require(point.sigma_m >= 0 && std::isfinite(point.sigma_m), "a noise");
  for (const auto& vote : point.votes) require(vote.weight >= 0 && std::isfinite(vote.weight), "a vote");
}

}  // namespace

core::Bytes encodeFeatures(const core::Features& features) {
  core::ByteWriter out;
  out.put(static_cast<std::uint32_t>(features.size()));
  auto keypoints = features.keypoints;
  forEachColumn(keypoints, putting(out));
  addedColumn(keypoints, putting(out));
  for (std::size_t i = 0; i < features.size(); ++i) {
    out.putBytes(features.descriptors.ptr(static_cast<int>(i)), sizeof(OrbDescriptor));
  }
  return core::pack(core::BlobKind::Features, kFeaturesVersion, out.bytes());
}

core::Features decodeFeatures(const core::Bytes& blob) {
  const bool isOfFirstVersion = core::versionOf(blob) == 1;
  const core::Bytes content = core::unpack(core::BlobKind::Features, isOfFirstVersion ? 1 : kFeaturesVersion, blob);
  core::ByteReader in(content);
  core::Features features;
  features.keypoints.resize(in.getCount(kKeypointSize + (isOfFirstVersion ? 0 : sizeof(float))));
  getColumns(in, features.keypoints);
  if (!isOfFirstVersion) addedColumn(features.keypoints, getting(in));
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

core::Bytes encodeTileMemory(const mapping::TileMemory& tile) {
  core::ByteWriter out;
  out.put(static_cast<std::uint32_t>(tile.size()));
  putColumns(out, tile);
  return core::pack(core::BlobKind::TileMemory, kTileMemoryVersion, out.bytes());
}

mapping::TileMemory decodeTileMemory(const core::Bytes& blob) {
  const core::Bytes content = core::unpack(core::BlobKind::TileMemory, kTileMemoryVersion, blob);
  core::ByteReader in(content);
  mapping::TileMemory tile(in.getCount(kPointMemorySize));
  getColumns(in, tile);
  for (const auto& point : tile) requirePossible(point);
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

/// How much the farthest lies behind the nearest changes less from cell to cell than where it lies.
core::Bytes encodeDepthView(const odometry::DepthView& view) {
  core::ByteWriter out;
  for (const int value : {view.cell_px, view.columns, view.rows}) out.put(static_cast<std::uint16_t>(value));
  for (const std::uint16_t nearest_mm : view.nearest_mm) out.put(nearest_mm);
  for (std::size_t i = 0; i < view.nearest_mm.size(); ++i) {
    out.put(static_cast<std::uint16_t>(view.farthest_mm[i] - view.nearest_mm[i]));
  }
  return core::pack(core::BlobKind::DepthView, kDepthViewVersion, out.bytes());
}

odometry::DepthView decodeDepthView(const core::Bytes& blob) {
  const core::Bytes content = core::unpack(core::BlobKind::DepthView, kDepthViewVersion, blob);
  core::ByteReader in(content);
  odometry::DepthView view;
  for (int* value : {&view.cell_px, &view.columns, &view.rows}) *value = in.get<std::uint16_t>();
  const auto cells = static_cast<std::size_t>(view.columns) * static_cast<std::size_t>(view.rows);
  if (in.left() != 2 * sizeof(std::uint16_t) * cells)
    throw core::BlobError("it holds more or fewer cells than it says");
  require(view.cell_px > 0 || cells == 0, "a cell");
  view.nearest_mm.resize(cells);
  view.farthest_mm.resize(cells);
  for (std::uint16_t& nearest_mm : view.nearest_mm) nearest_mm = in.get<std::uint16_t>();
  for (std::size_t i = 0; i < cells; ++i) {
    const int farthest_mm = view.nearest_mm[i] + in.get<std::uint16_t>();
    require(farthest_mm <= std::numeric_limits<std::uint16_t>::max(), "a depth");
    view.farthest_mm[i] = static_cast<std::uint16_t>(farthest_mm);
  }
  return view;
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

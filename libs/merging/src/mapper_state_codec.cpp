#include "mapper_state_codec.h"

#include <type_traits>

namespace wardslam::merging {
namespace {

using core::ByteReader;
using core::ByteWriter;
using graph::GraphState;
using graph::Loop;

constexpr std::size_t kDouble = sizeof(double);
constexpr std::size_t kId = sizeof(std::uint64_t);
constexpr std::size_t kCount = sizeof(std::uint32_t);

template <class Matrix>
void putMatrix(ByteWriter& out, const Matrix& matrix) {
  for (Eigen::Index i = 0; i < matrix.size(); ++i) out.put(matrix.data()[i]);
}

template <class Matrix>
[[nodiscard]] Matrix getMatrix(ByteReader& in) {
  Matrix matrix;
  for (Eigen::Index i = 0; i < matrix.size(); ++i) matrix.data()[i] = in.get<double>();
  return matrix;
}

void putPose(ByteWriter& out, const Eigen::Isometry3d& pose) { putMatrix(out, pose.matrix()); }

Eigen::Isometry3d getPose(ByteReader& in) {
  Eigen::Isometry3d pose;
  pose.matrix() = getMatrix<Eigen::Matrix4d>(in);
  return pose;
}

template <class Values, class Put>
void putAll(ByteWriter& out, const Values& values, const Put& putOne) {
  out.put(static_cast<std::uint32_t>(values.size()));
  for (const auto& value : values) putOne(value);
}

/// `smallest`: bytes that one takes at least.
template <class Get>
[[nodiscard]] auto getAll(ByteReader& in, std::size_t smallest, const Get& getOne) {
  std::vector<std::invoke_result_t<Get>> values;
  const std::size_t count = in.getCountOfAtLeast(smallest);
  values.reserve(count);
  for (std::size_t i = 0; i < count; ++i) values.push_back(getOne());
  return values;
}

void putIds(ByteWriter& out, const std::vector<std::uint64_t>& ids) {
  putAll(out, ids, [&](std::uint64_t id) { out.put(id); });
}

void putPairs(ByteWriter& out, const std::vector<std::pair<std::uint64_t, std::uint64_t>>& pairs) {
  putAll(out, pairs, [&](const auto& pair) {
    out.put(pair.first);
    out.put(pair.second);
  });
}

std::vector<std::pair<std::uint64_t, std::uint64_t>> getPairs(ByteReader& in) {
  return getAll(in, 2 * kId, [&] {
    const auto first = in.get<std::uint64_t>();
    return std::pair(first, in.get<std::uint64_t>());
  });
}

void putLoop(ByteWriter& out, const Loop& loop) {
  out.put(loop.older);
  out.put(loop.newer);
  putPose(out, loop.T_older_newer);
  out.put<std::int32_t>(loop.inliers);
  putPairs(out, loop.samePoints);
  putIds(out, loop.place);
  out.put(loop.spread);
  for (const int count : {loop.depth.agreeing, loop.depth.seenThrough, loop.depth.hidden, loop.depth.unknown})
    out.put<std::int32_t>(count);
}

Loop getLoop(ByteReader& in) {
  Loop loop;
  loop.older = in.get<std::uint64_t>();
  loop.newer = in.get<std::uint64_t>();
  loop.T_older_newer = getPose(in);
  loop.inliers = in.get<std::int32_t>();
  loop.samePoints = getPairs(in);
  loop.place = getAll(in, kId, [&] { return in.get<std::uint64_t>(); });
  loop.spread = in.get<double>();
  for (int* count : {&loop.depth.agreeing, &loop.depth.seenThrough, &loop.depth.hidden, &loop.depth.unknown})
    *count = in.get<std::int32_t>();
  return loop;
}

constexpr std::size_t kSmallestLoop = 2 * kId + 17 * kDouble + 5 * sizeof(std::int32_t) + 2 * kCount;

void putLoops(ByteWriter& out, const std::vector<Loop>& loops) {
  putAll(out, loops, [&](const Loop& loop) { putLoop(out, loop); });
}

std::vector<Loop> getLoops(ByteReader& in) {
  return getAll(in, kSmallestLoop, [&] { return getLoop(in); });
}

void putGraph(ByteWriter& out, const GraphState& state) {
  putAll(out, state.keyframes, [&](const GraphState::Keyframe& keyframe) {
    out.put(keyframe.id);
    putPose(out, keyframe.T_map_cam);
    out.put(keyframe.submap);
    out.put<std::uint8_t>(keyframe.isSettled ? 1 : 0);
    out.put(keyframe.floor);
    putAll(out, keyframe.sightings, [&](const odometry::Sighting& sighting) {
      out.put(sighting.point);
      out.put(static_cast<std::uint32_t>(sighting.keypoint));
    });
  });
  putAll(out, state.points, [&](const GraphState::Point& point) {
    out.put(point.id);
    putMatrix(out, point.p_map_m);
    putMatrix(out, point.viewedFrom_map_m);
    putMatrix(out, point.information_per_m2);
  });
  putPairs(out, state.fusedInto);
}

GraphState::Keyframe getKeyframe(ByteReader& in) {
  GraphState::Keyframe keyframe;
  keyframe.id = in.get<std::uint64_t>();
  keyframe.T_map_cam = getPose(in);
  keyframe.submap = in.get<std::uint32_t>();
  keyframe.isSettled = in.get<std::uint8_t>() != 0;
  keyframe.floor = in.get<std::uint64_t>();
  keyframe.sightings = getAll(in, kId + sizeof(std::uint32_t), [&] {
    const auto point = in.get<std::uint64_t>();
    return odometry::Sighting{point, in.get<std::uint32_t>()};
  });
  return keyframe;
}

GraphState::Point getPoint(ByteReader& in) {
  GraphState::Point point;
  point.id = in.get<std::uint64_t>();
  point.p_map_m = getMatrix<Eigen::Vector3d>(in);
  point.viewedFrom_map_m = getMatrix<Eigen::Vector3d>(in);
  point.information_per_m2 = getMatrix<Eigen::Matrix3d>(in);
  return point;
}

GraphState getGraph(ByteReader& in) {
  GraphState state;
  state.keyframes =
      getAll(in, 2 * kId + 16 * kDouble + sizeof(std::uint32_t) + 1 + kCount, [&] { return getKeyframe(in); });
  state.points = getAll(in, kId + 15 * kDouble, [&] { return getPoint(in); });
  state.fusedInto = getPairs(in);
  return state;
}

void putPlace(ByteWriter& out, const graph::RememberedPlace& place) {
  out.put(place.id);
  putAll(out, place.keypoints, [&](std::uint32_t keypoint) { out.put(keypoint); });
}

graph::RememberedPlace getPlace(ByteReader& in) {
  graph::RememberedPlace place;
  place.id = in.get<std::uint64_t>();
  place.keypoints = getAll(in, sizeof(std::uint32_t), [&] { return in.get<std::uint32_t>(); });
  return place;
}

}  // namespace

void put(ByteWriter& out, const graph::MapperState& state) {
  putGraph(out, state.graph);
  putAll(out, state.joins, [&](const odometry::SubmapJoin& join) {
    out.put(join.from);
    out.put(join.into);
  });
  putLoops(out, state.loops);
  for (const auto* hypotheses : {&state.hypotheses, &state.unsettled})
    putAll(out, *hypotheses, [&](const auto& loops) { putLoops(out, loops); });
  putAll(out, state.apart_m, [&](const auto& known) {
    out.put(known.first);
    out.put(known.second);
  });
  putAll(out, state.doubles, [&](const auto& known) {
    out.put(known.first);
    putLoops(out, known.second);
  });
  putAll(out, state.places, [&](const auto& places) {
    putAll(out, places, [&](const graph::RememberedPlace& place) { putPlace(out, place); });
  });
  out.put(state.random);
}

graph::MapperState getMapperState(ByteReader& in) {
  graph::MapperState state;
  state.graph = getGraph(in);
  state.joins = getAll(in, 2 * sizeof(std::uint32_t), [&] {
    const auto from = in.get<std::uint32_t>();
    return odometry::SubmapJoin{from, in.get<std::uint32_t>()};
  });
  state.loops = getLoops(in);
  for (auto* hypotheses : {&state.hypotheses, &state.unsettled})
    *hypotheses = getAll(in, kCount, [&] { return getLoops(in); });
  const auto apart_m = getAll(in, kId + kDouble, [&] {
    const auto id = in.get<std::uint64_t>();
    return std::pair(id, in.get<double>());
  });
  state.apart_m = {apart_m.begin(), apart_m.end()};
  auto doubles = getAll(in, kId + kCount, [&] {
    const auto id = in.get<std::uint64_t>();
    return std::pair(id, getLoops(in));
  });
  state.doubles = {std::make_move_iterator(doubles.begin()), std::make_move_iterator(doubles.end())};
  state.places = getAll(in, kCount, [&] { return getAll(in, kId + kCount, [&] { return getPlace(in); }); });
  state.random = in.get<std::uint64_t>();
  return state;
}

}  // namespace wardslam::merging

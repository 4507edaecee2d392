// Budget: every answer in less than 1 ms, with 10,000 objects.

#include <benchmark/benchmark.h>

#include <random>

#include "wardslam/query/map_query.h"

namespace wardslam::mapping {
namespace {

constexpr int kObjects = 10000;
constexpr int kClasses = 40;
constexpr double kSide_m = 100.0;  // one object per m²
constexpr core::ClassId kRare = 200;

/// A hospital's floor of 100 m by 100 m: rooms of 5 m by 5 m, a doorway of 1 m in every wall, things everywhere, one
/// of them unlike the others in the far corner.
SemanticMap makeHospital() {
  SemanticMap map;
  map.floorPlan.cells = cv::Mat(2000, 2000, CV_8UC1, cv::Scalar(FloorPlan::kFree));
  for (int wall = 100; wall < 2000; wall += 100) {
    map.floorPlan.cells.row(wall).setTo(FloorPlan::kOccupied);
    map.floorPlan.cells.col(wall).setTo(FloorPlan::kOccupied);
  }
  for (int wall = 100; wall < 2000; wall += 100) {
    for (int room = 0; room < 2000; room += 100) {
      map.floorPlan.cells.row(wall).colRange(room + 40, room + 60).setTo(FloorPlan::kFree);
      map.floorPlan.cells.col(wall).rowRange(room + 40, room + 60).setTo(FloorPlan::kFree);
    }
  }
  for (int i = 0; i < 20; ++i) {
    const double x_m = 5.0 * i;
    map.zones.push_back({"zone " + std::to_string(i), {{x_m, 0}, {x_m + 5, 0}, {x_m + 5, 100}, {x_m, 100}}});
  }
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0.0, kSide_m);
  std::uniform_real_distribution<double> half(0.1, 0.4);
  for (ObjectId id = 1; id <= kObjects; ++id) {
    MapObject& object = map.objects[id];
    object.id = id;
    object.classId = id == kObjects ? kRare : static_cast<core::ClassId>(1 + id % kClasses);
    object.centroid_m =
        id == kObjects ? Eigen::Vector3d(99, 99, 0.4) : Eigen::Vector3d(place(random), place(random), 0.4);
    const Eigen::Vector3d size = Eigen::Vector3d(half(random), half(random), 0.4);
    object.box_m = Eigen::AlignedBox3d(object.centroid_m - size, object.centroid_m + size);
  }
  return map;
}

const SemanticMap& hospital() {
  static const SemanticMap map = makeHospital();
  return map;
}

const query::MapQuery& query() {
  static const query::MapQuery query(hospital());
  return query;
}

query::ObjectFilter ofClass(core::ClassId classId) {
  query::ObjectFilter filter;
  filter.classId = classId;
  return filter;
}

void buildIndex(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(query::MapQuery(hospital()));
}
BENCHMARK(buildIndex)->Unit(benchmark::kMillisecond);

void objectsOfAClass(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(query().objects(ofClass(7)));
}
BENCHMARK(objectsOfAClass)->Unit(benchmark::kMicrosecond);

void objectsInABox(benchmark::State& state) {
  query::ObjectFilter filter;
  filter.box_m = Eigen::AlignedBox3d(Eigen::Vector3d(20, 20, 0), Eigen::Vector3d(30, 30, 2));
  for (auto _ : state) benchmark::DoNotOptimize(query().objects(filter));
}
BENCHMARK(objectsInABox)->Unit(benchmark::kMicrosecond);

void freeChairsInAZone(benchmark::State& state) {
  query::ObjectFilter filter = ofClass(7);
  filter.zone = "zone 11";
  filter.onlyFree = true;
  for (auto _ : state) benchmark::DoNotOptimize(query().objects(filter));
}
BENCHMARK(freeChairsInAZone)->Unit(benchmark::kMicrosecond);

void nearestOfAClass(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(query().nearest(Eigen::Vector3d(50, 50, 0), ofClass(7)));
}
BENCHMARK(nearestOfAClass)->Unit(benchmark::kMicrosecond);

void nearestAlongTheFloor(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(query().nearestAlongFloor({51, 51}, ofClass(7)));
}
BENCHMARK(nearestAlongTheFloor)->Unit(benchmark::kMicrosecond);

/// The worst there is: across the whole floor.
void farthestAlongTheFloor(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(query().nearestAlongFloor({1, 1}, ofClass(kRare)));
}
BENCHMARK(farthestAlongTheFloor)->Unit(benchmark::kMicrosecond);

void whatIsAtAPoint(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(query().at({50, 50, 0.5}));
}
BENCHMARK(whatIsAtAPoint)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace wardslam::mapping

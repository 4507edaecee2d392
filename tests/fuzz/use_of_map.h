#pragma once

#include <cstdlib>
#include <filesystem>

#include "wardslam/core/errors.h"
#include "wardslam/mapping/map_builder.h"
#include "wardslam/query/drivable_floor.h"
#include "wardslam/query/map_difference.h"
#include "wardslam/query/map_query.h"
#include "wardslam/query/object_name.h"
#include "wardslam/query/route.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::fuzz {

/// All questions that programs put.
inline void ask(const mapping::SemanticMap& map) {
  const query::MapQuery query(map);
  (void)query.objects();
  (void)query.nearest(Eigen::Vector3d(1.0, 1.0, 0.5), {});
  (void)query.nearest(Eigen::Vector2d(1.0, 1.0), {});
  (void)query.nearestAlongFloor({1.0, 1.0}, {});
  (void)query.at({1.0, 1.0, 0.5});
  (void)query::difference(map, map);
  const query::DrivableFloor floor(map.floorPlan, {0.25, map.zones, false});
  (void)query::planRoute(floor, {0.0, 0.0}, {2.0, 2.0});
  for (const auto& [id, object] : map.objects) {
    (void)query::nameOf(object, map);
    (void)floor.spotBeside(object, 0.8);
  }
}

/// As a run does that goes on in an earlier map.
inline void goOnWith([[maybe_unused]] const mapping::SemanticMap& map,
                     [[maybe_unused]] const mapping::MapMemory& memory) {
#ifdef WARDSLAM_FUZZ_BUILDS_ON_MAPS
  mapping::MapBuilder builder({}, {});
  builder.restore(map, memory);
  (void)builder.map();
#endif
}

/// Opens, checks, reads and asks. What check() calls sound must be readable: else the process ends.
inline void useMap(const std::filesystem::path& file) {
  const auto map = storage::MapFile::open(file);
  const bool isSound = map.check().empty();
  try {
    (void)map.info();
    (void)map.header();
    (void)map.readViews();
    (void)map.readPoints();
    (void)map.readLoops();
    (void)map.readFreeSubmap();
    const auto memory = map.readMemory();
    ask(map.read());
    goOnWith(map.read(storage::CloudPart::Include, storage::PiecePart::All), memory);
  } catch (const core::InputError&) {
    if (isSound) std::abort();
  }
}

}  // namespace wardslam::fuzz

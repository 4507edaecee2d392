#pragma once

#include <filesystem>
#include <memory>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "graph/meeting_runs.h"
#include "mapping/scene.h"
#include "support/temporary_folder.h"
#include "wardslam/mapping/map_builder.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::test {

/// Maps of two runs (graph::MeetingRuns) through a room with bare walls, `a.wardmap` the older, and in it what is named
/// for each run. The world is that of the walk, y down: the first run sees what lies from 0 to 150 degrees about the
/// middle, the second from 60 to 170, both as far as 30 degrees to either side.
class FurnishedMaps {
 public:
  using Things = std::vector<mapping::scene::Thing>;

  FurnishedMaps(const Things& first, const Things& second) {
    write(a(), runs_.first, first);
    write(b(), runs_.second, second);
  }

  [[nodiscard]] std::filesystem::path a() const { return folder_.path() / "a.wardmap"; }
  [[nodiscard]] std::filesystem::path b() const { return folder_.path() / "b.wardmap"; }
  [[nodiscard]] std::filesystem::path all() const { return folder_.path() / "all.wardmap"; }

  /// A cube in that direction from the middle, 3 m away; instance numbers are of one run.
  [[nodiscard]] static mapping::scene::Thing cube(double direction_deg, core::ClassId classId, std::uint16_t instance) {
    return {mapping::scene::box(place_m(direction_deg), {0.6, 0.6, 0.6}), classId, instance, {40, 80, 160}};
  }

  /// Where it is in the frame of the first run.
  [[nodiscard]] Eigen::Vector3d p_first_m(double direction_deg) const {
    return SyntheticWalk::T_world_cam(0).inverse() * place_m(direction_deg);
  }

  [[nodiscard]] static mapping::MappingOptions mappingOptions() {
    mapping::MappingOptions options;
    options.cloud.pixel_step = 1;
    return options;
  }

 private:
  [[nodiscard]] static Eigen::Vector3d place_m(double direction_deg) {
    const double direction_rad = direction_deg * M_PI / 180.0;
    return 3.0 * Eigen::Vector3d(std::sin(direction_rad), 0.0, std::cos(direction_rad));
  }

  [[nodiscard]] static Things walls() {
    using mapping::scene::box;
    const cv::Vec3b grey{200, 190, 180};
    return {{box({4.6, 0, 0}, {0.2, 8, 9.4}), 0, 0, grey},
            {box({-4.6, 0, 0}, {0.2, 8, 9.4}), 0, 0, grey},
            {box({0, 0, 4.6}, {9.4, 8, 0.2}), 0, 0, grey},
            {box({0, 0, -4.6}, {9.4, 8, 0.2}), 0, 0, grey}};
  }

  /// A quarter as wide as that of the walk: as much as the map needs.
  [[nodiscard]] static core::CameraModel smallCamera() {
    core::CameraModel camera = SyntheticWorld::camera();
    camera.width_px /= 4;
    camera.height_px /= 4;
    camera.fx_px /= 4;
    camera.fy_px /= 4;
    camera.cx_px = camera.width_px / 2.0 - 0.5;
    camera.cy_px = camera.height_px / 2.0 - 0.5;
    return camera;
  }

  [[nodiscard]] std::vector<mapping::View> viewsOf(const graph::SavedGraph& graph, const Things& things) const {
    std::vector<mapping::View> views;
    for (const auto& keyframe : graph.keyframes) {
      const Eigen::Isometry3d T_world_cam = SyntheticWalk::T_world_cam(0) * runs_.walk.T_first_cam(keyframe->id);
      views.push_back(
          mapping::scene::render(things, T_world_cam, keyframe->stamp_s, keyframe->id, T_world_cam, smallCamera()));
    }
    return views;
  }

  void write(const std::filesystem::path& file, graph::SavedGraph& graph, Things things) const {
    for (const auto& wall : walls()) things.push_back(wall);
    const auto views = viewsOf(graph, things);
    mapping::MapBuilder builder(mappingOptions(), {});
    mapping::MapParts parts;
    for (std::size_t i = 0; i < views.size(); ++i) {
      auto keyframe = std::make_shared<odometry::Keyframe>(*graph.keyframes[i]);
      cv::Mat depth_m;
      cv::resize(views[i].depth_m, depth_m, {keyframe->camera.width_px, keyframe->camera.height_px}, 0, 0,
                 cv::INTER_NEAREST);
      keyframe->depth = std::make_shared<odometry::DepthView>(odometry::makeDepthView({depth_m, {}}));
      builder.addKeyframe(*keyframe);
      builder.apply(placed(*keyframe));
      builder.add(views[i]);
      parts.keyframes.insert(keyframe->id);
      graph.keyframes[i] = std::move(keyframe);
    }
    parts.tiles = parts.keyframes;
    for (const auto& [id, object] : builder.map().objects) parts.objects.insert(id);
    storage::MapChanges changes = storage::everythingOf(builder.map(parts));
    changes.memory = builder.memory(parts.tiles);
    changes.views = graph.keyframes;
    changes.graph.emplace();
    changes.graph->p_map_m = graph.p_map_m;
    for (const auto& keyframe : graph.keyframes) changes.graph->sightings[keyframe->id] = keyframe->sightings;
    static_cast<void>(storage::MapFile::create(file, {}, changes));
  }

  /// The builder places keyframes by the way from the one before; the graph knows better.
  [[nodiscard]] static odometry::MapUpdate placed(const odometry::Keyframe& keyframe) {
    odometry::MapUpdate update;
    update.T_map_cam[keyframe.id] = keyframe.T_map_cam;
    return update;
  }

  TemporaryFolder folder_;
  graph::MeetingRuns runs_{true};
};

}  // namespace wardslam::test

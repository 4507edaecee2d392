#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "graph/meeting_runs.h"
#include "support/temporary_folder.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::test {

/// Maps of two runs in one synthetic world, `a.wardmap` the older.
class MeetingMaps {
 public:
  explicit MeetingMaps(bool meet = true) : runs_(meet) {
    write(a(), runs_.first);
    write(b(), runs_.second);
  }

  [[nodiscard]] std::filesystem::path a() const { return folder_.path() / "a.wardmap"; }
  [[nodiscard]] std::filesystem::path b() const { return folder_.path() / "b.wardmap"; }
  [[nodiscard]] std::filesystem::path file(const std::string& name) const { return folder_.path() / name; }
  [[nodiscard]] const graph::MeetingRuns& runs() const { return runs_; }

  static void write(const std::filesystem::path& file, const graph::SavedGraph& graph,
                    const std::vector<mapping::Zone>& zones = {}) {
    storage::MapChanges changes;
    changes.zones = zones;
    changes.views = graph.keyframes;
    changes.graph.emplace();
    changes.graph->p_map_m = graph.p_map_m;
    for (const auto& keyframe : graph.keyframes) {
      auto& mapped = changes.keyframes[keyframe->id];
      mapped.stamp_s = keyframe->stamp_s;
      mapped.T_map_cam = keyframe->T_map_cam;
      mapped.piece = keyframe->submap;
      changes.graph->sightings[keyframe->id] = keyframe->sightings;
    }
    static_cast<void>(storage::MapFile::create(file, {}, changes));
  }

 private:
  TemporaryFolder folder_;
  graph::MeetingRuns runs_;
};

}  // namespace wardslam::test

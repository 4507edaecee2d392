#pragma once

#include <string>

#include "support/hand_made_map.h"
#include "support/temporary_folder.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::report {

/// What a run of 4 frames leaves in its folder, the third of them lost.
class RunFolderByHand {
 public:
  RunFolderByHand() {
    write("summary.json", R"({"frames": 4, "coverage": 0.75, "lost_events": 1, "peak_rss_mb": 123.4,
      "stages": {"odometry.track": {"calls": 4, "median_ms": 1.5, "p95_ms": 6.0}},
      "versions": {"wardslam": "0.1.0"}, "events": {"odometry.<lost>": 1}})");
    write("config.yaml", "# every option\nodometry:\n  min_inliers: 20\n");
    write("trajectory.txt", way());
    write("frames.csv", frames());
    write("load.csv", load());
    const auto map = test::makeWard();
    auto file = storage::MapFile::create(folder_.path() / "map.wardmap", {map.labels, ""});
    file.write(storage::everythingOf(map));
  }

  [[nodiscard]] const std::filesystem::path& path() const { return folder_.path(); }
  void write(const std::string& name, const std::string& text) const { folder_.write(name, text); }
  void remove(const std::string& name) const { std::filesystem::remove(path() / name); }

  /// 0.1 m along x in 1 s.
  [[nodiscard]] static std::string way() {
    return "900 0 1 1.2 0 0 0 1\n901 0.1 1 1.2 0 0 0 1\n903 0.3 1 1.2 0 0 0 1\n";
  }
  [[nodiscard]] static std::string frames() {
    return "timestamp,state,key_points,dynamic_key_points,inliers,held_by_depth,keyframe,piece\n"
           "900,ok,800,200,300,0,1,0\n901,ok,800,80,290,0,0,0\n902,lost,40,0,3,0,0,0\n903,ok,800,0,310,0,1,0\n";
  }

  [[nodiscard]] static std::string load() {
    return "timestamp,frames,frame_ms,keyframes,graph_ms,mapping_ms,storage_ms,apply_ms,waiting,memory_mb,open_files\n"
           "901,2,25.5,1,60,40,20,0.5,3,101.5,12\n903,2,26.5,0,10,0,0,0,0,102.5,12\n";
  }

  /// As if it had been killed: what it writes as it goes has its preliminary name, and no summary came.
  void kill() const {
    for (const char* name : {"trajectory.txt", "summary.json", "frames.csv", "load.csv"}) remove(name);
    write("trajectory_live.txt.partial", way());
    write("frames.csv.partial", frames() + "904,ok,8");
    write("load.csv.partial", load() + "904,2,2");
  }

 private:
  test::TemporaryFolder folder_;
};

}  // namespace wardslam::report

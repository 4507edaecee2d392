#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "wardslam/building/rooms.h"
#include "wardslam/core/trajectory.h"
#include "wardslam/mapping/semantic_map.h"
#include "wardslam/pipeline/frame_table.h"
#include "wardslam/pipeline/load_table.h"

namespace wardslam::report {

/// What a run left in its folder, as far as it is there and can be read.
struct RunRecord {
  bool isFinished = true;                       ///< Else what it wrote until it was killed, or until now.
  nlohmann::ordered_json summary;               ///< An object; empty where there is none.
  std::string configuration;                    ///< YAML.
  core::Trajectory trajectory;                  ///< In the map.
  std::size_t unjoinedPieces = 0;               ///< Trajectories in frames of their own.
  std::vector<pipeline::FrameRow> frames;       ///< In order of time.
  std::vector<pipeline::LoadRow> load;          ///< In order of time.
  std::optional<mapping::SemanticMap> map;      ///< With its cloud.
  building::Rooms rooms;                        ///< Of the map's floor plan.
  std::vector<std::filesystem::path> pictures;  ///< By time.
  std::vector<std::string> missing;             ///< A sentence for each thing that is not there.

  /// When the run began, by its files (s); 0 where none says.
  [[nodiscard]] double start_s() const;
  [[nodiscard]] double end_s() const;
};

/// `map`: where the run went on in one that lies elsewhere; else empty. Throws core::InputError where the folder holds
/// nothing of a run.
[[nodiscard]] RunRecord readRun(const std::filesystem::path& folder, const std::filesystem::path& map = {});

}  // namespace wardslam::report

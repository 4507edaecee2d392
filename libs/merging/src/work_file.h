#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "runs.h"
#include "wardslam/graph/mapper_state.h"

namespace wardslam::merging {

/// How far runs have met.
struct WorkDone {
  std::size_t run = 0;        ///< All before this one have looked for places of those before them,
  std::size_t keyframes = 0;  ///< and so many keyframes of it.
  graph::MapperState state;
};

/// What took long while a map was merged, kept beside it as NAME.merging until it is complete: the same maps, merged
/// with the same options, go on from there. Whatever is in the file, the map does not depend on it.
class WorkFile {
 public:
  WorkFile(const std::filesystem::path& out, const std::vector<Run>& runs, const pipeline::SlamOptions& options);

  /// Nothing where there is no such file, or it is of other maps, of other options or another version, or damaged.
  [[nodiscard]] std::optional<WorkDone> read() const;

  /// Throws core::InputError when it cannot be written.
  void write(const WorkDone& done) const;
  void remove() const;

 private:
  std::filesystem::path file_;
  std::string inputs_;  ///< Digest of all that the work depends on.
};

}  // namespace wardslam::merging

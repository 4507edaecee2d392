#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "wardslam/pipeline/slam_options.h"
#include "wardslam/reproduction/plan.h"
#include "wardslam/reproduction/results.h"

namespace wardslam::reproduction {

/// One run of a plan, kept in a folder of its own: OUT/cells/<sequence>/<variant>/<repetition>/.
struct Cell {
  std::size_t sequence = 0;
  std::size_t variant = 0;
  int repetition = 0;
  std::filesystem::path folder;
};

/// All cells of a plan: repetitions change slowest, so that tables fill evenly.
[[nodiscard]] std::vector<Cell> cellsOf(const Plan& plan, const std::filesystem::path& out);

/// Where a sequence lies, given the folder that holds all of them.
[[nodiscard]] std::filesystem::path folderOf(const Sequence& sequence, const std::filesystem::path& data);

/// Why a sequence cannot be run with a variant ("missing", "no masks"); empty: it can.
[[nodiscard]] std::string whyNot(const Plan& plan, const Cell& cell, const std::filesystem::path& data);

/// The options of a run with as many key points as its variant has. Throws core::InputError when a file that the plan
/// names is absent or wrong.
[[nodiscard]] pipeline::SlamOptions optionsOf(const Plan& plan, const Cell& cell, const std::filesystem::path& data);

/// A whole configuration with so many key points more. Throws core::InputError where fewer than 50 would be left.
[[nodiscard]] std::string withKeyPoints(const std::string& configuration, int more);

/// The camera file of a sequence; empty: the sequence has its own. Throws core::InputError when it is not there.
[[nodiscard]] std::filesystem::path cameraOf(const Plan& plan, std::size_t sequence);

/// What a sequence holds, as JSON: digests of lists, truth, camera, how many images and masks. Lists and sizes stand
/// for the images.
[[nodiscard]] std::string contentsOf(const Plan& plan, std::size_t sequence, const std::filesystem::path& data);

/// All that determines what a run finds, as JSON: version of the program, configuration, how many images, network, and
/// the contents of the sequence.
[[nodiscard]] std::string identityOf(const Plan& plan, const Cell& cell, const std::string& contents,
                                     const std::string& configuration, const std::string& version);

/// The result, where the cell was finished and is still the one that `identity` tells of.
[[nodiscard]] std::optional<RunResult> finishedResult(const Cell& cell, const std::string& identity);

/// Empties the folder and claims it for `identity`. Throws core::InputError when the disk does not let it.
void beginCell(const Cell& cell, const std::string& identity);

/// Puts the evaluation (`wardslam eval --json`; empty: it was not possible, for `trouble`) beside the run in
/// folder/run; from now on the cell is finished. Throws core::InputError when it is not what it should be.
RunResult finishCell(const Cell& cell, const std::string& evaluation, const std::string& trouble);

}  // namespace wardslam::reproduction

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "gates/gates_support.h"
#include "wardslam/evaluation/absolute_trajectory_error.h"
#include "wardslam/exchange/tum_trajectory.h"

/// Two wards that are equal to the vertex, and the corridor between them; a hand covers the lens twice on the
/// way.
namespace wardslam::gates {
namespace {

namespace fs = std::filesystem;
using OneRun = gates::Run;  // gtest's Test has a Run of its own

constexpr double kLargestError_m = 1.0;  // the wards are 9 m apart; drift is a hand's breadth

class EqualWards : public ::testing::Test {
 protected:
  static fs::path folder() { return fs::path(WARDSLAM_GATES_DIR) / "equal_wards"; }

  static void SetUpTestSuite() {
    fs::remove_all(folder());
    fs::create_directories(folder());
    std::ofstream(folder() / "small.yaml") << "features: {key_points: 700}\nmapping: {enabled: false}\n";
    rendering_ = render(folder() / "wards.rawlog",
                        {"--scene", "hospital", "--route", "wards", "--people", "none", "--cover", "25:4.5", "--cover",
                         "52:4.5", "--seed", "2", "--rate", "4", "--seconds", "80"});
  }
  static void TearDownTestSuite() { fs::remove_all(folder()); }

  /// Every piece lies rightly in itself, the one in the map and those beside it; each has a frame of its own.
  static void expectThatNoPieceIsBent(const std::vector<std::string>& mode) {
    std::vector<std::string> arguments{"--config", (folder() / "small.yaml").string(), "--filter", "off"};
    arguments.insert(arguments.end(), mode.begin(), mode.end());
    const OneRun tracked = run(rendering_, folder() / "run", arguments);
    ASSERT_GE(tracked.summary().at("lost_events"), 2) << "else nothing is asked of joins";
    std::size_t pieces = 0;
    for (const auto& file : fs::directory_iterator(tracked.out)) {
      const std::string name = file.path().filename().string();
      if (name != "trajectory.txt" && name.rfind("trajectory_piece_", 0) != 0) continue;
      const auto trajectory = exchange::readTumTrajectory(file.path());
      if (trajectory.size() < 3) continue;
      ++pieces;
      EXPECT_LT(evaluation::absoluteTrajectoryError(rendering_.truth(), trajectory).translation_m.max, kLargestError_m)
          << name;
    }
    EXPECT_GE(pieces, 1U);
  }

  static inline Rendering rendering_;
};

TEST_F(EqualWards, AreNotTakenForEachOther) { expectThatNoPieceIsBent({"--deterministic"}); }

TEST_F(EqualWards, AreNotTakenForEachOtherWithThreads) { expectThatNoPieceIsBent({}); }

}  // namespace
}  // namespace wardslam::gates

#include "wardslam/reproduction/published_figures.h"

#include <gmock/gmock.h>

#include <cmath>

#include "support/temporary_folder.h"
#include "wardslam/core/data_files.h"
#include "wardslam/core/errors.h"

namespace wardslam::reproduction {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(PublishedFigures, KeepTheirDigits) {
  const test::TemporaryFolder folder;
  const auto systems = readPublishedFigures(folder.write(
      "p.yaml",
      "systems:\n- {name: A, source: here, tables: [2, 3], figures: {ward: {ate_rmse_m: 0.0150, filter_ms: 3}}}\n"
      "- {name: B, source: there, gpu: true, alignment: Sim(3), tables: [2], figures: {ward: {}}}\n"
      "- {name: C, source: there, gpu: true, tables: [2], figures: {ward: {}}}\n"));
  ASSERT_EQ(systems.size(), 3U);
  EXPECT_EQ(systems[0].of("ward", "ate_rmse_m"), "0.0150");
  EXPECT_EQ(systems[0].of("ward", "ate_mean_m"), "–");
  EXPECT_EQ(systems[0].of("corridor", "ate_rmse_m"), "–");
  EXPECT_TRUE(systems[0].isIn(3));
  EXPECT_FALSE(systems[0].isIn(1));
  EXPECT_EQ(systems[0].heading(), "A");
  EXPECT_EQ(systems[1].heading(), "B (GPU, Sim(3))");
  EXPECT_EQ(systems[2].heading(), "C (GPU)");
}

TEST(PublishedFigures, SayWhereAFileIsWrong) {
  const test::TemporaryFolder folder;
  const auto expectRefused = [&](const std::string& system, const std::string& why) {
    EXPECT_THAT([&] { (void)readPublishedFigures(folder.write("p.yaml", "systems:\n- " + system + "\n")); },
                ThrowsMessage<core::InputError>(AllOf(HasSubstr("p.yaml:2: "), HasSubstr(why))));
  };
  expectRefused("{name: A, source: s, tables: [1], figures: {w: {ate_rmse: 1}}}", "did you mean 'ate_rmse_m'?");
  expectRefused("{name: A, source: s, tables: [1], figures: {w: {ate_rmse_m: -1}}}", "not negative");
  expectRefused("{name: A, source: s, tables: [1], figures: {w: {ate_rmse_m: few}}}", "a number");
  expectRefused("{name: A, source: s, tables: [8], figures: {}}", "1 to 7");
  expectRefused("{name: A, tables: [1], figures: {}}", "'source'");
  expectRefused("{name: A, source: s, alignment: SE3, tables: [1], figures: {}}", "SE(3) or Sim(3)");
}

TEST(PublishedFigures, ThoseThatComeWithTheProgramAreThePapers) {
  const auto systems = readPublishedFigures(core::findDataFile("reproduction/published.yaml"));
  std::size_t inTable1 = 0;
  double sum = 0.0;
  for (const auto& system : systems) {
    if (!system.isIn(1)) continue;
    ++inTable1;
    for (const auto& [sequence, figures] : system.figures) sum += std::stod(figures.at("ate_rmse_m"));
  }
  EXPECT_EQ(inTable1, 2U) << "ORB-SLAM2 and the paper";
  // ORB-SLAM2 0.3575 + 0.6770 + 0.5186 + 0.0082 + 0.0094 + 0.0205, the paper 0.0104 + 0.0164 + 0.0923 + 0.0065 + 0.0088
  // + 0.0145
  EXPECT_NEAR(sum, 1.5912 + 0.1489, 1e-9);
}

}  // namespace
}  // namespace wardslam::reproduction

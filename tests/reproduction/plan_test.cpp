#include "wardslam/reproduction/plan.h"

#include <gmock/gmock.h>

#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"

namespace wardslam::reproduction {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const std::string kRest = "variants: [{name: ours}]\nsequences: [{name: ward}]\n";

class ReadPlan : public ::testing::Test {
 protected:
  [[nodiscard]] Plan read(const std::string& yaml) const { return readPlan(folder_.write("plan.yaml", yaml)); }
  void expectRefused(const std::string& yaml, const std::string& where, const std::string& why) const {
    EXPECT_THAT([&] { (void)read(yaml); },
                ThrowsMessage<core::InputError>(AllOf(HasSubstr("plan.yaml" + where), HasSubstr(why))));
  }

  test::TemporaryFolder folder_;
};

TEST_F(ReadPlan, TakesWhatIsToldAndDefaultsForTheRest) {
  const Plan plan = read(
      "title: T\nrepetitions: 3\nkey_points_step: 10\nmax_frames: 50\n"
      "variants:\n  - {name: without, filter: off}\n  - {name: letter, filter: paper, n: 5, delta: 3, match_outliers: "
      "true, "
      "network: depth}\n"
      "sequences:\n  - {name: ward, camera: cameras/x.yaml, masks: masks}\n"
      "  - {name: far, folder: elsewhere, fetch: {url: 'https://host/far.tgz', size_bytes: 12}}\n");
  EXPECT_EQ(plan.title, "T");
  EXPECT_EQ(plan.repetitions, 3);
  EXPECT_EQ(plan.max_frames, 50);
  EXPECT_FALSE(plan.mapping);
  ASSERT_EQ(plan.variants.size(), 2U);
  EXPECT_EQ(plan.variants[0].filter, Filter::Off);
  EXPECT_EQ(plan.variants[0].n, 21);
  EXPECT_EQ(plan.variants[0].delta, 55);
  EXPECT_EQ(plan.variants[1].filter, Filter::Paper);
  EXPECT_EQ(plan.variants[1].n, 5);
  EXPECT_EQ(plan.variants[1].delta, 3);
  EXPECT_TRUE(plan.variants[1].match_outliers);
  EXPECT_EQ(plan.variants[1].network, "depth");
  ASSERT_EQ(plan.sequences.size(), 2U);
  EXPECT_EQ(plan.sequences[0].folder, "ward") << "that of its name";
  EXPECT_EQ(plan.sequences[0].ground_truth, "groundtruth.txt");
  EXPECT_EQ(plan.sequences[1].folder, "elsewhere");
  EXPECT_EQ(plan.sequences[1].fetch.url, "https://host/far.tgz");
  EXPECT_EQ(plan.sequences[1].fetch.size_bytes, 12.0);
}

TEST_F(ReadPlan, HasTheNameOfItsFileForATitle) { EXPECT_EQ(read(kRest).title, "plan"); }

TEST_F(ReadPlan, SaysWhereAPlanIsWrongAndWhatWasProbablyMeant) {
  expectRefused("repetition: 3\n" + kRest, ":1: ", "'repetition': unknown key; did you mean 'repetitions'?");
  expectRefused("repetitions: 0\n" + kRest, ":1: ", "outside [1, 1000]");
  expectRefused("variants:\n  - {name: a, filtr: off}\nsequences: [{name: s}]\n", ":2: ", "did you mean 'filter'?");
  expectRefused("variants:\n  - {name: a, filter: none}\nsequences: [{name: s}]\n",
                ":2: ", "'none' is none of: off, geometric, paper, on");
  expectRefused("variants: [{name: a}]\nsequences:\n- name: s\n  mask: m\n", ":4: ", "did you mean 'masks'?");
  expectRefused("variants: [{name: a}]\nsequences:\n- name: s\n  fetch:\n    ulr: x\n", ":5: ", "did you mean 'url'?");
  expectRefused("sequences: [{name: s}]\n", ":1: ", "'variants' is to list at least one");
  expectRefused("variants: [{name: a}]\nsequences: []\n", ":2: ", "'sequences' is to list at least one");
}

TEST_F(ReadPlan, RefusesNamesThatAreNoFoldersAndNamesGivenTwice) {
  const auto named = [](const std::string& names) { return "variants: [" + names + "]\nsequences: [{name: s}]\n"; };
  expectRefused(named("{filter: off}"), ":1: ", "'name' is missing");
  expectRefused(named("{name: a/b}"), ":1: ", "'a/b' cannot be the name of a folder");
  expectRefused(named("{name: ..}"), ":1: ", "'..' cannot be the name of a folder");
  expectRefused(named("{name: a}, {name: a}"), ":1: ", "'variants[1].name': 'a' is the name of an earlier one");
}

TEST_F(ReadPlan, RefusesWhatCannotBeMeant) {
  const auto variant = [](const std::string& text) {
    return "variants: [{name: a, " + text + "}]\nsequences: [{name: s}]\n";
  };
  expectRefused(variant("n: 20"), ":1: ", "20 is even");
  expectRefused(variant("n: 5, delta: 25"), ":1: ", "can never be exceeded: the descriptor has 25 cells");
  expectRefused(variant("filter: geometric, match_outliers: true"), ":1: ", "descriptors need");
  const auto sequence = [](const std::string& text) {
    return "variants: [{name: a}]\nsequences: [{name: s, " + text + "}]\n";
  };
  expectRefused(sequence("fetch: {url: 'ftp://host/s.zip'}"), ":2: ", "https://");
  expectRefused(sequence("fetch: {url: 'https://host/s.rar'}"), ":2: ", ".zip");
  expectRefused(sequence("fetch: {url: 'https://host/s.zip', sha256: abc}"), ":2: ", "64 hexadecimal digits");
  expectRefused(sequence("render: --scene ward, fetch: {url: 'https://host/s.zip'}"), ":2: ", "one of both");
}

TEST(KeyPointsMore, BeginsWithNoneAndGoesUpAndDown) {
  Plan plan;
  plan.key_points_step = 20;
  const std::vector<int> expected = {0, 20, -20, 40, -40, 60};
  for (int i = 0; i < 6; ++i) EXPECT_EQ(keyPointsMore(plan, i), expected[static_cast<std::size_t>(i)]) << i;
}

TEST(Variant, TheMainOnesHaveThePapersParametersAndNoOutlierTest) {
  Variant variant;
  EXPECT_TRUE(variant.isMain());
  variant.match_outliers = true;
  EXPECT_FALSE(variant.isMain());
  variant = {};
  variant.n = 5;
  EXPECT_FALSE(variant.isMain());
}

}  // namespace
}  // namespace wardslam::reproduction

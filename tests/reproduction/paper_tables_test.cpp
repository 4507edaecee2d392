#include "wardslam/reproduction/paper_tables.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace wardslam::reproduction {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

RunResult errorOf(double rmse_m) {
  RunResult result;
  result.ate_rmse_m = rmse_m;
  result.ate_sim3_rmse_m = rmse_m / 2;
  result.ate_mean_m = result.ate_median_m = rmse_m;
  result.ate_std_m = 0.0;
  result.rpe_translation_mps = 0.5;
  result.rpe_rotation_degps = 0.25;
  result.coverage = 1.0;
  result.filter_ms = 3.04;
  result.frame_ms = 12.0;
  return result;
}

Variant named(const std::string& name, Filter filter, int n = 21, int delta = 55, bool matchOutliers = false) {
  Variant variant;
  variant.name = name;
  variant.filter = filter;
  variant.n = n;
  variant.delta = delta;
  variant.match_outliers = matchOutliers;
  return variant;
}

class PaperTables : public ::testing::Test {
 protected:
  PaperTables() {
    for (const char* name : {"ward", "corridor", "lobby"}) {
      plan_.sequences.emplace_back();
      plan_.sequences.back().name = name;
    }
    plan_.variants = {named("off", Filter::Off), named("letter", Filter::Paper), named("small", Filter::Paper, 5, 3),
                      named("letter P6", Filter::Paper, 21, 55, true)};
    for (std::size_t variant = 0; variant < 4; ++variant) results_.setAbsent(2, variant, "missing");
    results_.add(0, 0, errorOf(0.4));
    for (const double rmse_m : {0.02, 0.01, 0.06}) results_.add(0, 1, errorOf(rmse_m));
    results_.add(0, 3, errorOf(0.01));
    results_.add(1, 1, errorOf(0.01));
    results_.add(1, 3, errorOf(0.02));
    published_.push_back({"Rival", "its paper", "Sim(3)", true, {2}, {{"ward", {{"ate_rmse_m", "0.030"}}}}});
    published_.push_back({"Other", "its paper", "", false, {2}, {{"corridor", {{"ate_rmse_m", "0.5"}}}}});
    published_.push_back({"Stranger", "its paper", "", false, {2}, {{"street", {{"ate_rmse_m", "0.9"}}}}});
    published_.push_back({"Clock", "its paper", "", false, {7}, {{"dynamic", {{"filter_ms", "17.21"}}}}});
  }

  [[nodiscard]] Table table(const std::string& name) const {
    for (Table& it : paperTables(plan_, published_, results_)) {
      if (it.name == name) return std::move(it);
    }
    return {};
  }

  Plan plan_;
  std::vector<PublishedSystem> published_;
  Results results_;
};

TEST_F(PaperTables, Table2HasThePublishedFiguresAndOursInBothAlignments) {
  const Table ate = table("table_2");
  EXPECT_THAT(ate.headings, ElementsAre("Sequence", "Rival (GPU, Sim(3))", "Other", "off SE(3)", "off Sim(3)",
                                        "letter SE(3)", "letter Sim(3)"))
      << "who has no figure of these sequences has no column, nor has who differs in n, delta or P6";
  EXPECT_THAT(ate.rows[0], ElementsAre("ward", "0.030", "–", "0.4000", "0.2000", "0.0200 [0.0100–0.0600]",
                                       "0.0100 [0.0050–0.0300]"));
  EXPECT_THAT(ate.rows[1], ElementsAre("corridor", "–", "0.5", "–", "–", "0.0100", "0.0050"));
  EXPECT_THAT(ate.rows[2], ElementsAre("lobby", "–", "–", "missing", "missing", "missing", "missing"));
  EXPECT_THAT(ate.notes, Contains("Rival (GPU, Sim(3)); Other: its paper."));
}

TEST_F(PaperTables, Tables1And3And4HaveThePapersColumns) {
  EXPECT_THAT(table("table_1").headings, ElementsAre("Sequence", "off RMSE", "off Mean", "off STD", "off Median",
                                                     "letter RMSE", "letter Mean", "letter STD", "letter Median"));
  EXPECT_THAT(table("table_3").rows[0], ElementsAre("ward", "0.5000", "0.5000 [0.5000–0.5000]"));
  EXPECT_THAT(table("table_4").rows[1], ElementsAre("corridor", "–", "0.2500"));
}

TEST_F(PaperTables, Table5ComparesThoseThatDifferInParametersAlone) {
  EXPECT_THAT(table("table_5").headings, ElementsAre("Sequence", "letter", "small"));
  plan_.variants[2].network = "depth";
  EXPECT_TRUE(table("table_5").name.empty()) << "none is left";
}

TEST_F(PaperTables, Table6SaysWhetherTheOutlierTestHelps) {
  const Table outliers = table("table_6");
  EXPECT_THAT(outliers.headings, ElementsAre("Sequence", "letter RMSE", "letter Mean", "letter Median", "letter S.D.",
                                             "letter P6 RMSE", "letter P6 Mean", "letter P6 Median", "letter P6 S.D."));
  // ward: 0.02 to 0.01, half; corridor: 0.01 to 0.02, twice; in the middle of 0.5 and 2: 1.25.
  EXPECT_THAT(outliers.notes,
              ElementsAre("'letter P6' against 'letter': lower RMSE on 1, higher on 1 of 2 sequences, 1.250 "
                          "times in the middle."));
}

TEST_F(PaperTables, Table7HasThePapersCasesBeforeTheSequences) {
  const Table times = table("table_7");
  EXPECT_THAT(times.headings,
              ElementsAre("Sequence", "Clock", "letter filter", "off whole image", "letter whole image"));
  ASSERT_EQ(times.rows.size(), 5U);
  EXPECT_THAT(times.rows[0], ElementsAre("dynamic", "17.21", "–", "–", "–"));
  EXPECT_THAT(times.rows[1], ElementsAre("stationary", "–", "–", "–", "–"));
  EXPECT_THAT(times.rows[2], ElementsAre("ward", "–", "3.0 [3.0–3.0]", "12.0", "12.0 [12.0–12.0]"));
}

TEST_F(PaperTables, TheRunsComeFirstWithTheirCoverage) {
  const auto tables = paperTables(plan_, published_, results_);
  ASSERT_FALSE(tables.empty());
  EXPECT_EQ(tables[0].name, "runs");
  ASSERT_EQ(tables[0].rows.size(), 3U * 4U);
  EXPECT_THAT(tables[0].rows[1], ElementsAre("ward", "letter", "3", "0.0200 [0.0100–0.0600]", "0.0100 [0.0050–0.0300]",
                                             "0.5000 [0.5000–0.5000]", "0.250 [0.250–0.250]", "1.000 [1.000–1.000]"));
  EXPECT_THAT(tables[0].rows[8],
              ElementsAre("lobby", "off", "0", "missing", "missing", "missing", "missing", "missing"));
}

TEST_F(PaperTables, ProgramsGetEveryFigureOnALineOfItsOwn) {
  const Table all = allFigures(plan_, results_);
  EXPECT_EQ(all.rows.size(), 3U * 4U * 10U);
  EXPECT_THAT(all.rows, Contains(ElementsAre("ward", "letter", "ate_rmse_se3", "m", "0.020000", "0.010000", "0.060000",
                                             "0.030000", "3", "3")));
  EXPECT_THAT(all.rows, Contains(ElementsAre("lobby", "off", "coverage", "1", "–", "–", "–", "–", "0", "0")));
}

}  // namespace
}  // namespace wardslam::reproduction

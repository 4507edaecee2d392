#include "wardslam/reproduction/results.h"

#include <gmock/gmock.h>

#include <cmath>

#include "wardslam/core/errors.h"

namespace wardslam::reproduction {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr const char* kSummary =
    R"({"coverage": 0.75, "stages": {"filters.apply": {"calls": 4, "median_ms": 9.5}, "pipeline.process": {"calls": 4, "median_ms": 21.0}}})";

TEST(RunResult, IsReadFromEvaluationAndSummary) {
  const auto result = toRunResult(
      R"({"ate": {"rmse": 0.02, "mean": 0.015, "median": 0.01, "std": 0.005}, "ate_sim3": {"rmse": 0.018, "scale": 1.01},
          "coverage": 0.4, "rpe": {"translation_m_per_s": {"rmse": 0.03}, "rotation_deg_per_s": {"rmse": null}}})",
      kSummary);
  EXPECT_EQ(result.ate_rmse_m, 0.02);
  EXPECT_EQ(result.ate_mean_m, 0.015);
  EXPECT_EQ(result.ate_median_m, 0.01);
  EXPECT_EQ(result.ate_std_m, 0.005);
  EXPECT_EQ(result.ate_sim3_rmse_m, 0.018);
  EXPECT_EQ(result.rpe_translation_mps, 0.03);
  EXPECT_TRUE(std::isnan(result.rpe_rotation_degps));
  EXPECT_EQ(result.coverage, 0.75) << "of the images of the run, which may be the first of a longer recording";
  EXPECT_EQ(result.filter_ms, 9.5);
  EXPECT_EQ(result.frame_ms, 21.0);
}

TEST(RunResult, WithoutAnEvaluationHasNoErrors) {
  const auto result = toRunResult("", kSummary, "there are 0 poses");
  EXPECT_TRUE(std::isnan(result.ate_rmse_m));
  EXPECT_EQ(result.coverage, 0.75);
  EXPECT_EQ(result.trouble, "there are 0 poses");
}

TEST(RunResult, RefusesWhatIsDamaged) {
  EXPECT_THROW((void)toRunResult("", "{\"coverage\": 1"), core::InputError);
  EXPECT_THROW((void)toRunResult("[]", kSummary), core::InputError);
}

TEST(Spread, OfRepetitions) {
  const Spread odd = spreadOf({3.0, 1.0, 8.0});
  EXPECT_EQ(odd.median, 3.0);
  EXPECT_EQ(odd.min, 1.0);
  EXPECT_EQ(odd.max, 8.0);
  EXPECT_EQ(odd.mean, 4.0);
  EXPECT_EQ(odd.known, 3U);
  EXPECT_EQ(odd.runs, 3U);
  const Spread even = spreadOf({4.0, kNaN, 1.0, 2.0, 7.0});
  EXPECT_EQ(even.median, 3.0) << "between 2 and 4";
  EXPECT_EQ(even.known, 4U);
  EXPECT_EQ(even.runs, 5U) << "a run that has no figure counts";
  EXPECT_TRUE(std::isnan(spreadOf({}).median));
}

TEST(Results, KnowWhatIsAbsentAndWhy) {
  Results results;
  RunResult run;
  run.coverage = 0.5;
  results.add(1, 2, run);
  results.setAbsent(0, 0, "missing");
  ASSERT_EQ(results.of(1, 2).size(), 1U);
  EXPECT_EQ(results.spread(1, 2, [](const RunResult& it) { return it.coverage; }).median, 0.5);
  EXPECT_TRUE(results.of(2, 1).empty());
  EXPECT_EQ(results.whyAbsent(0, 0), "missing");
  EXPECT_EQ(results.whyAbsent(1, 2), "");
}

}  // namespace
}  // namespace wardslam::reproduction

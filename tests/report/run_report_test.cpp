#include "wardslam/report/run_report.h"

#include <gmock/gmock.h>

#include "report/run_folder.h"

namespace wardslam::report {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// With a library for plots of which nothing is known but its names.
class RunReport : public ::testing::Test {
 protected:
  RunReport() {
    library.write("dygraph.min.js", "/* library */");
    library.write("dygraph.min.css", "");
    options.plotLibrary = library.path();
  }

  RunFolderByHand folder;
  test::TemporaryFolder library;
  ReportOptions options;
};

TEST_F(RunReport, ShowsWhatTheRunFound) {
  const Report report = makeReport(folder.path(), options);
  EXPECT_THAT(report.missing, IsEmpty());
  EXPECT_THAT(report.html,
              AllOf(HasSubstr("<dt>of these with a pose</dt><dd>75.0 %</dd>"),
                    HasSubstr("<dt>times lost</dt><dd>1</dd>"), HasSubstr("<dt>memory at most</dt><dd>123 MB</dd>")));
  EXPECT_THAT(report.html, HasSubstr("<td>2.0 s</td><td class=\"number\">3.0 s</td><td class=\"number\">1</td>"
                                     "<td>found again</td>"));
  // Bars are as long as the root of the time: sqrt(1.5 / 6) is half.
  EXPECT_THAT(report.html, AllOf(HasSubstr("<td>odometry.track</td>"), HasSubstr("median\" style=\"width:50.0%\"")));
  EXPECT_THAT(report.html, AllOf(HasSubstr("min_inliers: 20"), HasSubstr("<td>wardslam</td><td>0.1.0</td>")));
  EXPECT_THAT(report.html,
              AllOf(HasSubstr("/* library */"), HasSubstr("id=\"plot-dynamic\""), Not(HasSubstr("id=\"plot-error\""))));
  EXPECT_THAT(report.html, AllOf(HasSubstr("<section id=\"rooms\">"), HasSubstr("<summary>7 things</summary>")));
}

TEST_F(RunReport, ComparesWithTheTruth) {
  core::Trajectory truth;
  for (int i = 0; i < 4; ++i) {
    truth.push_back({900.0 + i, Eigen::Isometry3d(Eigen::Translation3d(5.0, 0.1 * i, 0.0))});
  }
  options.groundTruth = truth;
  const std::string html = makeReport(folder.path(), options).html;
  EXPECT_THAT(html, AllOf(HasSubstr("RMSE (ATE)</dt><dd>0.0000 m</dd>"), HasSubstr("class=\"truth\" d="),
                          HasSubstr("id=\"plot-error\"")));
}

TEST_F(RunReport, TellsWhyItDoesNotCompare) {
  options.groundTruth = core::Trajectory{{10.0, Eigen::Isometry3d::Identity()}};
  const Report report = makeReport(folder.path(), options);
  EXPECT_THAT(report.missing, ElementsAre(HasSubstr("not compared with the truth")));
  EXPECT_THAT(report.html, HasSubstr("not compared with the truth"));
}

TEST_F(RunReport, LoadsNothingFromElsewhere) {
  const std::string html = makeReport(folder.path(), options).html;
  EXPECT_THAT(html, HasSubstr("default-src 'none'"));
  for (const char* part : {"src=\"http", "href=\"http", "url(http", "@import", "<link", "src=\"/"}) {
    EXPECT_THAT(html, Not(HasSubstr(part)));
  }
}

TEST_F(RunReport, EscapesWhatFilesSay) {
  folder.write("config.yaml", "</pre><script>alert(1)</script>");
  const std::string html = makeReport(folder.path(), options).html;
  EXPECT_THAT(html, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(html, AllOf(HasSubstr("&lt;/pre&gt;"), HasSubstr("odometry.&lt;lost&gt;")));
}

TEST_F(RunReport, OfWhatIsLeftTellsWhatIsNot) {
  for (const char* name : {"summary.json", "frames.csv", "map.wardmap", "trajectory.txt"}) folder.remove(name);
  const std::string html = makeReport(folder.path(), options).html;
  EXPECT_THAT(html, AllOf(HasSubstr("<li>summary.json is not there"), HasSubstr("<li>frames.csv is not there"),
                          HasSubstr("<li>map.wardmap is not there"), HasSubstr("<li>trajectory.txt is not there")));
  EXPECT_THAT(html, AllOf(HasSubstr("<li>The run wrote no pictures"), HasSubstr("<li>No true way is given")));
  EXPECT_THAT(html, AllOf(HasSubstr("min_inliers: 20"), Not(HasSubstr("<svg"))));
}

TEST_F(RunReport, WithoutTheLibraryForPlotsSaysSo) {
  options.plotLibrary = folder.path() / "none";
  const Report report = makeReport(folder.path(), options);
  EXPECT_THAT(report.missing, ElementsAre("Plots are missing: dygraphs is not installed (in Debian: libjs-dygraphs)."));
  EXPECT_THAT(report.html, AllOf(HasSubstr("<section id=\"map\">"), Not(HasSubstr("id=\"plot-"))));
}

TEST_F(RunReport, SurvivesASummaryThatSaysOtherThings) {
  folder.write("summary.json", R"({"frames": "many", "coverage": null, "stages": {"a": 7, "b": {"p95_ms": "x"}},
    "zones": [1], "events": {"e": {"x": 1}}, "versions": 3, "pictures": []})");
  EXPECT_THAT(makeReport(folder.path(), options).html, AllOf(HasSubstr("<td>e</td>"), Not(HasSubstr("many"))));
}

}  // namespace
}  // namespace wardslam::report

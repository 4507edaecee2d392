#include "wardslam/report/tables_page.h"

#include <gmock/gmock.h>

namespace wardslam::report {
namespace {

using reproduction::Table;
using reproduction::TableCollection;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

Table runs() {
  Table table = {"runs",
                 "What was run <in full>",
                 {"Sequence", "Variant", "ATE [m]"},
                 {{"ward", "n = 5 & δ = 3", "0.0104 [0.0101–0.0110]"}, {"lobby", "7", "missing"}},
                 {"Ours < theirs.", "Rival: its paper."}};
  table.labels = 2;
  return table;
}

TEST(TablesPage, HasTheTablesWithTheirNotes) {
  const std::string html = makeTablesPage({"Rooms", "2 of 3 runs are done.", {}, {runs()}});
  EXPECT_THAT(html, AllOf(HasSubstr("<title>Rooms</title>"), HasSubstr("<h1>Rooms</h1>"),
                          HasSubstr("<p>2 of 3 runs are done.</p>"),
                          HasSubstr("<section id=\"runs\"><h2>What was run &lt;in full&gt;</h2>"),
                          HasSubstr("<p class=\"key\">Ours &lt; theirs.</p>\n<p class=\"key\">Rival: its paper.</p>")));
  EXPECT_THAT(html, Not(HasSubstr("class=\"missing\"")));
}

TEST(TablesPage, LabelsStandToTheLeftAndFiguresToTheRightOfTheirColumns) {
  const std::string html = makeTablesPage({"Rooms", "", {}, {runs()}});
  EXPECT_THAT(html, HasSubstr("<th>Sequence</th><th>Variant</th><th class=\"number\">ATE [m]</th>"));
  EXPECT_THAT(html,
              HasSubstr("<td>ward</td><td>n = 5 &amp; δ = 3</td><td class=\"number\">0.0104 [0.0101–0.0110]</td>"));
  EXPECT_THAT(html, HasSubstr("<td>lobby</td><td>7</td><td class=\"number\">missing</td>"));
}

TEST(TablesPage, WhatIsMissingStandsBeforeTheTables) {
  const std::string html = makeTablesPage({"Rooms", "", {"lobby: missing", "ward: <failed>"}, {runs()}});
  const auto list = html.find("<ul class=\"missing\">\n<li>lobby: missing</li>\n<li>ward: &lt;failed&gt;</li>\n</ul>");
  ASSERT_NE(list, std::string::npos);
  EXPECT_LT(list, html.find("<section"));
}

TEST(TablesPage, LoadsNothingFromElsewhere) {
  TableCollection collection = {"<script>alert(1)</script>", "<img src=\"https://x\">", {}, {runs()}};
  const std::string html = makeTablesPage(collection);
  EXPECT_THAT(html, HasSubstr("default-src 'none'"));
  for (const char* part : {"<script", "<img", "url(http", "@import", "<link"}) EXPECT_THAT(html, Not(HasSubstr(part)));
}

}  // namespace
}  // namespace wardslam::report

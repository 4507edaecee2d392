#include "wardslam/viewer/graph_drawing.h"

#include <gmock/gmock.h>

#include <regex>

#include "wardslam/core/data_files.h"
#include "wardslam/knowledge/knowledge_graph.h"

namespace wardslam::viewer {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* kWard = R"(
entities: {night_nurse: [person], cup: [cup, "mug & <glass>"], trolley: [trolley], bed: [bed]}
sets: {people: [night_nurse], moving: [people], movable: [cup, trolley], static: [bed], heavy: [trolley]}
relations: [can_be_moved_by, is_used_by]
facts:
  - [cup, can_be_moved_by, people, {strength: 0.75, reach: 0.25}]
  - [heavy, can_be_moved_by, night_nurse, {strength: 0.5, reach: 1}]
  - [bed, is_used_by, people]
)";

std::string drawingOf(const std::string& text) {
  return drawSvg(knowledge::KnowledgeGraph::fromConfig(core::ConfigNode::fromText(text)));
}

int count(const std::string& text, const std::string& expression) {
  const std::regex regex(expression);
  return static_cast<int>(std::distance(std::sregex_iterator(text.begin(), text.end(), regex), {}));
}

/// Y of the text that reads so.
double heightOf(const std::string& svg, const std::string& text) {
  std::smatch match;
  const std::regex regex("y=\"([0-9.]+)\"[^>]*>" + text + "</text>");
  return std::regex_search(svg, match, regex) ? std::stod(match[1]) : -1.0;
}

TEST(GraphDrawing, ShowsEntitiesInTheFramesOfTheirSets) {
  const std::string svg = drawingOf(kWard);
  for (const char* name : {"night nurse", "cup", "trolley", "bed", "people", "moving", "movable", "static"}) {
    EXPECT_EQ(count(svg, std::string(">") + name + "</text>"), 1) << name;
  }
  EXPECT_THAT(svg, Not(HasSubstr("heavy"))) << "in none of the three sets, so without a frame";
  EXPECT_LT(heightOf(svg, "moving"), heightOf(svg, "people"));
  EXPECT_LT(heightOf(svg, "people"), heightOf(svg, "night nurse"));
}

TEST(GraphDrawing, DrawsALineForEveryFact) {
  const std::string svg = drawingOf(kWard);
  EXPECT_EQ(count(svg, "<path "), 3);
  EXPECT_EQ(count(svg, "stroke-dasharray"), 1) << "is_used_by";
  EXPECT_THAT(svg, HasSubstr(">people, 75 %, 0.25 m</text>"));
  EXPECT_THAT(svg, HasSubstr(">night nurse, 50 %, 1 m</text>"));
  EXPECT_THAT(svg, HasSubstr("stroke-width=\"3.2\"")) << "0.8 + 3.2 * 0.75";
  EXPECT_NEAR(heightOf(svg, "night nurse, 50 %, 1 m"), heightOf(svg, "trolley"), 1.0) << "the one member of 'heavy'";
}

TEST(GraphDrawing, IsWellFormed) {
  const std::string svg = drawingOf(kWard);
  EXPECT_THAT(svg, testing::StartsWith("<svg xmlns="));
  EXPECT_THAT(svg, testing::EndsWith("</svg>\n"));
  EXPECT_THAT(svg, HasSubstr("labels: cup, mug &amp; &lt;glass&gt;"));
  EXPECT_EQ(count(svg, "<text "), count(svg, "</text>"));
  EXPECT_EQ(count(svg, "<g>"), count(svg, "</g>"));
}

TEST(GraphDrawing, KeepsTagsOfOneThingApart) {
  const std::string svg = drawingOf(R"(
entities: {nurse: [person], patient: [], visitor: [], cup: [cup], tray: [tray]}
sets: {moving: [nurse, patient, visitor], movable: [cup, tray]}
relations: [can_be_moved_by]
facts:
  - [cup, can_be_moved_by, nurse]
  - [cup, can_be_moved_by, patient]
  - [cup, can_be_moved_by, visitor]
  - [tray, can_be_moved_by, nurse, {reach: 9}]
)");
  const double first = heightOf(svg, "nurse, 50 %, 0.3 m");
  EXPECT_GE(heightOf(svg, "patient, 50 %, 0.3 m"), first + 12);
  EXPECT_GE(heightOf(svg, "visitor, 50 %, 0.3 m"), first + 24);
  EXPECT_GE(heightOf(svg, "nurse, 50 %, 9 m"), first + 36);
}

TEST(GraphDrawing, DrawsWhatShips) {
  for (const char* name : {"hospital", "living_room", "downtown"}) {
    const auto graph =
        knowledge::KnowledgeGraph::fromFile(core::findDataFile("knowledge/" + std::string(name) + ".yaml"));
    EXPECT_EQ(count(drawSvg(graph), "<title>"), static_cast<int>(graph.entities().size())) << name;
  }
}

}  // namespace
}  // namespace wardslam::viewer

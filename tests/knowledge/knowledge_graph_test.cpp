#include "wardslam/knowledge/knowledge_graph.h"

#include <gmock/gmock.h>

#include "support/complaint.h"
#include "wardslam/core/data_files.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/label_space.h"

namespace wardslam::knowledge {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// The ward of the paper's Fig. 2 in small. Tests that want a mistake in it replace one line.
constexpr const char* kWard =
    "entities:\n"                                                // line 1
    "  health_care_personnel: [person]\n"                        // 2
    "  visitor: [person]\n"                                      // 3
    "  temperature_gun: []\n"                                    // 4
    "  cup: [cup, wine glass]\n"                                 // 5
    "  trolley: [trolley]\n"                                     // 6
    "  bed: [bed]\n"                                             // 7
    "sets:\n"                                                    // 8
    "  people: [health_care_personnel, visitor]\n"               // 9
    "  moving: [people]\n"                                       // 10
    "  equipment: [temperature_gun, trolley]\n"                  // 11
    "  movable: [equipment, cup]\n"                              // 12
    "  static: [bed]\n"                                          // 13
    "relations: [can_be_moved_by, is_used_by]\n"                 // 14
    "facts:\n"                                                   // 15
    "  - [equipment, can_be_moved_by, health_care_personnel]\n"  // 16
    "  - [cup, can_be_moved_by, people]\n"                       // 17
    "  - [bed, is_used_by, visitor]\n";                          // 18

KnowledgeGraph graphOf(const std::string& text) {
  return KnowledgeGraph::fromConfig(core::ConfigNode::fromText(text, "ward.yaml"));
}

std::string wardWith(const std::string& line, const std::string& replacement) {
  std::string text = kWard;
  const auto at = text.find(line);
  if (at == std::string::npos) throw std::logic_error("the ward has no line '" + line + "'");
  return text.replace(at, line.size(), replacement);
}

std::string errorOf(const std::string& text) {
  return test::complaintOf([&] { return graphOf(text); });
}

std::vector<std::string> asText(const std::vector<Fact>& facts) {
  std::vector<std::string> lines;
  for (const Fact& fact : facts) lines.push_back(fact.head + " " + fact.relation + " " + fact.tail);
  return lines;
}

TEST(KnowledgeGraph, SortsEntitiesByTheSetTheyAreIn) {
  const KnowledgeGraph graph = graphOf(kWard);
  EXPECT_TRUE(graph.isMoving("visitor"));
  EXPECT_FALSE(graph.isMovable("visitor"));
  EXPECT_TRUE(graph.isMovable("temperature_gun")) << "through the set 'equipment'";
  EXPECT_EQ(graph.mobility("bed"), Mobility::Static);
  EXPECT_THAT(graph.entities(),
              ElementsAre("bed", "cup", "health_care_personnel", "temperature_gun", "trolley", "visitor"));
}

TEST(KnowledgeGraph, KnowsWhoCanMoveWhat) {
  const KnowledgeGraph graph = graphOf(kWard);
  EXPECT_TRUE(graph.canBeMovedBy("temperature_gun", "health_care_personnel"));
  EXPECT_FALSE(graph.canBeMovedBy("temperature_gun", "visitor"));
  EXPECT_TRUE(graph.canBeMovedBy("cup", "visitor"));
  EXPECT_FALSE(graph.canBeMovedBy("visitor", "cup")) << "a fact has a direction";
  EXPECT_FALSE(graph.canBeMovedBy("bed", "visitor"));
}

TEST(KnowledgeGraph, TellsTheFactsAboutAnEntity) {
  const KnowledgeGraph graph = graphOf(kWard);
  EXPECT_THAT(asText(graph.factsAbout("visitor")),
              ElementsAre("bed is_used_by visitor", "cup can_be_moved_by visitor"));
  EXPECT_THAT(asText(graph.factsAbout("trolley")), ElementsAre("trolley can_be_moved_by health_care_personnel"));
  EXPECT_TRUE(graph.holds("bed", "is_used_by", "visitor"));
  EXPECT_FALSE(graph.holds("bed", "is_used_by", "health_care_personnel"));
  EXPECT_EQ(graph.facts().size(), 3U);
}

TEST(KnowledgeGraph, AFactMayHaveStrengthAndReach) {
  const KnowledgeGraph graph = graphOf(
      wardWith("[cup, can_be_moved_by, people]", "[cup, can_be_moved_by, people, {strength: 0.8, reach: 0.25}]"));
  const Bond bond = graph.bond("cup", kCanBeMovedBy, "visitor");
  EXPECT_DOUBLE_EQ(bond.strength, 0.8);
  EXPECT_DOUBLE_EQ(bond.reach_m, 0.25);
  EXPECT_DOUBLE_EQ(graph.facts()[1].bond.strength, 0.8);
  EXPECT_DOUBLE_EQ(graph.factsAbout("visitor").back().bond.reach_m, 0.25);

  EXPECT_DOUBLE_EQ(graph.bond("trolley", kCanBeMovedBy, "health_care_personnel").strength, Bond{}.strength)
      << "not given: the default";
  EXPECT_DOUBLE_EQ(graph.bond("trolley", kCanBeMovedBy, "visitor").strength, 0.0) << "no such fact";
  EXPECT_THROW(static_cast<void>(graph.bond("trolly", kCanBeMovedBy, "visitor")), core::InputError);
}

TEST(KnowledgeGraph, TheLastFactOverrulesEarlierOnes) {
  const KnowledgeGraph graph = graphOf(std::string(kWard) +
                                       "  - [cup, can_be_moved_by, visitor, {strength: 0.9}]\n"
                                       "  - [movable, can_be_moved_by, health_care_personnel, {reach: 0.7}]\n");
  EXPECT_DOUBLE_EQ(graph.bond("cup", kCanBeMovedBy, "visitor").strength, 0.9);
  EXPECT_DOUBLE_EQ(graph.bond("cup", kCanBeMovedBy, "visitor").reach_m, Bond{}.reach_m);
  EXPECT_DOUBLE_EQ(graph.bond("cup", kCanBeMovedBy, "health_care_personnel").reach_m, 0.7);
  EXPECT_DOUBLE_EQ(graph.bond("trolley", kCanBeMovedBy, "health_care_personnel").reach_m, 0.7);
}

TEST(KnowledgeGraph, TellsItsSetsAsWritten) {
  const KnowledgeGraph graph = graphOf(kWard);
  EXPECT_THAT(graph.sets(), ElementsAre("equipment", "movable", "moving", "people", "static"));
  EXPECT_THAT(graph.contents("movable"), ElementsAre("equipment", "cup"));
  EXPECT_THROW(static_cast<void>(graph.contents("cup")), core::InputError) << "an entity is not a set";
}

TEST(KnowledgeGraph, MapsLabelsToEntitiesBothWays) {
  const KnowledgeGraph graph = graphOf(kWard);
  EXPECT_THAT(graph.entitiesOf("person"), ElementsAre("health_care_personnel", "visitor"));
  EXPECT_THAT(graph.entitiesOf("wine glass"), ElementsAre("cup"));
  EXPECT_THAT(graph.entitiesOf("giraffe"), IsEmpty());
  EXPECT_THAT(graph.labels("cup"), ElementsAre("cup", "wine glass"));
  EXPECT_THAT(graph.labels("temperature_gun"), IsEmpty());
}

TEST(KnowledgeGraph, ExpandsNestedSets) {
  const KnowledgeGraph graph = graphOf(kWard);
  EXPECT_THAT(graph.members("movable"), ElementsAre("cup", "temperature_gun", "trolley"));
  EXPECT_THAT(graph.members("cup"), ElementsAre("cup"));
}

TEST(KnowledgeGraph, AQueryForAnUnknownNameNamesTheNearest) {
  const KnowledgeGraph graph = graphOf(kWard);
  EXPECT_THAT(test::complaintOf([&] { return graph.canBeMovedBy("cup", "visitors"); }),
              HasSubstr("'visitors'; the nearest is 'visitor'"));
  EXPECT_THROW(static_cast<void>(graph.mobility("equipment")), core::InputError) << "a set is not an entity";
  EXPECT_THROW(static_cast<void>(graph.members("equipmnt")), core::InputError);
}

struct Mistake {
  const char* name;
  const char* line;
  const char* replacement;
  std::vector<const char*> message;
};

class KnowledgeMistake : public testing::TestWithParam<Mistake> {};

TEST_P(KnowledgeMistake, IsAnErrorThatSaysWhere) {
  const std::string error = errorOf(wardWith(GetParam().line, GetParam().replacement));
  for (const char* part : GetParam().message) EXPECT_THAT(error, HasSubstr(part));
}

INSTANTIATE_TEST_SUITE_P(
    All, KnowledgeMistake,
    testing::Values(
        Mistake{"UnknownHead", "[cup, can_be", "[cups, can_be", {"ward.yaml:17", "unknown entity", "'cups'", "'cup'"}},
        Mistake{"UnknownTail", "by, people]", "by, peple]", {"ward.yaml:17", "'peple'", "did you mean 'people'"}},
        Mistake{"UnknownMember", "[people]", "[peopel]", {"ward.yaml:10", "'peopel'", "did you mean 'people'"}},
        Mistake{"UnknownRelation",
                "is_used_by, v",
                "is_usd_by, v",
                {"ward.yaml:18", "unknown relation 'is_usd_by'", "did you mean 'is_used_by'"}},
        Mistake{"NoRelations", "relations: [can_be_moved_by, is_used_by]\n", "", {"unknown relation", "'relations'"}},
        Mistake{"StaticThingMoved", "bed, is_used_by", "bed, can_be_moved_by", {"ward.yaml:18", "'bed' is static"}},
        Mistake{"MoverDoesNotMove", "by, people]", "by, trolley]", {"ward.yaml:17", "'trolley' is not in the set"}},
        Mistake{"MoverSetDoesNotMove", "by, people]", "by, equipment]", {"ward.yaml:17", "is not in the set 'moving'"}},
        Mistake{"CircleOfSets",
                "[temperature_gun, trolley]",
                "[temperature_gun, trolley, movable]",
                {"ward.yaml:1", "circle", "equipment > movable > equipment"}},
        Mistake{"SetInItself", "people: [h", "people: [people, h", {"ward.yaml:9", "people > people"}},
        Mistake{"EntityInTwoKinds",
                "static: [bed]",
                "static: [bed, cup]",
                {"ward.yaml:5", "'entities.cup'", "'movable' and 'static'"}},
        Mistake{"EntityInNoKind", "static: [bed]", "static: []", {"ward.yaml:7", "'bed' is in none of the sets"}},
        Mistake{"SetOfKindMissing", "  static: [bed]\n", "", {"ward.yaml:7", "'bed' is in none of the sets"}},
        Mistake{"LabelOfTwoKinds",
                "bed: [bed]",
                "bed: [bed, person]",
                {"ward.yaml:2", "label 'person'", "'bed' and 'health_care_personnel'"}},
        Mistake{"EntityTwice", "  bed: [bed]\n", "  bed: [bed]\n  cup: []\n", {"ward.yaml:8", "'cup' is the name of"}},
        Mistake{"SetNamedLikeEntity",
                "  static: [bed]\n",
                "  static: [bed]\n  cup: [trolley]\n",
                {"ward.yaml:14", "'cup' is the name of"}},
        Mistake{"SetTwice",
                "  static: [bed]\n",
                "  static: [bed]\n  moving: [people]\n",
                {"ward.yaml:14", "'moving' is the name of"}},
        Mistake{"UnknownKey", "facts:", "fact:", {"ward.yaml:15", "unknown key", "did you mean 'facts'"}},
        Mistake{"FactOfTwoParts", "[cup, can_be_moved_by, people]", "[cup, people]", {"ward.yaml:17", "three parts"}},
        Mistake{"FactOfFiveParts", "by, people]", "by, people, {}, {}]", {"ward.yaml:17", "three parts"}},
        Mistake{
            "StrengthTooHigh", "by, people]", "by, people, {strength: 1.5}]", {"ward.yaml:17", "strength", "[0, 1]"}},
        Mistake{"BondMisspelt", "by, people]", "by, people, {strenght: 1}]", {"ward.yaml:17", "'strength'"}},
        Mistake{"BondIsNoMapping", "by, people]", "by, people, 0.8]", {"ward.yaml:17", "mapping"}},
        Mistake{"FactIsNoList", "[cup, can_be_moved_by, people]", "cup", {"ward.yaml:17", "a list"}},
        Mistake{"LabelsAreNoList", "trolley: [trolley]", "trolley: trolley", {"ward.yaml:6", "a list"}},
        Mistake{"LabelWithoutName", "trolley: [trolley]", "trolley: [[]]", {"ward.yaml:6", "a name is expected"}},
        Mistake{"NotYaml", "bed: [bed]", "bed: [bed", {"ward.yaml:", "not valid YAML"}}),
    [](const auto& instance) { return instance.param.name; });

TEST(KnowledgeGraph, AnEmptyFileOrASectionOfTheWrongShapeIsAnError) {
  EXPECT_THAT(errorOf(""), HasSubstr("'entities': a mapping"));
  EXPECT_THAT(errorOf("entities: [person]\n"), HasSubstr("ward.yaml:1: 'entities': a mapping"));
  EXPECT_THAT(errorOf("just text"), HasSubstr("a mapping"));
  EXPECT_THROW(static_cast<void>(KnowledgeGraph::fromFile("/nowhere/ward.yaml")), core::InputError);
}

TEST(HospitalKnowledge, CoversEveryCocoLabel) {
  const KnowledgeGraph graph = KnowledgeGraph::fromFile(core::findDataFile("knowledge/hospital.yaml"));
  const core::LabelSpace coco = core::LabelSpace::coco();
  for (int id = 1; id <= 80; ++id) {
    const std::string& label = coco.name(static_cast<core::ClassId>(id));
    EXPECT_THAT(graph.entitiesOf(label), testing::Not(IsEmpty())) << label;
  }
}

TEST(HospitalKnowledge, SaysWhatThePaperSaysOfTheWard) {
  const KnowledgeGraph graph = KnowledgeGraph::fromFile(core::findDataFile("knowledge/hospital.yaml"));
  for (const char* entity : {"health_care_personnel", "patient", "visitor"}) EXPECT_TRUE(graph.isMoving(entity));
  for (const char* entity : {"temperature_gun", "chair", "wheelchair", "iv_stand", "trolley"}) {
    EXPECT_TRUE(graph.isMovable(entity)) << entity;
    EXPECT_TRUE(graph.canBeMovedBy(entity, "health_care_personnel")) << entity;
  }
  EXPECT_EQ(graph.mobility("bed"), Mobility::Static);
  EXPECT_EQ(graph.mobility("stationary_medical_equipment"), Mobility::Static);
  EXPECT_FALSE(graph.canBeMovedBy("temperature_gun", "visitor"));
}

TEST(HospitalKnowledge, TellsHowLikelyAndFromHowNear) {
  const KnowledgeGraph graph = KnowledgeGraph::fromFile(core::findDataFile("knowledge/hospital.yaml"));
  const auto bond = [&](const char* thing) { return graph.bond(thing, kCanBeMovedBy, "health_care_personnel"); };
  EXPECT_GT(bond("temperature_gun").strength, bond("chair").strength) << "held in the hand whenever somebody is near";
  EXPECT_GT(bond("chair").strength, bond("bedside_cabinet").strength);
  EXPECT_GT(bond("trolley").reach_m, bond("cup").reach_m) << "pushed at arm's length";
}

TEST(DowntownKnowledge, KnowsThatVehiclesMoveByThemselves) {
  const KnowledgeGraph graph = KnowledgeGraph::fromFile(core::findDataFile("knowledge/downtown.yaml"));
  EXPECT_TRUE(graph.isMoving("car"));
  EXPECT_TRUE(graph.canBeMovedBy("bicycle", "pedestrian"));
  EXPECT_FALSE(graph.canBeMovedBy("bicycle", "car"));
  EXPECT_EQ(graph.mobility("traffic_light"), Mobility::Static);
}

TEST(LivingRoomKnowledge, IsConsistent) {
  const KnowledgeGraph graph = KnowledgeGraph::fromFile(core::findDataFile("knowledge/living_room.yaml"));
  EXPECT_TRUE(graph.canBeMovedBy("chair", "guest"));
  EXPECT_FALSE(graph.canBeMovedBy("chair", "pet"));
}

}  // namespace
}  // namespace wardslam::knowledge

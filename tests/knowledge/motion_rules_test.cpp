#include "wardslam/knowledge/motion_rules.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "wardslam/core/data_files.h"
#include "wardslam/knowledge/knowledge_graph.h"

namespace wardslam::knowledge {
namespace {

constexpr core::ClassId kPerson = 1;
constexpr core::ClassId kDog = 17;
constexpr core::ClassId kCup = 42;
constexpr core::ClassId kChair = 57;
constexpr core::ClassId kBed = 60;

MotionRules rulesOf(const std::string& text) {
  return {KnowledgeGraph::fromConfig(core::ConfigNode::fromText(text)), core::LabelSpace::coco()};
}

constexpr const char* kRoom = R"(
entities: {nurse: [person], visitor: [person], pet: [dog], cup: [cup], seat: [chair, sedan], gun: [], bed: [bed]}
sets: {moving: [nurse, visitor, pet], movable: [cup, seat, gun], static: [bed]}
relations: [can_be_moved_by, sleeps_in]
facts:
  - [cup, can_be_moved_by, nurse]
  - [seat, can_be_moved_by, visitor]
  - [seat, can_be_moved_by, pet]
  - [visitor, can_be_moved_by, nurse]
  - [pet, sleeps_in, bed]
)";

TEST(MotionRules, TellsMovingMovableAndStaticClasses) {
  const MotionRules rules = rulesOf(kRoom);
  EXPECT_TRUE(rules.isMoving(kPerson));
  EXPECT_FALSE(rules.isMovable(kPerson));
  EXPECT_TRUE(rules.isMovable(kCup));
  EXPECT_FALSE(rules.isMoving(kCup));
  EXPECT_FALSE(rules.isMoving(kBed) || rules.isMovable(kBed));
  EXPECT_EQ(rules.moving().count(), 2U) << "person, dog";
  EXPECT_EQ(rules.movable().count(), 2U) << "cup, chair; 'sedan' is not in the label space";
}

TEST(MotionRules, ALabelCanWhatOneOfItsEntitiesCan) {
  const MotionRules rules = rulesOf(kRoom);
  EXPECT_TRUE(rules.canBeMovedBy(kCup, kPerson)) << "the person may be a nurse";
  EXPECT_FALSE(rules.canBeMovedBy(kCup, kDog));
  EXPECT_TRUE(rules.canBeMovedBy(kChair, kDog));
  EXPECT_FALSE(rules.canBeMovedBy(kPerson, kCup));
  EXPECT_TRUE(rules.movers(kPerson)[kPerson]) << "a visitor can be moved by a nurse";
  EXPECT_TRUE(rules.movers(kBed).none()) << "other relations move nothing";
  EXPECT_EQ(rules.movers(kChair).count(), 2U);
}

TEST(MotionRules, ALabelHasTheStrongestAndFarthestBondOfItsEntities) {
  const MotionRules rules = rulesOf(R"(
entities: {nurse: [person], visitor: [person], cup: [cup], glass: [cup], bed: [bed]}
sets: {moving: [nurse, visitor], movable: [cup, glass], static: [bed]}
relations: [can_be_moved_by]
facts:
  - [cup, can_be_moved_by, nurse, {strength: 0.9, reach: 0.1}]
  - [cup, can_be_moved_by, visitor, {strength: 0.2, reach: 0.4}]
  - [glass, can_be_moved_by, nurse, {strength: 0.3, reach: 0.2}]
)");
  EXPECT_DOUBLE_EQ(rules.bond(kCup, kPerson).strength, 0.9);
  EXPECT_DOUBLE_EQ(rules.bond(kCup, kPerson).reach_m, 0.4);
  EXPECT_DOUBLE_EQ(rules.bond(kBed, kPerson).strength, 0.0);
  EXPECT_DOUBLE_EQ(rules.bond(kPerson, kCup).strength, 0.0);
}

TEST(MotionRules, WhatTheGraphDoesNotKnowIsStatic) {
  const MotionRules rules = rulesOf(kRoom);
  for (const auto c : std::initializer_list<core::ClassId>{0, 2, 80, 100, 255}) {
    EXPECT_FALSE(rules.isMoving(c) || rules.isMovable(c)) << int{c};
    EXPECT_TRUE(rules.movers(c).none()) << int{c};
  }
}

TEST(MotionRules, HospitalThingsOfARecordingAreKnown) {
  const std::filesystem::path shared = WARDSLAM_SHARED_DIR;
  const auto classes = shared / "data" / "ward_walking" / "classes.txt";
  if (!std::filesystem::exists(classes)) GTEST_SKIP() << classes << " is not here";
  const core::LabelSpace labels = core::LabelSpace::cocoWith(classes);
  const auto hospital = KnowledgeGraph::fromFile(core::findDataFile("knowledge/hospital.yaml"));
  const MotionRules rules(hospital, labels);
  for (const char* name : {"trolley", "iv_stand", "wheelchair", "curtain", "overbed_table", "carton_stack"}) {
    const auto id = labels.find(name);
    ASSERT_TRUE(id.has_value()) << name;
    EXPECT_TRUE(rules.canBeMovedBy(*id, kPerson)) << name;
  }
  for (int id = 1; id <= 255; ++id) {
    const std::string& name = labels.name(static_cast<core::ClassId>(id));
    EXPECT_TRUE(name.empty() || !hospital.entitiesOf(name).empty()) << name;
  }
}

}  // namespace
}  // namespace wardslam::knowledge

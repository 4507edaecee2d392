#include "same_things.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace wardslam::mapping {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

constexpr core::ClassId kChair = 57;
constexpr core::ClassId kBed = 60;
constexpr double kNoMargin_m = 0.0;

/// A row with a box of 1 m × 1 m × `height_m` whose corner is at (x_m, 0, 0).
MapObject object(ObjectId id, core::ClassId classId, double x_m, double height_m = 1.0, double firstSeen_s = 0.0) {
  MapObject object;
  object.id = id;
  object.classId = classId;
  object.box_m = Eigen::AlignedBox3d(Eigen::Vector3d(x_m, 0, 0), Eigen::Vector3d(x_m + 1, 1, height_m));
  object.centroid_m = object.box_m.center();
  object.views = 20;
  object.probability = 0.9;
  object.firstSeen_s = firstSeen_s;
  object.lastSeen_s = firstSeen_s + 4.0;
  return object;
}

/// Objects that both the table and the database have.
class SameThingsTest : public testing::Test {
 protected:
  void add(const MapObject& object) {
    table_.restore(object);
    database_.restore(object.id, ObjectRecord::from(object));
  }
  [[nodiscard]] auto same() const { return sameBoxes(table_, database_, kNoMargin_m); }

  ObjectTable table_{ObjectOptions()};
  ObjectDatabase database_{ObjectOptions()};
};

TEST_F(SameThingsTest, AreThoseWhoseBoxesShareMoreThanHalfOfTheSmaller) {
  add(object(3, kChair, 0.0));
  add(object(7, kChair, 0.4));   // shares .6 with the first
  add(object(9, kChair, 0.95));  // .05 with the first, .45 with the second
  EXPECT_THAT(same(), ElementsAre(Pair(7, 3)));
}

TEST_F(SameThingsTest, MeasureTheSharedPartByTheSmallerBox) {
  add(object(1, kChair, 0.0, 2.0));
  add(object(2, kChair, 0.0, 0.5));  // a quarter of the first, and all inside it
  EXPECT_THAT(same(), ElementsAre(Pair(2, 1)));
}

TEST_F(SameThingsTest, AreOneSideAndTheOtherOfAThingThatFewImagesShow) {
  MapObject side = object(4, kChair, 0.95);
  add(object(3, kChair, 0.0));
  add(side);
  EXPECT_THAT(same(), IsEmpty()) << "many images show both";
  side.views = 3;
  add(side);
  EXPECT_THAT(same(), ElementsAre(Pair(4, 3)));
  side = object(4, kChair, 1.05);
  side.views = 3;
  add(side);
  EXPECT_THAT(same(), IsEmpty()) << "there is a gap";
}

TEST_F(SameThingsTest, AreOfOneClassAndStillThere) {
  add(object(1, kChair, 0.0));
  add(object(2, kBed, 0.0));
  MapObject gone = object(3, kChair, 0.0);
  gone.state = ObjectState::Gone;
  add(gone);
  EXPECT_THAT(same(), IsEmpty());
}

TEST_F(SameThingsTest, AreNotThoseThatImagesToldApart) {
  add(object(1, kChair, 0.0));
  add(object(2, kChair, 0.1));
  Evidence first;
  first.classId = kChair;
  first.size = 50;
  first.onObjects = first.underMask = {{1, 50}};
  Evidence second = first;
  second.onObjects = second.underMask = {{2, 50}};
  ObjectId next = 10;
  database_.observe({first, second}, {{1, 50}, {2, 50}}, 5.0, next);
  EXPECT_THAT(same(), IsEmpty());
}

TEST_F(SameThingsTest, ShareLessWhereAnImageShowedBothAsOne) {
  add(object(1, kChair, 0.0));
  add(object(2, kChair, 0.6));  // shares .4
  EXPECT_THAT(same(), IsEmpty());
  database_.restore({{{1, 2}, {1, 0}}});
  EXPECT_THAT(same(), ElementsAre(Pair(2, 1)));
  database_.restore({{{1, 2}, {1, 1}}});
  EXPECT_THAT(same(), IsEmpty()) << "and another showed two";
  add(object(2, kChair, 0.75));
  database_.restore({{{1, 2}, {1, 0}}});
  EXPECT_THAT(same(), IsEmpty()) << "a quarter";
}

TEST_F(SameThingsTest, AreLookedForAmongThosePairsThatOneIsOfWhichChanged) {
  add(object(1, kChair, 0.0));
  add(object(2, kChair, 0.1));
  add(object(3, kChair, 5.0));
  add(object(4, kChair, 5.1));
  EXPECT_THAT(sameBoxes({3}, table_, database_, kNoMargin_m), ElementsAre(Pair(4, 3)));
  EXPECT_THAT(sameBoxes({1, 2, 4, 9}, table_, database_, kNoMargin_m), ElementsAre(Pair(2, 1), Pair(4, 3)));
  EXPECT_THAT(sameBoxes({}, table_, database_, kNoMargin_m), IsEmpty());
}

/// A chair that is known to be gone since 20 s, and one found since.
class ReappearanceTest : public SameThingsTest {
 protected:
  ReappearanceTest() { movable_.set(kChair); }

  void lose(MapObject lost) {
    lost.state = ObjectState::Gone;
    table_.restore(lost);
    ObjectRecord record = ObjectRecord::from(lost);
    record.gone_s = 20.0;
    database_.restore(lost.id, record);
  }
  void find(const MapObject& found, bool placeWasEmpty = true) {
    table_.restore(found);
    ObjectRecord record = ObjectRecord::from(found);
    record.placeWasEmpty = placeWasEmpty;
    database_.restore(found.id, record);
  }
  [[nodiscard]] std::vector<Reappearance> pairs() const {
    return reappearances(table_, database_, movable_, ObjectOptions());
  }

  knowledge::ClassSet movable_;
};

TEST_F(ReappearanceTest, IsWitnessedWhereTheLossWasKnownAndThePlaceSeenEmptyBefore) {
  lose(object(1, kChair, 0.0));
  find(object(2, kChair, 3.0, 1.0, 30.0));
  ASSERT_EQ(pairs().size(), 1U);
  EXPECT_EQ(pairs()[0].lost, 1U);
  EXPECT_EQ(pairs()[0].found, 2U);
  EXPECT_TRUE(pairs()[0].isWitnessed);
  EXPECT_NEAR(pairs()[0].probability, 0.5 / 0.505, 1e-9) << "at 3 m: half the weight of none, beside 0.005";
}

TEST_F(ReappearanceTest, IsAHintWhereThePlaceWasNotSeenBeforeOrTheLossNotKnown) {
  lose(object(1, kChair, 0.0));
  find(object(2, kChair, 3.0, 1.0, 30.0), false);
  ASSERT_EQ(pairs().size(), 1U);
  EXPECT_FALSE(pairs()[0].isWitnessed);
  EXPECT_NEAR(pairs()[0].probability, 0.3 * 0.15 / 0.155, 1e-9);
  find(object(2, kChair, 3.0, 1.0, 19.0));
  ASSERT_EQ(pairs().size(), 1U);
  EXPECT_FALSE(pairs()[0].isWitnessed) << "it stood there before the other was missed";
}

TEST_F(ReappearanceTest, IsNoneOfWhatIsStillThere) {
  add(object(1, kChair, 0.0));
  find(object(2, kChair, 3.0, 1.0, 30.0));
  EXPECT_THAT(pairs(), IsEmpty());
}

TEST_F(ReappearanceTest, IsNoneOfThingsSeenAtTheSameTime) {
  lose(object(1, kChair, 0.0));
  find(object(2, kChair, 3.0, 1.0, 4.0));
  EXPECT_THAT(pairs(), IsEmpty());
}

TEST_F(ReappearanceTest, AsksForTheClassTheSizeAndWhoCanMoveIt) {
  lose(object(1, kBed, 0.0));         // another class
  lose(object(2, kChair, 1.0, 2.5));  // 2.5 times as long
  find(object(3, kChair, 3.0, 1.0, 30.0));
  find(object(4, kBed, 3.0, 1.0, 30.0));  // nobody can move it
  EXPECT_THAT(pairs(), IsEmpty());
}

TEST_F(ReappearanceTest, AsksForTimeToComeThere) {
  lose(object(1, kChair, 0.0));              // seen until 4 s
  find(object(2, kChair, 40.0, 1.0, 29.0));  // 25 s at 1.5 m/s, and 1 m for a middle seen from another side: 38.5 m
  EXPECT_THAT(pairs(), IsEmpty());
  find(object(2, kChair, 38.0, 1.0, 29.0));
  EXPECT_EQ(pairs().size(), 1U);
}

TEST_F(ReappearanceTest, NoRecordIsInTwoThatAreProbable) {
  lose(object(1, kChair, 0.0));
  lose(object(2, kChair, 1.0));
  find(object(3, kChair, 2.0, 1.0, 30.0));
  find(object(4, kChair, 3.0, 1.0, 30.0));
  std::map<ObjectId, double> sums;
  for (const auto& pair : pairs()) {
    sums[pair.lost] += pair.probability;
    sums[pair.found] += pair.probability;
  }
  EXPECT_EQ(sums.size(), 4U);
  for (const auto& [id, sum] : sums) EXPECT_LE(sum, 1.0) << id;
}

}  // namespace
}  // namespace wardslam::mapping

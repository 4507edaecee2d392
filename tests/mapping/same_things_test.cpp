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
  [[nodiscard]] auto earlier(const MapObject& found) const {
    return earlierPlacesOf(found, table_, database_, SemanticCloud(CloudOptions()));
  }

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

TEST_F(SameThingsTest, FindTheEarlierPlaceOfAThingThatIsGoneFromThere) {
  MapObject gone = object(1, kChair, 0.0);
  gone.state = ObjectState::Gone;
  add(gone);
  const MapObject found = object(2, kChair, 5.0, 1.0, gone.lastSeen_s + 2.0);
  add(found);
  EXPECT_THAT(earlier(found), ElementsAre(1));
}

TEST_F(SameThingsTest, DoNotTakeAThingThatIsStillThereForAnEarlierPlace) {
  add(object(1, kChair, 0.0));
  const MapObject found = object(2, kChair, 5.0, 1.0, 6.0);
  add(found);
  EXPECT_THAT(earlier(found), IsEmpty());
}

TEST_F(SameThingsTest, DoNotTakeThingsSeenAtTheSameTimeForOne) {
  MapObject gone = object(1, kChair, 0.0);
  gone.state = ObjectState::Gone;
  add(gone);
  const MapObject found = object(2, kChair, 5.0, 1.0, gone.lastSeen_s);
  add(found);
  EXPECT_THAT(earlier(found), IsEmpty());
}

TEST_F(SameThingsTest, AskForTheClassAndTheSizeOfWhatWasLost) {
  MapObject otherClass = object(1, kBed, 0.0);
  otherClass.state = ObjectState::Gone;
  add(otherClass);
  MapObject otherSize = object(2, kChair, 2.0, 2.5);  // 2.5 times as long
  otherSize.state = ObjectState::Gone;
  add(otherSize);
  const MapObject found = object(3, kChair, 5.0, 1.0, 6.0);
  add(found);
  EXPECT_THAT(earlier(found), IsEmpty());
}

}  // namespace
}  // namespace wardslam::mapping

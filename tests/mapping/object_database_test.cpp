#include "object_database.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace wardslam::mapping {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

constexpr core::ClassId kChair = 57;
constexpr core::ClassId kCouch = 58;
constexpr std::size_t kSize = 100;

/// A detection of `kSize` samples, `shared` of which fall on points of the object.
Evidence evidence(core::ClassId classId, ObjectId on = 0, std::size_t shared = 0, float confidence = 1.0F) {
  Evidence evidence;
  evidence.classId = classId;
  evidence.confidence = confidence;
  evidence.size = kSize;
  if (on != 0) evidence.onObjects = evidence.underMask = {{on, shared}};
  return evidence;
}

class ObjectDatabaseTest : public testing::Test {
 protected:
  ObjectId see(const Evidence& detection, std::size_t inSight = kSize) {
    std::map<ObjectId, std::size_t> sight;
    for (const auto& [id, shared] : detection.onObjects) sight[id] = inSight;
    return database_.observe({detection}, sight, stamp_s_ += 0.1, next_).front();
  }
  void miss(ObjectId id, int times) {
    for (int i = 0; i < times; ++i) database_.observe({}, {{id, kSize}}, stamp_s_ += 0.1, next_);
  }
  [[nodiscard]] const ObjectRecord& record(ObjectId id) const { return database_.objects().at(id); }

  ObjectDatabase database_{ObjectOptions()};
  ObjectId next_ = 1;
  double stamp_s_ = 0.0;
};

TEST_F(ObjectDatabaseTest, KnowsAThingAgainByThePointsItFallsOn) {
  const ObjectId first = see(evidence(kChair));
  EXPECT_EQ(see(evidence(kChair, first, 60)), first);
  EXPECT_EQ(record(first).views, 2);
}

TEST_F(ObjectDatabaseTest, TakesAThingOnFewOfThePointsForAnother) {
  const ObjectId first = see(evidence(kChair));
  EXPECT_NE(see(evidence(kChair, first, 29)), first) << "30 % is the least";
  EXPECT_EQ(see(evidence(kChair, first, 31)), first);
}

TEST_F(ObjectDatabaseTest, WantsMoreInCommonWhereTheClassDiffers) {
  const ObjectId first = see(evidence(kChair));
  EXPECT_NE(see(evidence(kCouch, first, 45)), first) << "50 % is the least";
  EXPECT_EQ(see(evidence(kCouch, first, 55)), first);
}

TEST_F(ObjectDatabaseTest, GivesAThingTheClassThatHasMostConfidence) {
  const ObjectId id = see(evidence(kChair, 0, 0, 0.5F));
  see(evidence(kCouch, id, 90, 0.4F));
  EXPECT_EQ(record(id).classId(), kChair);
  see(evidence(kCouch, id, 90, 0.3F));
  EXPECT_EQ(record(id).classId(), kCouch);
}

TEST_F(ObjectDatabaseTest, ProbabilityIsShareTimesConfidenceTimesHowOftenItWasFound) {
  const ObjectId id = see(evidence(kChair, 0, 0, 0.8F));
  see(evidence(kChair, id, 90, 0.6F));
  see(evidence(kCouch, id, 90, 0.4F));
  miss(id, 1);
  // Chair has 1.4 of 1.8; mean confidence .6; expected in the second, third and fourth view, seen three times in all.
  const double foundShare = (3 + 1.0) / (3 + 2.0);
  EXPECT_NEAR(record(id).probability(), 1.4 / 1.8 * 0.6 * foundShare, 1e-6);
}

TEST_F(ObjectDatabaseTest, MissesAThingThatShouldBeSeenMoreOftenThanItWas) {
  const ObjectId id = see(evidence(kChair));
  miss(id, 4);
  EXPECT_FALSE(record(id).isMissing());
  miss(id, 1);
  EXPECT_TRUE(record(id).isMissing());
  see(evidence(kChair, id, 90));
  EXPECT_FALSE(record(id).isMissing());
}

TEST_F(ObjectDatabaseTest, LosesAThingWhoseTwoThirdsWereSeenThrough) {
  const ObjectId id = see(evidence(kChair));
  EXPECT_THAT(database_.erase({{id, 60}}, {{id, 40}}, 7.0), IsEmpty());
  EXPECT_THAT(database_.erase({{id, 10}}, {{id, 30}}, 8.0), ElementsAre(id)) << "70 of 100 are gone";
  EXPECT_EQ(record(id).state, ObjectState::Gone);
  EXPECT_EQ(record(id).gone_s, 8.0);
}

TEST_F(ObjectDatabaseTest, FindsThatTwoAreOneWhenOneMaskCoversBothTwice) {
  const ObjectId a = see(evidence(kChair));
  const ObjectId b = see(evidence(kChair));
  Evidence both = evidence(kChair);
  both.onObjects = both.underMask = {{a, 50}, {b, 50}};
  see(both);
  EXPECT_THAT(database_.takeMerges(), IsEmpty()) << "once may be a mistake";
  see(both);
  EXPECT_THAT(database_.takeMerges(), ElementsAre(Pair(b, a)));
  EXPECT_EQ(database_.objects().count(b), 0U);
}

/// One mask over the first and the third, one over the second and the third: where the first two are one, that is
/// twice.
TEST_F(ObjectDatabaseTest, CountsWhatWasSeenOfBothWhereTwoBecomeOne) {
  const ObjectId a = see(evidence(kChair));
  const ObjectId b = see(evidence(kChair));
  const ObjectId c = see(evidence(kChair));
  for (const ObjectId other : {a, b}) {
    Evidence both = evidence(kChair);
    both.onObjects = both.underMask = {{other, 50}, {c, 50}};
    see(both);
  }
  EXPECT_THAT(database_.takeMerges(), IsEmpty());
  database_.merge(b, a);
  see(evidence(kCouch));  // of something else
  EXPECT_THAT(database_.takeMerges(), ElementsAre(Pair(b, a), Pair(c, a)));
}

TEST_F(ObjectDatabaseTest, FindsThatTwoOfAnEarlierRunAreOne) {
  const ObjectId a = see(evidence(kChair));
  const ObjectId b = see(evidence(kChair));
  database_.restore({{{a, b}, {2, 1}}});
  see(evidence(kCouch));
  EXPECT_THAT(database_.takeMerges(), ElementsAre(Pair(b, a)));
}

TEST_F(ObjectDatabaseTest, KeepsTheFirstIdOfAThingThatMoved) {
  const ObjectId lost = see(evidence(kChair));
  const ObjectId found = see(evidence(kChair));
  database_.reunite(lost, found);
  EXPECT_EQ(database_.objects().count(found), 0U);
  EXPECT_EQ(record(lost).state, ObjectState::Moved);
  EXPECT_EQ(record(lost).views, 2);
}

TEST_F(ObjectDatabaseTest, CountsAThingInSomebodysHandsAsPutDownWhenSeenOftenEnough) {
  const ObjectId id = see(evidence(kChair));
  database_.noteHandled(kChair, {0.5F, 0, 0}, stamp_s_);
  see(evidence(kChair, id, 90));
  EXPECT_EQ(record(id).viewsToRest, 5);
  for (int i = 0; i < 5; ++i) see(evidence(kChair, id, 90));
  EXPECT_EQ(record(id).viewsToRest, 0);
}

TEST_F(ObjectDatabaseTest, DoesNotTakeAThingFarOffForTheOneInSomebodysHands) {
  const ObjectId id = see(evidence(kChair));
  database_.noteHandled(kChair, {1.5F, 0, 0}, stamp_s_);
  see(evidence(kChair, id, 90));
  EXPECT_EQ(record(id).viewsToRest, 0);
}

TEST_F(ObjectDatabaseTest, AThingThatThisRunHasNotSeenIsInNobodysHands) {
  ObjectRecord known;
  known.votes[kChair] = 4;
  known.views = 5;
  known.lastSeen_s = stamp_s_ + 1;  // by the clock of an earlier run
  database_.restore(7, known);
  database_.noteHandled(kChair, {0.5F, 0, 0}, stamp_s_);
  see(evidence(kCouch));
  EXPECT_EQ(record(7).viewsToRest, 0);
}

}  // namespace
}  // namespace wardslam::mapping

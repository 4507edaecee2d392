#include "object_votes.h"

#include <gtest/gtest.h>

namespace wardslam::mapping {
namespace {

TEST(ObjectVotesTest, NobodyWinsWithoutVotes) { EXPECT_EQ(ObjectVotes().winner(), 0U); }

TEST(ObjectVotesTest, TheHeavierVoteWins) {
  ObjectVotes votes;
  votes.add(7, 1.0F);
  votes.add(0, 0.25F);
  votes.add(9, 0.9F);
  votes.add(0, 0.25F);
  EXPECT_EQ(votes.winner(), 7U);
  votes.add(9, 0.2F);
  EXPECT_EQ(votes.winner(), 9U);
}

TEST(ObjectVotesTest, AManyTimesSeenNewcomerWinsThoughAllPlacesAreTaken) {
  ObjectVotes votes;
  votes.add(1, 3.0F);
  votes.add(2, 2.0F);
  votes.add(3, 1.0F);
  for (int i = 0; i < 10; ++i) votes.add(4, 1.0F);
  EXPECT_EQ(votes.winner(), 4U);
}

TEST(ObjectVotesTest, LongStandingVotesCanBeOutvotedInBoundedTime) {
  ObjectVotes votes;
  for (int i = 0; i < 100000; ++i) votes.add(1, 1.0F);
  for (int i = 0; i < 40; ++i) votes.add(2, 1.0F);
  EXPECT_EQ(votes.winner(), 2U);
}

TEST(ObjectVotesTest, RenamedVotesJoinThoseOfTheOtherName) {
  ObjectVotes votes;
  votes.add(1, 1.0F);
  votes.add(2, 1.5F);
  votes.add(3, 2.0F);
  votes.rename(1, 2);
  EXPECT_EQ(votes.winner(), 2U);
  votes.rename(2, 5);
  EXPECT_EQ(votes.winner(), 5U);
}

TEST(ObjectVotesTest, VotesOfTwoPointsAddUp) {
  ObjectVotes a;
  ObjectVotes b;
  a.add(1, 1.0F);
  a.add(2, 0.8F);
  b.add(2, 0.8F);
  a.add(b);
  EXPECT_EQ(a.winner(), 2U);
}

}  // namespace
}  // namespace wardslam::mapping

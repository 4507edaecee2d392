#include "wardslam/odometry/pieces.h"

#include <gmock/gmock.h>

namespace wardslam::odometry {
namespace {

using testing::ElementsAre;
using testing::Pair;

TEST(Pieces, TheLargestIsTheMap) {
  Pieces pieces;
  EXPECT_EQ(pieces.map(), std::nullopt);
  pieces.add(1, 4);
  EXPECT_EQ(pieces.map(), 4U);
  pieces.add(2, 7);
  EXPECT_EQ(pieces.map(), 4U) << "of two alike the one begun first";
  pieces.add(3, 7);
  EXPECT_EQ(pieces.map(), 7U);
  EXPECT_TRUE(pieces.isMap(7));
  EXPECT_FALSE(pieces.isMap(4));
  pieces.remove(3);
  pieces.remove(2);
  pieces.remove(99);
  EXPECT_THAT(pieces.sizes(), ElementsAre(Pair(4U, 1U)));
}

TEST(Pieces, JoinedSubmapsAreOnePiece) {
  Pieces pieces;
  for (const KeyframeId id : {1, 2, 3}) pieces.add(id, static_cast<std::uint32_t>(id));
  pieces.join({3, 2});
  pieces.join({2, 1});
  EXPECT_EQ(pieces.pieceOf(3), 1U);
  pieces.add(4, 3);
  EXPECT_THAT(pieces.sizes(), ElementsAre(Pair(1U, 4U)));
  MapUpdate update;
  update.removedKeyframes.push_back({4, 1, Eigen::Isometry3d::Identity()});
  update.joined = SubmapJoin{1, 0};
  pieces.apply(update);
  EXPECT_THAT(pieces.sizes(), ElementsAre(Pair(0U, 3U)));
}

TEST(Pieces, TheMapOfAnEarlierRunStaysTheMap) {
  Pieces pieces(0);
  pieces.add(1, 0);
  for (const KeyframeId id : {2, 3, 4}) pieces.add(id, 1);
  EXPECT_EQ(pieces.map(), 0U);
  EXPECT_FALSE(pieces.isMap(1));
  pieces.join({1, 0});
  EXPECT_TRUE(pieces.isMap(1));
}

}  // namespace
}  // namespace wardslam::odometry

#include "semantic_cloud.h"

#include <gmock/gmock.h>

namespace wardslam::mapping {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;
using testing::SizeIs;
using testing::UnorderedElementsAre;

constexpr ObjectId kChair = 7;
constexpr ObjectId kStool = 8;

/// Keyframes stand ten metres apart; each sees what is up to a metre beside it.
class SemanticCloudTest : public testing::Test {
 protected:
  SemanticCloudTest() {
    for (const KeyframeId keyframe : {1, 2, 3}) cloud_.addTile(keyframe, placeOf(keyframe));
  }

  static Eigen::Isometry3d placeOf(KeyframeId keyframe) {
    return Eigen::Isometry3d(Eigen::Translation3d(10.0 * static_cast<double>(keyframe), 0, 0));
  }

  static Eigen::Vector3f besides(KeyframeId keyframe, float off_m) {
    return placeOf(keyframe).translation().cast<float>() + Eigen::Vector3f(off_m, 0.01F, 1.01F);
  }

  /// A point seen from the keyframe, `off_m` beside it.
  void see(KeyframeId keyframe, float off_m, ObjectId object, float weight = 1.0F) {
    Sample sample;
    sample.p_map_m = besides(keyframe, off_m);
    sample.depth_m = 1.0F;
    sample.sigma_m = 0.002F;
    sample.pixels = 1;
    const auto points = cloud_.recognise({sample}, placeOf(keyframe).translation());
    cloud_.fuse({sample}, points, {{object, weight}}, keyframe);
  }

  /// By keyframe.
  [[nodiscard]] std::set<KeyframeId> lookedAtFor(ObjectId object) const {
    std::set<KeyframeId> keyframes;
    for (const std::uint32_t tile : cloud_.tilesOf({object})) keyframes.insert(cloud_.tiles()[tile].keyframe);
    return keyframes;
  }

  SemanticCloud cloud_{CloudOptions()};
};

TEST_F(SemanticCloudTest, LooksForAnObjectsPointsOnlyWhereItWasSeen) {
  see(1, 0.0F, kChair);
  see(1, 0.5F, kStool);
  see(2, 0.0F, kStool);
  see(3, 0.0F, 0);
  EXPECT_THAT(lookedAtFor(kChair), ElementsAre(1));
  EXPECT_THAT(lookedAtFor(kStool), ElementsAre(1, 2));
  EXPECT_THAT(lookedAtFor(99), IsEmpty());
  EXPECT_THAT(cloud_.tilesOf({}), IsEmpty());
  EXPECT_THAT(cloud_.pointsOf({kStool, 99}),
              UnorderedElementsAre(Pair(kStool, SizeIs(2)), Pair(ObjectId{99}, IsEmpty())));
}

TEST_F(SemanticCloudTest, FindsTheVotesThatLostWhereAnObjectGetsAnotherName) {
  see(1, 0.0F, kChair, 3.0F);
  see(1, 0.0F, kStool, 2.0F);
  see(1, 0.0F, 5, 2.0F);
  EXPECT_EQ(cloud_.find(1)->points.front().object, kChair);
  cloud_.renameObject(kStool, 5);  // 4 against 3
  see(1, 0.0F, 5, 0.001F);
  EXPECT_EQ(cloud_.find(1)->points.front().object, 5U);
  EXPECT_THAT(lookedAtFor(kStool), IsEmpty());
  EXPECT_THAT(lookedAtFor(5), ElementsAre(1));
}

TEST_F(SemanticCloudTest, FindsAnObjectWhereItsTileWent) {
  see(1, 0.0F, kChair);
  see(2, 0.0F, kStool);
  cloud_.moveTile(1, 2);
  EXPECT_EQ(lookedAtFor(kChair).count(2), 1U);
  const auto points = cloud_.pointsOf({kChair});
  ASSERT_THAT(points.at(kChair), SizeIs(1));
  EXPECT_TRUE(points.at(kChair).front().isApprox(besides(1, 0.0F), 1e-3F));
}

TEST_F(SemanticCloudTest, FindsTheObjectsOfACloudThatItTookOver) {
  see(2, 0.0F, kStool);
  SemanticCloud all{CloudOptions()};
  all.addTile(9, placeOf(9));  // numbers differ
  all.absorb(std::move(cloud_));
  EXPECT_THAT(all.pointsOf({kStool}).at(kStool), SizeIs(1));
}

TEST_F(SemanticCloudTest, ErasesAnObjectWithAllItsPoints) {
  see(1, 0.0F, kChair);
  see(2, 0.0F, kChair);
  see(2, 0.5F, kStool);
  cloud_.eraseObject(kChair);
  EXPECT_THAT(cloud_.find(1)->points, IsEmpty());
  EXPECT_THAT(cloud_.find(2)->points, SizeIs(1));
  EXPECT_THAT(cloud_.pointCounts(), ElementsAre(Pair(kStool, 1U)));
}

TEST_F(SemanticCloudTest, AnObjectThatIsTouchedTouchesItsTiles) {
  see(1, 0.0F, kChair);
  see(2, 0.0F, kStool);
  static_cast<void>(cloud_.takeChanges());
  cloud_.touchObject(kStool);
  EXPECT_THAT(cloud_.takeChanges(), ElementsAre(2));
}

}  // namespace
}  // namespace wardslam::mapping

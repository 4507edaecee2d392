#include "wardslam/core/stamp_association.h"

#include <gmock/gmock.h>

namespace wardslam::core {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;

TEST(AssociateByStamp, TakesTheClosestPairsFirst) {
  // 1.00 is nearest to 1.01, but 1.01 is still nearer to 1.012, which therefore gets it; 1.00 falls back to 0.99.
  EXPECT_THAT(associateByStamp({1.00, 1.012, 5.0}, {0.99, 1.01, 4.995}),
              ElementsAre(Pair(0, 0), Pair(1, 1), Pair(2, 2)));
}

TEST(AssociateByStamp, LeavesOverWhatHasNoFreePartner) {
  // Both 1.000 and 1.004 are near to 1.005 alone; the nearer takes it.
  EXPECT_THAT(associateByStamp({1.000, 1.004}, {1.005}), ElementsAre(Pair(1, 0)));
}

TEST(AssociateByStamp, TheLimitItselfIsTooFar) {
  EXPECT_THAT(associateByStamp({0.0, 2.0}, {0.5, 2.25}, 0.5), ElementsAre(Pair(1, 1)));
}

TEST(AssociateByStamp, OfEqualDifferencesTheEarlierWins) {
  EXPECT_THAT(associateByStamp({1.0}, {0.75, 1.25}, 0.5), ElementsAre(Pair(0, 0)));
}

TEST(AssociateByStamp, OfNothingIsNothing) {
  EXPECT_THAT(associateByStamp({}, {1.0}), IsEmpty());
  EXPECT_THAT(associateByStamp({1.0}, {}), IsEmpty());
}

}  // namespace
}  // namespace wardslam::core

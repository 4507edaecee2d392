#include "euclidean_clusters.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace wardslam::mapping {
namespace {

using testing::ElementsAre;

TEST(EuclideanClustersTest, GroupsByGaps) {
  const std::vector<Eigen::Vector3f> points{{0, 0, 0},     {5, 0, 0},     {0.09F, 0, 0},
                                            {0.18F, 0, 0}, {5, 0, 0.05F}, {0, 9, 0}};
  EXPECT_THAT(euclideanClusters(points, 0.1), ElementsAre(ElementsAre(0, 2, 3), ElementsAre(1, 4), ElementsAre(5)));
  EXPECT_EQ(euclideanClusters(points, 0.08).size(), 5U);
}

TEST(EuclideanClustersTest, NothingHasNoClusters) { EXPECT_TRUE(euclideanClusters({}, 0.1).empty()); }

}  // namespace
}  // namespace wardslam::mapping

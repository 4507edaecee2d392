#include "euclidean_clusters.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <link.h>

#include <string>

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

/// Symbols of those with ready templates were more than half of what a program did until its first pose.
TEST(EuclideanClustersTest, OfPclOneLibraryIsLoaded) {
  std::vector<std::string> loaded;
  dl_iterate_phdr(
      [](dl_phdr_info* info, std::size_t, void* names) {
        const std::string file = info->dlpi_name;
        const std::string name = file.substr(file.rfind('/') + 1);
        if (name.rfind("libpcl_", 0) == 0) static_cast<std::vector<std::string>*>(names)->push_back(name);
        return 0;
      },
      &loaded);
  EXPECT_THAT(loaded, ElementsAre(testing::StartsWith("libpcl_common.so")));
}

}  // namespace
}  // namespace wardslam::mapping

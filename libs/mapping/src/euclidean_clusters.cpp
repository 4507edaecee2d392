#include "euclidean_clusters.h"

#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/extract_clusters.h>

#include <algorithm>

namespace wardslam::mapping {

std::vector<std::vector<std::size_t>> euclideanClusters(const std::vector<Eigen::Vector3f>& points_m, double gap_m) {
  if (points_m.empty()) return {};
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  cloud->reserve(points_m.size());
  for (const Eigen::Vector3f& p : points_m) cloud->emplace_back(p.x(), p.y(), p.z());
  const auto tree = pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>();
  tree->setInputCloud(cloud);

  pcl::EuclideanClusterExtraction<pcl::PointXYZ> extraction;
  extraction.setClusterTolerance(gap_m);
  extraction.setSearchMethod(tree);
  extraction.setInputCloud(cloud);
  std::vector<pcl::PointIndices> found;
  extraction.extract(found);

  std::vector<std::vector<std::size_t>> clusters;
  for (const pcl::PointIndices& cluster : found) {
    clusters.emplace_back(cluster.indices.begin(), cluster.indices.end());
    std::sort(clusters.back().begin(), clusters.back().end());
  }
  std::sort(clusters.begin(), clusters.end());
  return clusters;
}

}  // namespace wardslam::mapping

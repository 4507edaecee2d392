#include "detections.h"

#include <algorithm>
#include <unordered_map>

#include "cell_hash.h"
#include "euclidean_clusters.h"

namespace wardslam::mapping {
namespace {

using Indices = std::vector<std::size_t>;

/// Clusters are sought on cells twice as large as those of the map: a quarter of the points.
constexpr float kCoarseCells = 2.0F;

struct Cluster {
  Indices samples;
  int pixels = 0;
};

float quantileOf(float Sample::*value, const std::vector<Sample>& samples, const Indices& part, double quantile) {
  std::vector<float> values;
  values.reserve(part.size());
  for (const std::size_t i : part) values.push_back(samples[i].*value);
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(quantile * static_cast<double>(part.size() - 1));
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

std::vector<Cluster> clustersOf(const std::vector<Sample>& samples, const Indices& part, float cell_m, double gap_m) {
  std::unordered_map<std::uint64_t, std::size_t, CellHash> cellIndex;
  std::vector<Eigen::Vector3f> cells;
  std::vector<Indices> inCell;
  for (const std::size_t i : part) {
    const std::uint64_t cell = cellOf(samples[i].p_map_m, kCoarseCells * cell_m);
    const auto [entry, isNew] = cellIndex.try_emplace(cell, cells.size());
    if (isNew) {
      cells.push_back(samples[i].p_map_m);
      inCell.emplace_back();
    }
    inCell[entry->second].push_back(i);
  }
  std::vector<Cluster> clusters;
  for (const auto& members : euclideanClusters(cells, gap_m)) {
    Cluster& cluster = clusters.emplace_back();
    for (const std::size_t cell : members) {
      cluster.samples.insert(cluster.samples.end(), inCell[cell].begin(), inCell[cell].end());
      for (const std::size_t i : inCell[cell]) cluster.pixels += samples[i].pixels;
    }
  }
  std::stable_sort(clusters.begin(), clusters.end(), [](const auto& a, const auto& b) { return a.pixels > b.pixels; });
  return clusters;
}

Eigen::Vector3f centroidOf(const std::vector<Sample>& samples, const Indices& part) {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (const std::size_t i : part) sum += samples[i].p_map_m;
  return sum / static_cast<float>(part.size());
}

/// Splits the samples of one instance into those of the thing and the doubtful.
Detection locate(const std::vector<Sample>& samples, const Indices& part, const ObjectOptions& options, float cell_m) {
  const double sigma_m = static_cast<double>(quantileOf(&Sample::sigma_m, samples, part, 0.5));
  const double gap_m = options.cluster_gap_m + 2.0 * sigma_m;  // noise sets even one surface's points apart
  const auto clusters = clustersOf(samples, part, cell_m, gap_m);
  Detection detection;
  const float nearest_m =
      quantileOf(&Sample::depth_m, samples, clusters.front().samples, 0.05) - static_cast<float>(gap_m);
  const float farthest_m =
      quantileOf(&Sample::depth_m, samples, clusters.front().samples, 0.95) + static_cast<float>(gap_m);
  for (const Cluster& cluster : clusters) {
    const float depth_m = quantileOf(&Sample::depth_m, samples, cluster.samples, 0.5);
    const bool isPart = &cluster == &clusters.front() || (depth_m >= nearest_m && depth_m <= farthest_m);
    Indices& target = isPart ? detection.samples : detection.doubtful;
    target.insert(target.end(), cluster.samples.begin(), cluster.samples.end());
  }
  detection.centroid_m = centroidOf(samples, detection.samples);
  return detection;
}

}  // namespace

std::vector<Detection> detect(const core::Segmentation& segmentation, const std::vector<Sample>& samples,
                              const knowledge::ClassSet& moving, const ObjectOptions& options, float cell_m) {
  std::map<std::uint16_t, Indices> byInstance;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (samples[i].instance != 0) byInstance[samples[i].instance].push_back(i);
  }
  std::vector<Detection> detections;
  for (const core::Instance& instance : segmentation.instances) {
    const auto part = byInstance.find(instance.id);
    if (part == byInstance.end() || instance.classId == 0 || moving[instance.classId]) continue;
    if (part->second.size() < static_cast<std::size_t>(options.min_points)) continue;
    Detection detection = locate(samples, part->second, options, cell_m);
    if (detection.samples.size() < static_cast<std::size_t>(options.min_points)) continue;
    detection.classId = instance.classId;
    detection.confidence = instance.confidence;
    detections.push_back(std::move(detection));
  }
  return detections;
}

}  // namespace wardslam::mapping

#include "life/way_network.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <stdexcept>
#include <utility>

namespace wardslam::synth {

WayNetwork::WayNetwork(WayGraph graph) : graph_(std::move(graph)), neighbours_(graph_.nodes_m.size()) {
  if (graph_.nodes_m.empty()) throw std::invalid_argument("a network of ways needs a node");
  for (std::size_t i = 0; i < graph_.edges.size(); ++i) {
    const auto [a, b] = graph_.edges[i];
    if (std::max(a, b) >= graph_.nodes_m.size()) throw std::invalid_argument("an edge needs two nodes that exist");
    const double length_m = (graph_.nodes_m[a] - graph_.nodes_m[b]).norm();
    neighbours_[a].push_back({b, i, length_m});
    neighbours_[b].push_back({a, i, length_m});
  }
  halfWidths_m_.assign(graph_.edges.size(), kWayClearance_m);
}

std::size_t WayNetwork::nearestNode(const Eigen::Vector2d& p_m) const {
  const auto nearer = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return (a - p_m).squaredNorm() < (b - p_m).squaredNorm();
  };
  const auto nearest = std::min_element(graph_.nodes_m.begin(), graph_.nodes_m.end(), nearer);
  return static_cast<std::size_t>(nearest - graph_.nodes_m.begin());
}

std::vector<std::size_t> WayNetwork::way(std::size_t from, std::size_t to, double halfWidth_m) const {
  const std::size_t none = neighbours_.size();
  std::vector<double> cost_m(neighbours_.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> before(neighbours_.size(), none);
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  cost_m[from] = 0.0;
  open.emplace(0.0, from);
  while (!open.empty()) {
    const auto [cost, node] = open.top();
    open.pop();
    if (node == to) break;
    if (cost > cost_m[node]) continue;
    for (const Neighbour& next : neighbours_[node]) {
      const double there_m = cost + next.length_m;
      if (halfWidths_m_[next.edge] < halfWidth_m || there_m >= cost_m[next.node]) continue;
      cost_m[next.node] = there_m;
      before[next.node] = node;
      open.emplace(there_m, next.node);
    }
  }
  std::vector<std::size_t> nodes;
  if (from != to && before[to] == none) return nodes;
  for (std::size_t node = to; node != none; node = before[node]) nodes.push_back(node);
  std::reverse(nodes.begin(), nodes.end());
  return nodes;
}

}  // namespace wardslam::synth

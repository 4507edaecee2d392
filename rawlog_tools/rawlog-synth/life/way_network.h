#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "life/ways.h"

namespace wardslam::synth {

/// Finds ways through a WayGraph.
class WayNetwork {
 public:
  /// Throws std::invalid_argument when the graph has no node, or an edge of a node it has not.
  explicit WayNetwork(WayGraph graph);

  [[nodiscard]] const WayGraph& graph() const { return graph_; }
  [[nodiscard]] std::size_t nearestNode(const Eigen::Vector2d& p_m) const;

  /// How wide the edges are: half the width of what can be pushed along each, in the order of the graph's edges.
  void setHalfWidths(std::vector<double> halfWidths_m) { halfWidths_m_ = std::move(halfWidths_m); }

  /// Shortest way, both nodes included, along edges of at least that half width; empty where there is none.
  [[nodiscard]] std::vector<std::size_t> way(std::size_t from, std::size_t to, double halfWidth_m = 0.0) const;

 private:
  struct Neighbour {
    std::size_t node;
    std::size_t edge;
    double length_m;
  };

  WayGraph graph_;
  std::vector<std::vector<Neighbour>> neighbours_;
  std::vector<double> halfWidths_m_;
};

}  // namespace wardslam::synth

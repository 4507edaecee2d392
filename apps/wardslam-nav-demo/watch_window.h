#pragma once

#include <memory>

#include "simulation.h"
#include "wardslam/mapping/semantic_map.h"

namespace wardslam::nav_demo {

/// A window in which one watches a run, no faster than it would happen.
class WatchWindow {
 public:
  /// Throws core::InputError where there is no display.
  WatchWindow(const mapping::SemanticMap& map, const Mission& mission, const SimulationOptions& options);
  ~WatchWindow();
  WatchWindow(const WatchWindow&) = delete;
  WatchWindow& operator=(const WatchWindow&) = delete;

  /// False when the window was closed.
  bool show(const Moment& moment);

 private:
  struct Window;
  std::unique_ptr<Window> window_;
};

}  // namespace wardslam::nav_demo

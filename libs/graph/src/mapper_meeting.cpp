// What a Mapper does with runs that know nothing of each other.
#include "bundle_adjustment.h"
#include "floors.h"
#include "lookalikes.h"
#include "loop_confirmation.h"
#include "map_motion.h"
#include "wardslam/graph/mapper.h"

namespace wardslam::graph {
namespace {

/// What looks from afar leave of tilt and height between runs, their common floor takes back.
void level(KeyframeGraph& graph, const std::vector<Loop>& looks, const std::vector<Loop>& loops,
           const GraphOptions& options) {
  bool isNews = false;
  for (const Loop& look : looks) isNews = uniteFloors(graph, look.older, look.newer) || isNews;
  if (!isNews) return;
  const std::uint32_t piece = graph.keyframes().at(looks.front().newer).submap;
  optimisePoses(graph, piece, loops, options.pose_graph);
  const BundleAdjustmentOptions& adjustment = options.bundle_adjustment;
  adjust(graph, globalWindow(graph, piece), adjustment, adjustment.global_iterations);
}

}  // namespace

/// Its own places come to be remembered last: beside them those of others would not be found.
void Mapper::meet(const SavedGraph& other, const std::function<void(const odometry::MapUpdate&)>& onKeyframe,
                  std::size_t done) {
  if (done == 0) takeIn(other);
  const KeyframeId first = other.keyframes.empty() ? 0 : other.keyframes.front()->id;
  for (std::size_t i = done; i < other.keyframes.size(); ++i) {
    const KeyframeId id = other.keyframes[i]->id;
    odometry::MapUpdate update;
    const auto loops = confirmation_->confirm(graph_, id, recognise(id, first));
    const bool isClosed = !loops.empty() && !areMistakable(loops) && close(loops, nullptr, update);
    if (isClosed && options_.floor) level(graph_, loops, loops_, options_);
    onKeyframe(update);
  }
  rememberPlacesOf(other);
}

}  // namespace wardslam::graph

#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "wardslam/graph/graph_options.h"
#include "wardslam/graph/keyframe_graph.h"
#include "wardslam/graph/loop_verification.h"
#include "wardslam/graph/mapper_state.h"
#include "wardslam/graph/place_recognition.h"
#include "wardslam/graph/saved_graph.h"
#include "wardslam/odometry/map_update.h"
#include "wardslam/odometry/odometry_options.h"
#include "wardslam/odometry/pieces.h"

namespace wardslam::graph {

class LoopConfirmation;
class Lookalikes;

/// What is done with the keyframes of an earlier run.
enum class Saved {
  /// They stay where that run left them as long as what this run adds can be fitted to them: a loop that asks for more
  /// has all adjusted. So is a piece that is joined to another. What shows nothing that others do not is given up.
  MayChange,
  IsHeld,  ///< They and their points stay as they are to the last bit; what comes is fitted to them.
};

/// Keeps the map of keyframes right as it grows: local bundle adjustment after every keyframe; where an old place is
/// seen again by several keyframes, the loop is closed over a pose graph and everything adjusted, and taken back if it
/// does not fit; submaps that meet are joined. Keyframes
/// that show nothing new are given up again, so that the map grows with the area and not with the time spent in it.
///
/// Plain and single-threaded; a core::Stage runs one behind tracking.
class Mapper {
 public:
  Mapper(const GraphOptions& options, const odometry::OdometryOptions& odometry);
  ~Mapper();

  /// Before the first insert(). What comes then must be of other submaps and have higher ids; it joins the saved map,
  /// or another of its pieces, where a place is recognised.
  void restore(const SavedGraph& saved, Saved use = Saved::MayChange);

  /// Takes in a keyframe; keyframes come in order. Returns what tracking should know. Adjustments over the whole map
  /// end early once `stop` (may be null) is set.
  odometry::MapUpdate insert(const std::shared_ptr<const odometry::Keyframe>& keyframe,
                             const std::atomic<bool>* stop = nullptr);

  /// A further run that knows nothing of what is there, restored beside it: where its keyframes, in order, show a place
  /// of what was there before, loops are closed and pieces joined as insert() does. Its submaps, keyframes and points
  /// have higher numbers. `onKeyframe` hears after each of them what that changed, be it nothing; what it throws ends
  /// it. `done`: of its keyframes so many have looked already, as resume() knows.
  void meet(const SavedGraph& other, const std::function<void(const odometry::MapUpdate&)>& onKeyframe,
            std::size_t done = 0);

  /// To go on with meet() from here, another time. May be asked for while `onKeyframe` hears.
  [[nodiscard]] MapperState state() const;

  /// Before anything else: takes in the runs that were restored and met when state() told of it, in the same order; the
  /// last of them may not have looked with all its keyframes by then.
  void resume(const std::vector<const SavedGraph*>& runs, const MapperState& state);

  [[nodiscard]] const KeyframeGraph& graph() const { return graph_; }
  /// Those that tie keyframes together still: one between an old keyframe and one given up for it is no more needed.
  [[nodiscard]] const std::vector<Loop>& loops() const { return loops_; }
  [[nodiscard]] std::size_t loopsClosed() const { return loopsClosed_; }
  /// Closed, and taken back with all they had changed as they did not fit: nobody was told of them.
  [[nodiscard]] std::size_t loopsTakenBack() const { return loopsTakenBack_; }
  [[nodiscard]] std::size_t submapsJoined() const { return joins_.size(); }
  [[nodiscard]] const std::vector<odometry::SubmapJoin>& joins() const { return joins_; }  ///< In their order.
  [[nodiscard]] const odometry::Pieces& pieces() const { return pieces_; }

  /// After the last keyframe: joins two pieces by the best that was seen, though it was less than is asked for while
  /// more may come. Again until there is nothing.
  std::optional<odometry::MapUpdate> settle();

  /// Adjusts the whole map once more: after the last keyframe. Returns where everything is now, as of that keyframe.
  odometry::MapUpdate adjustAll();

 private:
  /// What a loop may bend to fit: what is settled is the last to give way.
  enum class Bent { TheUnsettled, All };

  void takeIn(const SavedGraph& saved);
  void rememberPlacesOf(const SavedGraph& saved);
  void findFloorOf(KeyframeId id);
  void cullPoints(KeyframeId newest, odometry::MapUpdate& update);
  void cullKeyframes(KeyframeId newest, odometry::MapUpdate& update);
  void remove(KeyframeId id, odometry::MapUpdate& update);
  void rememberPlaces(KeyframeId newest);
  [[nodiscard]] RememberedPlace lastingLooksOf(KeyframeId id) const;
  void remember(const RememberedPlace& place);
  void remember(std::vector<RememberedPlace> places);
  [[nodiscard]] std::vector<Loop> recognise(KeyframeId newest, KeyframeId before);
  [[nodiscard]] bool isBelievable(const Loop& loop);
  [[nodiscard]] bool areMistakable(const std::vector<Loop>& loops);
  [[nodiscard]] bool hasDouble(const Loop& join);
  bool close(const std::vector<Loop>& loops, const std::atomic<bool>* stop, odometry::MapUpdate& update);
  [[nodiscard]] bool leavesTheSettled(const Loop& loop) const;
  std::optional<odometry::MapUpdate> closeWith(const std::vector<Loop>& loops, Bent bent,
                                               const std::atomic<bool>* stop);
  [[nodiscard]] bool agreesInDepth(const Loop& join) const;
  [[nodiscard]] odometry::SubmapJoin directionOf(std::uint32_t piece, std::uint32_t other) const;
  std::optional<odometry::SubmapJoin> joinSubmaps(const Loop& loop);
  [[nodiscard]] bool isHeld(KeyframeId id) const { return graph_.keyframes().at(id).isHeld; }
  void fuse(const Loop& loop, odometry::MapUpdate& update);
  void recallAround(KeyframeId newest, odometry::MapUpdate& update);
  void recall(KeyframeId id, odometry::MapUpdate& update) const;

  GraphOptions options_;
  KeyframeGraph graph_;
  odometry::Pieces pieces_;
  std::optional<std::uint32_t> keptMap_;            ///< The piece whose frame an earlier run made that of the map.
  std::multimap<KeyframeId, PointId> onProbation_;  ///< Points by the keyframe that made them.
  std::deque<KeyframeId> young_;                    ///< Too young to be recognised.
  std::set<KeyframeId> around_;                     ///< Keyframes around the newest that tracking knows.
  PlaceRecognition places_;
  LoopVerification verification_;
  std::unique_ptr<LoopConfirmation> confirmation_;
  std::unique_ptr<Lookalikes> lookalikes_;
  std::vector<Loop> loops_;
  std::vector<odometry::SubmapJoin> joins_;
  std::vector<std::vector<RememberedPlace>> remembered_;  ///< Of earlier runs.
  std::size_t loopsClosed_ = 0;
  std::size_t loopsTakenBack_ = 0;
};

}  // namespace wardslam::graph

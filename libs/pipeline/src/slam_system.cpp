#include "wardslam/pipeline/slam_system.h"

#include <algorithm>
#include <chrono>
#include <future>
#include <string>
#include <utility>

#include "map_feed.h"
#include "wardslam/core/data_files.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/first_failure.h"

namespace wardslam::pipeline {
namespace {

std::unique_ptr<graph::Mapper> makeMapper(const SlamOptions& options, const EarlierMap& earlier) {
  auto mapper = std::make_unique<graph::Mapper>(options.graph, options.odometry);
  mapper->restore(earlier.graph, earlier.use);
  return mapper;
}

odometry::Continuation continuationOf(const graph::SavedGraph& earlier) {
  if (earlier.keyframes.empty()) return {};
  odometry::Continuation continuation;
  continuation.lastKeyframe = earlier.keyframes.back()->id;
  for (const auto& keyframe : earlier.keyframes) {
    for (const auto& sighting : keyframe->sightings) {
      continuation.lastPoint = std::max(continuation.lastPoint, sighting.point);
    }
  }
  continuation.submap = earlier.freeSubmap;
  continuation.map = earlier.map;
  return continuation;
}

/// A class id means one thing, in the map and in the masks to come.
void requireSameNames(const core::LabelSpace& labels, bool hasMasks, const mapping::SemanticMap& earlier) {
  for (const auto& [id, object] : earlier.objects) {
    const std::string& before = earlier.labels.name(object.classId);
    const std::string& now = labels.name(object.classId);
    const auto another = hasMasks ? labels.find(before) : std::nullopt;
    if (!before.empty() && another && *another != object.classId) {
      throw core::InputError("class '" + before + "' is " + std::to_string(object.classId) + " in the map but " +
                             std::to_string(*another) + " in the masks; use the class ids the map was made with");
    }
    if (before.empty() || now.empty() || before == now) continue;
    throw core::InputError("class " + std::to_string(object.classId) + " is '" + before + "' in the map but '" + now +
                           "' in the masks; use the class names the map was made with");
  }
}

std::unique_ptr<mapping::MapBuilder> makeMapBuilder(const SlamOptions& options, mapping::MapSetting setting,
                                                    const EarlierMap& earlier) {
  auto builder = std::make_unique<mapping::MapBuilder>(options.mapping, std::move(setting));
  if (!earlier.semantic.keyframes.empty()) builder->restore(earlier.semantic, earlier.memory);
  return builder;
}

ViewSelection makeViewSelection(const SlamOptions& options) { return {options.mapping.views, options.segments()}; }

/// What `ask` finds out in the stage, after all that was posted to it before.
template <class Worker, class Ask>
auto askInTurn(core::Stage<Worker>& stage, Ask ask) {
  auto answer = std::make_shared<std::promise<decltype(ask(std::declval<Worker&>()))>>();
  auto answered = answer->get_future();
  stage.post([answer, ask](Worker& worker) { answer->set_value(ask(worker)); });
  constexpr std::chrono::milliseconds kLookAgain{20};  // a stage that has failed answers nothing
  while (answered.wait_for(kLookAgain) != std::future_status::ready) stage.rethrowFailure();
  return answered.get();
}

/// Who waits for a map gains nothing where its threads give way, and on a busy computer loses much.
core::StageThread threadOf(const SlamOptions& options, WhenBehind whenBehind) {
  if (options.deterministic) return core::StageThread::Caller;
  return whenBehind == WhenBehind::Waits ? core::StageThread::Own : core::StageThread::GivesWay;
}

/// A recording waits at a keyframe until the one before is worked in: what tracking is told late of known places, it
/// maps a second time, and fewer keyframes turn out to show nothing new.
core::StageCapacity graphCapacity(WhenBehind whenBehind) {
  core::StageCapacity capacity;
  if (whenBehind == WhenBehind::Waits) capacity.required = 1;
  return capacity;
}

core::StageCapacity mapCapacity(WhenBehind whenBehind) {
  core::StageCapacity capacity;
  if (whenBehind == WhenBehind::Waits) capacity.required = 16;
  return capacity;
}

mapping::Zones zonesOf(const SlamOptions& options, const mapping::SemanticMap& earlier) {
  if (options.zones.file.empty()) return mapping::Zones(earlier.zones);
  return mapping::Zones::fromFile(core::findDataFile(options.zones.file, options.file));
}

}  // namespace

SlamSystem::SlamSystem(const SlamOptions& options, const EarlierMap& earlier, WhenBehind whenBehind)
    : options_(options),
      frontEnd_(options, continuationOf(earlier.graph)),
      zones_(zonesOf(options, earlier.semantic)),
      canWait_(whenBehind == WhenBehind::Waits),
      trajectory_(options.trajectory),
      graphBuilding_(makeMapper(options, earlier), threadOf(options, whenBehind), graphCapacity(whenBehind)) {
  hasEarlierMap_ = !earlier.graph.keyframes.empty();
  if (hasEarlierMap_) pieces_ = odometry::Pieces(earlier.graph.map);
  requireSameNames(labelSpace(), options.segments(), earlier.semantic);
  addObserver(trajectory_);
  if (!options.mapping.enabled) return;
  mapBuilding_ = std::make_unique<core::Stage<mapping::MapBuilder>>(
      makeMapBuilder(options, {labelSpace(), frontEnd_.movers(), zones_, frontEnd_.movables()}, earlier),
      threadOf(options, whenBehind), mapCapacity(whenBehind));
  mapFeed_ = std::make_unique<MapFeed>(*mapBuilding_, makeViewSelection(options), frontEnd_.profiler(), whenBehind);
}

SlamSystem::~SlamSystem() = default;

void SlamSystem::writeTo(storage::MapFileWriter& writer) {
  if (mapFeed_) mapFeed_->writeTo(writer);
}

odometry::OdometryResult SlamSystem::process(const std::shared_ptr<mrpt::obs::CObservation3DRangeScan>& observation,
                                             const std::optional<odometry::MotionPrior>& motion) {
  core::Profiler& profiler = frontEnd_.profiler();
  const auto timing = profiler.measure("pipeline.process");
  auto [frame, odometry] = frontEnd_.process(observation, motion);
  if (odometry.keyframe) {
    insert(odometry.keyframe);
    if (canWait_) askInTurn(graphBuilding_, [](graph::Mapper&) { return true; });  // tracking goes on with what it says
  }
  graphBuilding_.rethrowFailure();
  const auto updates = takeOverUpdates();
  if (odometry.keyframe) pieces_.add(odometry.keyframe->id, odometry.keyframe->submap);
  if (odometry.hasPose()) noteRecognition(odometry.piece, frame.stamp_s);
  if (mapFeed_) mapFeed_->update(frame, odometry, updates);
  for (FrameObserver* observer : observers_) observer->onFrame(frame, odometry);
  return odometry;
}

SharedUpdates SlamSystem::takeOverUpdates() {
  auto updates = mapUpdates_.takeAll();
  for (const auto& update : updates) {
    const auto application = frontEnd_.profiler().measure("odometry.apply");
    frontEnd_.apply(update);
    pieces_.apply(*update);
    for (FrameObserver* observer : observers_) observer->onUpdate(*update);
  }
  takenOver_.insert(takenOver_.end(), updates.begin(), updates.end());
  return updates;
}

/// In an earlier map, a run knows where it is once its piece is one with the map.
void SlamSystem::noteRecognition(std::uint32_t piece, double stamp_s) {
  last_ = {piece, stamp_s};
  if (hasEarlierMap_ && !recognisedAt_s_ && pieces_.isMap(piece)) recognisedAt_s_ = stamp_s;
}

/// A keyframe that comes while another is worked in has adjustments over the whole map end early, unless it can wait.
/// What was taken over goes along: to free the update of a loop takes time, which is not tracking's.
void SlamSystem::insert(const std::shared_ptr<const odometry::Keyframe>& keyframe) {
  graphBuilding_.post([this, keyframe, takenOver = std::exchange(takenOver_, {})](graph::Mapper& mapper) {
    const auto insertion = frontEnd_.profiler().measure("graph.insert");
    tell(mapper.insert(keyframe, canWait_ ? nullptr : &graphBuilding_.isWaitedFor()));
  });
}

void SlamSystem::tell(odometry::MapUpdate update) {
  mapUpdates_.put(std::make_shared<const odometry::MapUpdate>(std::move(update)));
}

void SlamSystem::finish() {
  core::FirstFailure failure;
  failure.attempt([this] { finishGraph(); });
  failure.attempt([this] {
    for (const auto& update : mapUpdates_.takeAll()) {
      pieces_.apply(*update);
      for (FrameObserver* observer : observers_) observer->onUpdate(*update);
      if (mapFeed_) mapFeed_->apply(update);
    }
  });
  if (last_) noteRecognition(last_->piece, last_->stamp_s);
  failure.attempt([this] {
    if (mapBuilding_ && !mapBuilder_) mapBuilder_ = mapBuilding_->finish();
  });
  if (mapBuilding_ && !mapBuilder_) mapBuilder_ = mapBuilding_->giveUp();
  failure.rethrow();
}

void SlamSystem::finishGraph() {
  if (mapper_) return;
  core::FirstFailure failure;
  failure.attempt([this] { mapper_ = graphBuilding_.finish(); });
  if (!mapper_) mapper_ = graphBuilding_.giveUp();
  failure.rethrow();
  while (auto joined = mapper_->settle()) tell(std::move(*joined));
  tell(mapper_->adjustAll());
}

core::EventCounts SlamSystem::leftOut() const {
  core::EventCounts counts;
  if (!mapFeed_) return counts;
  if (const auto views = mapBuilding_->leftOut(); views > 0) counts["mapping.view_left_out"] = views;
  if (const auto views = mapFeed_->viewsWithoutMasks(); views > 0) counts["mapping.view_without_masks"] = views;
  return counts;
}

std::size_t SlamSystem::waiting() const {
  return graphBuilding_.waiting() + (mapBuilding_ ? mapBuilding_->waiting() : 0);
}

mapping::SemanticMap SlamSystem::semanticMap() const {
  return mapBuilder_ ? mapBuilder_->map() : mapping::SemanticMap{};
}

MapSoFar SlamSystem::mapSoFar() {
  const auto posesInMap = [](const graph::Mapper& mapper) {
    const auto map = mapper.pieces().map();
    return map ? posesIn(mapper, *map) : std::map<odometry::KeyframeId, Eigen::Isometry3d>{};
  };
  MapSoFar soFar;
  soFar.T_map_cam = mapper_ ? posesInMap(*mapper_) : askInTurn(graphBuilding_, posesInMap);
  for (const auto& update : takeOverUpdates()) {
    if (mapFeed_) mapFeed_->apply(update);
  }
  soFar.trajectory = mapper_ ? trajectory() : trajectory_.corrected(soFar.T_map_cam);
  if (mapBuilder_ || !mapBuilding_) {
    soFar.semantic = semanticMap();
  } else {
    soFar.semantic = askInTurn(*mapBuilding_, [](mapping::MapBuilder& builder) { return builder.map(); });
  }
  return soFar;
}

core::Trajectory SlamSystem::trajectory() const {
  const auto map = mapper_->pieces().map();
  return map ? trajectory_.onOneWay(posesIn(*mapper_, *map)) : core::Trajectory{};
}

std::map<odometry::KeyframeId, Eigen::Isometry3d> SlamSystem::posesIn(const graph::Mapper& mapper,
                                                                      std::uint32_t piece) {
  std::map<odometry::KeyframeId, Eigen::Isometry3d> T_map_keyframe;
  for (const auto& [id, node] : mapper.graph().keyframes()) {
    if (node.submap == piece) T_map_keyframe.emplace(id, node.T_map_cam);
  }
  return T_map_keyframe;
}

std::map<std::uint32_t, core::Trajectory> SlamSystem::unjoinedTrajectories() const {
  std::map<std::uint32_t, core::Trajectory> trajectories;
  for (const auto& [piece, keyframes] : mapper_->pieces().sizes()) {
    if (mapper_->pieces().isMap(piece)) continue;
    auto trajectory = trajectory_.onOneWay(posesIn(*mapper_, piece));
    if (!trajectory.empty()) trajectories.emplace(piece, std::move(trajectory));
  }
  return trajectories;
}

std::string SlamSystem::configuration() const { return writeSlamOptions(options_, frontEnd_.filters()); }

}  // namespace wardslam::pipeline

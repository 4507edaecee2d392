#include "sighting_intervals.h"

#include <algorithm>

namespace wardslam::fleet {
namespace {

using mapping::MapObject;
using mapping::ObjectState;

/// Where the object is now, seen there from `since_s` on.
Stay stayOf(const MapObject& object, double since_s) {
  return {
      std::min(since_s, object.lastSeen_s), object.lastSeen_s, object.centroid_m, object.box_m, object.zone, {}, 0.0};
}

/// What stands elsewhere has been there since it was put down; where that is not known, its last sighting is sure.
double arrival_s(const MapObject& object, const Traces& traces, double after_s) {
  const bool isKnown = traces.handled_s > after_s && traces.handled_s <= object.lastSeen_s;
  return isKnown ? traces.handled_s : std::max(object.lastSeen_s, after_s);
}

void end(Stay& stay, const char* how, double when_s) {
  stay.ended = how;
  stay.ended_s = std::max(when_s, stay.until_s);
}

bool isGone(const MapObject& object) { return object.state == ObjectState::Gone; }

double found_gone_s(const MapObject& object, const Traces& traces, double mapEnd_s) {
  return traces.gone_s > object.lastSeen_s ? traces.gone_s : mapEnd_s;
}

StayUpdate firstStay(const MapObject& object, const Traces& traces) {
  const bool hasMoved = object.state == ObjectState::Moved;
  return {{}, stayOf(object, hasMoved ? arrival_s(object, traces, object.firstSeen_s) : object.firstSeen_s), "new"};
}

StayUpdate cameBack(const Stay& last, const MapObject& object, const Traces& traces) {
  if (object.lastSeen_s > last.until_s) return {{}, stayOf(object, arrival_s(object, traces, last.until_s)), "back"};
  StayUpdate update{last, {}, "back"};  // it never was gone
  update.last->ended.clear();
  update.last->ended_s = 0.0;
  return update;
}

StayUpdate wentOn(const Stay& last, const Eigen::Vector3d& lastPlace_m, const MapObject& object, const Traces& traces) {
  const bool isElsewhere = (object.centroid_m - lastPlace_m).norm() > kMoved_m;
  if (object.state == ObjectState::Static || !isElsewhere || object.lastSeen_s <= last.until_s) {
    Stay longer = stayOf(object, last.since_s);
    longer.since_s = last.since_s;
    longer.until_s = std::max(longer.until_s, last.until_s);
    return {longer, {}, {}};
  }
  StayUpdate update{last, stayOf(object, arrival_s(object, traces, last.until_s)), "moved"};
  end(*update.last, "moved", update.next->since_s);
  return update;
}

}  // namespace

StayUpdate updateStays(const std::optional<Stay>& last, const Eigen::Vector3d& lastPlace_m, const MapObject& object,
                       const Traces& traces, double mapEnd_s) {
  const bool wasGone = last && last->ended == "gone";
  if (wasGone && isGone(object) && object.lastSeen_s <= last->until_s) return {};
  StayUpdate update = !last     ? firstStay(object, traces)
                      : wasGone ? cameBack(*last, object, traces)
                                : wentOn(*last, lastPlace_m, object, traces);
  if (isGone(object)) {
    end(update.next ? *update.next : *update.last, "gone", found_gone_s(object, traces, mapEnd_s));
    update.change = "gone";
  }
  return update;
}

}  // namespace wardslam::fleet

#include "life/life_actors.h"
#include "scene/classes.h"

#include <limits>
#include <utility>

namespace wardslam::synth {
namespace {

Eigen::Isometry3f placeOf(const Eigen::Vector2d& p_m, double z_m, double heading_rad) {
  return at(static_cast<float>(p_m.x()), static_cast<float>(p_m.y()), static_cast<float>(z_m),
            static_cast<float>(heading_rad));
}

}  // namespace

MemberActor::MemberActor(Label label, std::shared_ptr<const Society> society, std::size_t member, Look look)
    : Actor(std::move(label)), society_(std::move(society)), member_(member), look_(look) {}

Surfaces MemberActor::surfacesAt(double t_s) const {
  const BodyState body = bodyAt(t_s);
  return placed({{look_.outfit, poseFigure(look_, body.pose)}}, placeOf(body.p_m, 0.0, body.heading_rad));
}

bool MemberActor::isMovingAt(double t_s) const { return society_->memberAt(member_, t_s).isMoving; }

double MemberActor::atRestFrom_s() const { return std::numeric_limits<double>::infinity(); }

Eigen::AlignedBox3f MemberActor::boundsAt(double t_s) const {
  constexpr float kArms_m = 0.95F;  // a stride, or hands and feet in front
  const Eigen::Vector2f p = bodyAt(t_s).p_m.cast<float>();
  return {Eigen::Vector3f(p.x() - kArms_m, p.y() - kArms_m, -0.05F),
          Eigen::Vector3f(p.x() + kArms_m, p.y() + kArms_m, look_.height_m + 0.1F)};
}

MovedActor::MovedActor(Label label, std::shared_ptr<const Society> society, std::size_t thing, Surfaces model)
    : Actor(std::move(label)), society_(std::move(society)), thing_(thing), model_(std::move(model)) {
  for (const Surface& surface : model_) {
    for (const Vertex& vertex : surface.mesh.vertices) box_m_.extend(vertex.p_m);
  }
}

Surfaces MovedActor::surfacesAt(double t_s) const {
  const ThingState state = thingAt(t_s);
  return placed(model_, placeOf(state.p_m, state.z_m, state.heading_rad));
}

bool MovedActor::isMovingAt(double t_s) const { return society_->thingAt(thing_, t_s).isMoving; }

double MovedActor::atRestFrom_s() const { return std::numeric_limits<double>::infinity(); }

Eigen::AlignedBox3f MovedActor::boundsOf(const ThingState& state) const {
  return box_m_.transformed(placeOf(state.p_m, state.z_m, state.heading_rad));
}

Eigen::AlignedBox3f MovedActor::boundsAt(double t_s) const { return boundsOf(thingAt(t_s)); }

std::vector<RestInterval> MovedActor::restsUntil(double t_s) const {
  if (label().classId == kPerson) return {};
  std::vector<RestInterval> rests;
  for (const Society::Rest& rest : society_->restsUntil(thing_, t_s))
    rests.push_back({rest.from_s, rest.until_s, boundsOf(rest.where)});
  return rests;
}

}  // namespace wardslam::synth

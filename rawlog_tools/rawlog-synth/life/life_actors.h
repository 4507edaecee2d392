#pragma once

#include <memory>

#include "life/society.h"
#include "scene/scene.h"

namespace wardslam::synth {

/// A member of a society.
class MemberActor : public Actor {
 public:
  MemberActor(Label label, std::shared_ptr<const Society> society, std::size_t member, Look look);

  [[nodiscard]] Surfaces surfacesAt(double t_s) const override;
  [[nodiscard]] bool isMovingAt(double t_s) const override;
  [[nodiscard]] double atRestFrom_s() const override;
  [[nodiscard]] Eigen::AlignedBox3f boundsAt(double t_s) const override;
  [[nodiscard]] BodyState bodyAt(double t_s) const { return society_->memberAt(member_, t_s).state; }

 private:
  std::shared_ptr<const Society> society_;
  std::size_t member_;
  Look look_;
};

/// A thing that members move, or somebody who lies on it.
class MovedActor : public Actor {
 public:
  /// `model` in the thing's own frame.
  MovedActor(Label label, std::shared_ptr<const Society> society, std::size_t thing, Surfaces model);

  [[nodiscard]] Surfaces surfacesAt(double t_s) const override;
  [[nodiscard]] bool isMovingAt(double t_s) const override;
  /// Never, as somebody may always take it away again: see restsUntil().
  [[nodiscard]] double atRestFrom_s() const override;
  [[nodiscard]] Eigen::AlignedBox3f boundsAt(double t_s) const override;
  [[nodiscard]] std::vector<RestInterval> restsUntil(double t_s) const override;
  [[nodiscard]] ThingState thingAt(double t_s) const { return society_->thingAt(thing_, t_s).state; }

 private:
  [[nodiscard]] Eigen::AlignedBox3f boundsOf(const ThingState& state) const;

  std::shared_ptr<const Society> society_;
  std::size_t thing_;
  Surfaces model_;
  Eigen::AlignedBox3f box_m_;  ///< Of the model, in its own frame.
};

}  // namespace wardslam::synth

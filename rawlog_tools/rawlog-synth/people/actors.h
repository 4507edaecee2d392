#pragma once

#include "people/person.h"
#include "people/walker.h"
#include "scene/scene.h"

namespace wardslam::synth {

/// From `from_s` to `until_s` somebody has both hands on a trolley; grips and lets go within kGrip_s.
struct PushingTime {
  double from_s = 0.0;
  double until_s = 0.0;
};

class PersonActor : public Actor {
 public:
  PersonActor(Label label, Walker walker, Look look, PushingTime pushing = {});

  [[nodiscard]] Surfaces surfacesAt(double t_s) const override;
  [[nodiscard]] bool isMovingAt(double t_s) const override;
  [[nodiscard]] Eigen::AlignedBox3f boundsAt(double t_s) const override;
  [[nodiscard]] double atRestFrom_s() const override;
  [[nodiscard]] Gait gaitAt(double t_s) const { return walker_.at(t_s); }

 private:
  [[nodiscard]] double reachingAt(double t_s) const;

  Walker walker_;
  Look look_;
  PushingTime pushing_;
};

/// A trolley that is pushed by somebody until they let go of it; where they leave it, it stays.
class TrolleyActor : public Actor {
 public:
  /// The walker must stand still when letting go.
  TrolleyActor(Label label, Walker pusher, double until_s, Surfaces model);

  [[nodiscard]] Surfaces surfacesAt(double t_s) const override;
  [[nodiscard]] bool isMovingAt(double t_s) const override;
  [[nodiscard]] double atRestFrom_s() const override { return until_s_; }
  [[nodiscard]] Eigen::Isometry3d T_world_trolley(double t_s) const;

 private:
  Walker pusher_;
  double until_s_;
  Surfaces model_;
};

}  // namespace wardslam::synth

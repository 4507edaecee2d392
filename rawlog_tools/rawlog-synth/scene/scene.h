#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scene/mesh.h"
#include "textures/textures.h"
#include "wardslam/core/segmentation.h"

namespace wardslam::synth {

struct Surface {
  Material material = Material::Plastic;
  Mesh mesh;
};
using Surfaces = std::vector<Surface>;

/// The same elsewhere.
[[nodiscard]] Surfaces placed(Surfaces surfaces, const Eigen::Isometry3f& T);

/// Name and class of something in the scene. Id 0: the building, which is no instance.
struct Label {
  std::uint16_t id = 0;
  std::string name;
  core::ClassId classId = 0;
  std::string className;
};

/// Something that never moves; world frame.
struct Thing {
  Label label;
  Surfaces surfaces;
  int cell = 0;  ///< Part of the building (a room, say) it stands in; see Scene::mayBeSeen.
};

/// From when to when something stood where.
struct RestInterval {
  double from_s = 0.0;
  double until_s = 0.0;          ///< Infinite where it stays for good.
  Eigen::AlignedBox3f bounds_m;  ///< World frame.
};

/// Something that moves at times.
class Actor {
 public:
  explicit Actor(Label label) : label_(std::move(label)) {}
  virtual ~Actor() = default;
  Actor(const Actor&) = delete;
  Actor& operator=(const Actor&) = delete;

  [[nodiscard]] const Label& label() const { return label_; }
  /// What it looks like, in the world frame. The materials and their order are always the same.
  [[nodiscard]] virtual Surfaces surfacesAt(double t_s) const = 0;
  [[nodiscard]] virtual bool isMovingAt(double t_s) const = 0;
  /// When it comes to rest for good; infinity if never.
  [[nodiscard]] virtual double atRestFrom_s() const = 0;

  /// A box around it at that time, cheaper than its surfaces and maybe larger; world frame.
  [[nodiscard]] virtual Eigen::AlignedBox3f boundsAt(double t_s) const;
  /// When and where it rests until `t_s`, in order: what a map may hold of it. A person never rests.
  [[nodiscard]] virtual std::vector<RestInterval> restsUntil(double t_s) const;
  /// Height of the floor it is on, where its shadow falls.
  [[nodiscard]] virtual float floorZ_m() const { return 0.0F; }

 private:
  Label label_;
};

/// The rest that lasts beyond `t_s`, if it rests then: where a map finds it.
[[nodiscard]] std::optional<RestInterval> restAt(const Actor& actor, double t_s);

/// All that can be rendered. World frame: x and y along the walls, z up, floor at z = 0; metres.
struct Scene {
  std::map<Material, cv::Mat> textures;
  std::vector<Thing> things;
  std::vector<std::unique_ptr<Actor>> actors;
  /// Whether anything of that cell may be seen by a camera there (through open doors, say); what may not is not drawn.
  /// A hint that saves time: it may err towards "yes" only. Empty: everything may be seen.
  std::function<bool(int cell, const Eigen::Isometry3d& T_world_cam)> mayBeSeen;
  float farthest_m = 30.0F;  ///< Nothing is farther from a camera.
};

}  // namespace wardslam::synth

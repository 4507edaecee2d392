#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <opencv2/core.hpp>
#include <vector>

#include "camera/directions.h"
#include "scene/mesh.h"
#include "textures/textures.h"

namespace wardslam::synth {

/// Triangles of one material and one thing. Their vertices belong to somebody else, and must stay where they are.
struct Piece {
  const Vertex* vertices = nullptr;  ///< Three for each triangle, world frame.
  std::size_t triangles = 0;
  Material material = Material::Plastic;
  std::uint16_t instanceId = 0;
};

/// What a ray meets first.
struct Hit {
  const Piece* piece = nullptr;     ///< None where nothing is.
  const Vertex* corners = nullptr;  ///< Those of the triangle; the place is (1 - u - v) [0] + u [1] + v [2].
  float u = 0.0F;
  float v = 0.0F;
  float depth_m = 0.0F;  ///< Along the optical axis, in single precision.

  /// Height of the place over z = 0 of the world.
  [[nodiscard]] float z_m() const {
    return (1 - u - v) * corners[0].p_m.z() + u * corners[1].p_m.z() + v * corners[2].p_m.z();
  }
};

/// Makes trees over triangles, in which rays find them (Embree). Any number of threads may make and use trees at once.
/// The same triangles and rays give the same hits.
class RayCaster {
 public:
  class Tree;
  /// Over what is looked at in many images, or in one.
  enum class Use { Often, Once };

  /// Throws core::InputError where Embree cannot be used.
  RayCaster();
  ~RayCaster();
  RayCaster(const RayCaster&) = delete;
  RayCaster& operator=(const RayCaster&) = delete;

  [[nodiscard]] std::shared_ptr<const Tree> plant(std::vector<Piece> pieces, Use use) const;

 private:
  struct Device;
  std::unique_ptr<Device> device_;
};

/// Where rays start and where they lead.
struct RayFan {
  Directions directions;
  Eigen::Isometry3d T_world_cam = Eigen::Isometry3d::Identity();
  float nearest_m = 0.0F;  ///< Along the optical axis; what is nearer is not seen.
  float farthest_m = 0.0F;
};

/// Visits each pixel with what its ray meets first in any of the trees.
void castRays(const RayFan& fan, const std::vector<std::shared_ptr<const RayCaster::Tree>>& trees,
              const std::function<void(int x_px, int y_px, const Hit& hit)>& visit);

}  // namespace wardslam::synth

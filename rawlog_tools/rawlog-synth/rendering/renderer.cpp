#include "rendering/renderer.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "camera/lens.h"
#include "rendering/exact_depth.h"
#include "rendering/in_view.h"
#include "rendering/ray_casting.h"
#include "rendering/shading.h"

namespace wardslam::synth {
namespace {

/// Colour is rendered this much larger and averaged down: textures are not filtered for the distance.
constexpr double kSupersampling = 1.5;
constexpr float kNear_m = 0.2F;
constexpr float kShadowSpread_m = 0.22F;

using Trees = std::vector<std::shared_ptr<const RayCaster::Tree>>;

/// Each actor's shadow lies at its own height above the floor; a crowd's must not rise to the knees.
float shadowHeight_m(std::size_t actor) {
  constexpr std::size_t kApart = 4;
  const auto apart = static_cast<float>(std::min(actor, kApart));
  const auto close = static_cast<float>(actor > kApart ? (actor - kApart) % 64 : 0);
  return 0.006F + 0.003F * apart + 0.0004F * close;
}

/// What is seen of an actor, whose bounds these are: its shadow falls around it.
Eigen::AlignedBox3f withItsShadow(const Eigen::AlignedBox3f& bounds_m, float floorZ_m) {
  const Eigen::Vector3f spread(kShadowSpread_m, kShadowSpread_m, 0);
  return Eigen::AlignedBox3f(bounds_m.min() - spread, bounds_m.max() + spread)
      .extend(Eigen::Vector3f(bounds_m.center().x(), bounds_m.center().y(), floorZ_m));
}

/// Seen from above, what the shadow of these covers.
Eigen::AlignedBox2f shadowUnder(const Surfaces& surfaces) {
  Eigen::AlignedBox2f area_m;
  for (const Surface& surface : surfaces) {
    for (const Vertex& vertex : surface.mesh.vertices) area_m.extend(vertex.p_m.head<2>());
  }
  const Eigen::Vector2f spread = Eigen::Vector2f::Constant(kShadowSpread_m);
  return {area_m.min() - spread, area_m.max() + spread};
}

void addPieces(const Surfaces& surfaces, std::uint16_t instanceId, std::vector<Piece>& pieces) {
  for (const Surface& surface : surfaces) {
    pieces.push_back({surface.mesh.vertices.data(), surface.mesh.vertices.size() / 3, surface.material, instanceId});
  }
}

cv::Size larger(const core::CameraModel& camera) {
  return {cvRound(camera.width_px * kSupersampling), cvRound(camera.height_px * kSupersampling)};
}

}  // namespace

/// What moves, as far as it may be in view.
struct Moment {
  std::vector<Surfaces> surfaces;  ///< What the tree is made over.
  FloorShadows shadows;
  Trees trees;
};

struct Renderer::Impl {
  Impl(const Scene& renderedScene, const core::CameraModel& model);
  [[nodiscard]] Moment at(double t_s, const Eigen::Isometry3d& T_world_cam) const;
  [[nodiscard]] RayFan fan(const Directions& directions, const Eigen::Isometry3d& T_world_cam) const {
    return {directions, T_world_cam, kNear_m, scene.farthest_m};
  }
  [[nodiscard]] cv::Mat colours(const Moment& moment, const Eigen::Isometry3d& T_world_cam) const;
  void addTruth(const Moment& moment, const Eigen::Isometry3d& T_world_cam, Rendering& out) const;

  const Scene& scene;
  LensView lens;
  cv::Size size_px;
  Directions rays;        ///< Of the pixels.
  Directions colourRays;  ///< Of those of the larger image.
  Cells cells;
  Shading shading;
  RayCaster caster;
  std::shared_ptr<const RayCaster::Tree> things;
};

Renderer::Impl::Impl(const Scene& renderedScene, const core::CameraModel& model)
    : scene(renderedScene),
      lens(model),
      size_px(model.width_px, model.height_px),
      rays(lens.rays(size_px)),
      colourRays(lens.rays(larger(model))),
      cells(renderedScene),
      shading(renderedScene.textures) {
  std::vector<Piece> pieces;
  for (const Thing& thing : scene.things) addPieces(thing.surfaces, thing.label.id, pieces);
  things = caster.plant(std::move(pieces), RayCaster::Use::Often);
}

Moment Renderer::Impl::at(double t_s, const Eigen::Isometry3d& T_world_cam) const {
  Moment moment;
  const Frustum frustum(lens.pinhole(), T_world_cam, static_cast<double>(scene.farthest_m));
  const CellView inCells = cells.seenFrom(T_world_cam);
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < scene.actors.size(); ++i) {
    const Actor& actor = *scene.actors[i];
    const Eigen::AlignedBox3f bounds_m = withItsShadow(actor.boundsAt(t_s), actor.floorZ_m());
    if (!frustum.mayShow(bounds_m) || !inCells.mayShow(bounds_m)) continue;
    moment.surfaces.push_back(actor.surfacesAt(t_s));
    moment.shadows.add(shadowUnder(moment.surfaces.back()), actor.floorZ_m() + shadowHeight_m(i));
    addPieces(moment.surfaces.back(), actor.label().id, pieces);
  }
  moment.trees = {things};
  if (!pieces.empty()) moment.trees.push_back(caster.plant(std::move(pieces), RayCaster::Use::Once));
  return moment;
}

/// BGR.
cv::Mat Renderer::Impl::colours(const Moment& moment, const Eigen::Isometry3d& T_world_cam) const {
  const Eigen::Vector3f origin_m = T_world_cam.translation().cast<float>();
  const Eigen::Matrix3f R_world_cam = T_world_cam.linear().cast<float>();
  const bool isLow = origin_m.z() < moment.shadows.highest_m();
  cv::Mat large(colourRays.size(), CV_8UC3);
  castRays(fan(colourRays, T_world_cam), moment.trees, [&](int x, int y, const Hit& hit) {
    Eigen::Array3f colour = shading.colourOf(hit);
    if (hit.piece != nullptr && (hit.z_m() < moment.shadows.highest_m() || isLow)) {
      colour = moment.shadows.over(colour, origin_m, R_world_cam * colourRays.at(x, y), hit.depth_m);
    }
    auto& out = large.at<cv::Vec3b>(y, x);
    for (int c = 0; c < 3; ++c) out[c] = static_cast<std::uint8_t>(colour[c] + 0.5F);
  });
  cv::Mat small;
  cv::resize(large, small, size_px, 0, 0, cv::INTER_AREA);
  return small;
}

void Renderer::Impl::addTruth(const Moment& moment, const Eigen::Isometry3d& T_world_cam, Rendering& out) const {
  out.depth_m = cv::Mat::zeros(size_px, CV_32FC1);
  out.instanceIds = cv::Mat::zeros(size_px, CV_16UC1);
  ExactDepth depth(T_world_cam);
  castRays(fan(rays, T_world_cam), moment.trees, [&](int x, int y, const Hit& hit) {
    if (hit.piece == nullptr) return;
    out.depth_m.at<float>(y, x) = depth.of(hit.corners, lens.ray(x, y));
    out.instanceIds.at<std::uint16_t>(y, x) = hit.piece->instanceId;
  });
}

Renderer::Renderer(const Scene& scene, const core::CameraModel& camera)
    : impl_(std::make_unique<Impl>(scene, camera)) {}

Renderer::~Renderer() = default;

Rendering Renderer::render(double t_s, const Eigen::Isometry3d& T_world_cam) const {
  const Moment moment = impl_->at(t_s, T_world_cam);
  Rendering out;
  out.color_bgr = impl_->colours(moment, T_world_cam);
  impl_->addTruth(moment, T_world_cam, out);
  return out;
}

cv::Mat Renderer::renderColor(double t_s, const Eigen::Isometry3d& T_world_cam) const {
  return impl_->colours(impl_->at(t_s, T_world_cam), T_world_cam);
}

}  // namespace wardslam::synth

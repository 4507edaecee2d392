#include "ray_casting.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "embree_compat.h"
#include "wardslam/core/errors.h"

namespace wardslam::synth {
namespace {

constexpr int kLanes = 8;  ///< Rays that are cast together: those of 4 x 2 pixels.
constexpr int kLaneColumns = 4;
constexpr int kLaneRows = kLanes / kLaneColumns;

/// Callers bring threads of their own. And no instructions that only some processors have and that give other digits.
constexpr const char* kConfiguration = "threads=1,max_isa=avx2";

}  // namespace

struct RayCaster::Device {
  RTCDevice handle = rtcNewDevice(kConfiguration);
  Device() {
    if (handle == nullptr) throw core::InputError("nothing can be rendered on this machine: Embree does not start");
  }
  ~Device() { rtcReleaseDevice(handle); }
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
};

class RayCaster::Tree {
 public:
  Tree(RTCDevice device, std::vector<Piece> pieces, Use use);
  ~Tree() { rtcReleaseScene(scene_); }
  Tree(const Tree&) = delete;
  Tree& operator=(const Tree&) = delete;

  /// Tells of each lane that meets something nearer than `rays` says, what that is.
  void meet(const std::array<int, kLanes>& valid, RTCRayHit8& rays, std::array<Hit, kLanes>& hits) const;

 private:
  void add(RTCDevice device, const Piece& piece, RTCBuildQuality quality);

  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> corners_;  ///< 0, 1, 2, …: no corner is shared.
  RTCScene scene_;
};

RayCaster::Tree::Tree(RTCDevice device, std::vector<Piece> pieces, Use use)
    : pieces_(std::move(pieces)), scene_(rtcNewScene(device)) {
  std::size_t most = 0;
  for (const Piece& piece : pieces_) most = std::max(most, 3 * piece.triangles);
  corners_.resize(most);
  std::iota(corners_.begin(), corners_.end(), 0U);
  const RTCBuildQuality quality = use == Use::Often ? RTC_BUILD_QUALITY_MEDIUM : RTC_BUILD_QUALITY_LOW;
  rtcSetSceneBuildQuality(scene_, quality);
  rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);  // no ray slips through between two triangles
  for (const Piece& piece : pieces_) add(device, piece, quality);
  rtcCommitScene(scene_);
}

void RayCaster::Tree::add(RTCDevice device, const Piece& piece, RTCBuildQuality quality) {
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, piece.vertices, 0, sizeof(Vertex),
                             3 * piece.triangles);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, corners_.data(), 0,
                             3 * sizeof(std::uint32_t), piece.triangles);
  rtcSetGeometryBuildQuality(geometry, quality);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_, geometry);  // numbered from 0: the piece's place in the list
  rtcReleaseGeometry(geometry);
}

void RayCaster::Tree::meet(const std::array<int, kLanes>& valid, RTCRayHit8& rays,
                           std::array<Hit, kLanes>& hits) const {
  std::fill(std::begin(rays.hit.geomID), std::end(rays.hit.geomID), RTC_INVALID_GEOMETRY_ID);
  intersectTogether(valid.data(), scene_, rays);
  for (std::size_t i = 0; i < kLanes; ++i) {
    if (valid[i] == 0 || rays.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
    const Piece& piece = pieces_[rays.hit.geomID[i]];
    hits[i] = {&piece, piece.vertices + 3 * rays.hit.primID[i], rays.hit.u[i], rays.hit.v[i], rays.ray.tfar[i]};
  }
}

RayCaster::RayCaster() : device_(std::make_unique<Device>()) {}
RayCaster::~RayCaster() = default;

std::shared_ptr<const RayCaster::Tree> RayCaster::plant(std::vector<Piece> pieces, Use use) const {
  pieces.erase(std::remove_if(pieces.begin(), pieces.end(), [](const Piece& piece) { return piece.triangles == 0; }),
               pieces.end());
  return std::make_shared<const Tree>(device_->handle, std::move(pieces), use);
}

namespace {

/// The rays of 4 x 2 pixels, of which some may lie outside of the image.
class Bundle {
 public:
  Bundle(const RayFan& fan, const Eigen::Matrix3f& R_world_cam, const cv::Point& corner_px) {
    const Eigen::Vector3f origin_m = fan.T_world_cam.translation().cast<float>();
    for (int i = 0; i < kLanes; ++i) {
      const cv::Point at = corner_px + cv::Point(i % kLaneColumns, i / kLaneColumns);
      const bool isInside = at.x < fan.directions.cols && at.y < fan.directions.rows;
      const auto& direction = fan.directions.at<cv::Vec3f>(isInside ? at : corner_px);
      set(static_cast<std::size_t>(i), origin_m,
          R_world_cam * Eigen::Vector3f(direction[0], direction[1], direction[2]), fan);
      valid_[static_cast<std::size_t>(i)] = isInside ? -1 : 0;
    }
  }

  void meet(const RayCaster::Tree& tree) { tree.meet(valid_, rays_, hits_); }

  void show(const cv::Point& corner_px, const std::function<void(int, int, const Hit&)>& visit) const {
    for (int i = 0; i < kLanes; ++i) {
      const auto lane = static_cast<std::size_t>(i);
      if (valid_[lane] != 0) visit(corner_px.x + i % kLaneColumns, corner_px.y + i / kLaneColumns, hits_[lane]);
    }
  }

 private:
  void set(std::size_t lane, const Eigen::Vector3f& origin_m, const Eigen::Vector3f& direction, const RayFan& fan) {
    auto& ray = rays_.ray;
    ray.org_x[lane] = origin_m.x();
    ray.org_y[lane] = origin_m.y();
    ray.org_z[lane] = origin_m.z();
    ray.dir_x[lane] = direction.x();
    ray.dir_y[lane] = direction.y();
    ray.dir_z[lane] = direction.z();
    ray.tnear[lane] = fan.nearest_m;  // as z = 1, lengths of rays are depths
    ray.tfar[lane] = fan.farthest_m;
    ray.time[lane] = 0.0F;
    ray.mask[lane] = ~0U;
    ray.id[lane] = 0;
    ray.flags[lane] = 0;
  }

  alignas(32) std::array<int, kLanes> valid_{};
  RTCRayHit8 rays_;
  std::array<Hit, kLanes> hits_{};
};

}  // namespace

void castRays(const RayFan& fan, const std::vector<std::shared_ptr<const RayCaster::Tree>>& trees,
              const std::function<void(int x_px, int y_px, const Hit& hit)>& visit) {
  const Eigen::Matrix3f R_world_cam = fan.T_world_cam.linear().cast<float>();
  for (int y = 0; y < fan.directions.rows; y += kLaneRows) {
    for (int x = 0; x < fan.directions.cols; x += kLaneColumns) {
      Bundle bundle(fan, R_world_cam, {x, y});
      for (const auto& tree : trees) bundle.meet(*tree);
      bundle.show({x, y}, visit);
    }
  }
}

}  // namespace wardslam::synth

#include "rendering/ray_casting.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "rendering/embree_compat.h"
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
  const RTCBuildQuality quality = use == Use::Often ? RTC_BUILD_QUALITY_HIGH : RTC_BUILD_QUALITY_LOW;
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
  Bundle(const RayFan& fan, const Eigen::Matrix3f& R_world_cam) {
    const Eigen::Vector3f origin_m = fan.T_world_cam.translation().cast<float>();
    auto& ray = rays_.ray;
    std::fill_n(ray.org_x, kLanes, origin_m.x());
    std::fill_n(ray.org_y, kLanes, origin_m.y());
    std::fill_n(ray.org_z, kLanes, origin_m.z());
    std::fill_n(ray.tnear, kLanes, fan.nearest_m);  // as z = 1, lengths of rays are depths
    std::fill_n(ray.time, kLanes, 0.0F);
    std::fill_n(ray.mask, kLanes, ~0U);
    std::fill_n(ray.id, kLanes, 0U);
    std::fill_n(ray.flags, kLanes, 0U);
    turn_ = R_world_cam;
  }

  /// Turns to other pixels.
  void aim(const RayFan& fan, const cv::Point& corner_px) {
    alignas(32) std::array<float, kLanes> x{};
    alignas(32) std::array<float, kLanes> y{};
    const int columns = std::min(kLaneColumns, fan.directions.x.cols - corner_px.x);
    valid_.fill(0);
    for (int row = 0; row < kLaneRows && corner_px.y + row < fan.directions.x.rows; ++row) {
      const auto first = static_cast<std::size_t>(row * kLaneColumns);
      std::copy_n(fan.directions.x.ptr<float>(corner_px.y + row) + corner_px.x, columns, &x[first]);
      std::copy_n(fan.directions.y.ptr<float>(corner_px.y + row) + corner_px.x, columns, &y[first]);
      std::fill_n(&valid_[first], columns, -1);
    }
    auto& ray = rays_.ray;
    for (std::size_t i = 0; i < kLanes; ++i) {
      ray.dir_x[i] = turn_(0, 0) * x[i] + turn_(0, 1) * y[i] + turn_(0, 2);
      ray.dir_y[i] = turn_(1, 0) * x[i] + turn_(1, 1) * y[i] + turn_(1, 2);
      ray.dir_z[i] = turn_(2, 0) * x[i] + turn_(2, 1) * y[i] + turn_(2, 2);
    }
    std::fill_n(ray.tfar, kLanes, fan.farthest_m);
    hits_.fill({});
  }

  void meet(const RayCaster::Tree& tree) { tree.meet(valid_, rays_, hits_); }

  void show(const cv::Point& corner_px, const std::function<void(int, int, const Hit&)>& visit) const {
    for (int i = 0; i < kLanes; ++i) {
      const auto lane = static_cast<std::size_t>(i);
      if (valid_[lane] != 0) visit(corner_px.x + i % kLaneColumns, corner_px.y + i / kLaneColumns, hits_[lane]);
    }
  }

 private:
  Eigen::Matrix3f turn_;
  alignas(32) std::array<int, kLanes> valid_{};
  RTCRayHit8 rays_;
  std::array<Hit, kLanes> hits_{};
};

}  // namespace

void castRays(const RayFan& fan, const std::vector<std::shared_ptr<const RayCaster::Tree>>& trees,
              const std::function<void(int x_px, int y_px, const Hit& hit)>& visit) {
  Bundle bundle(fan, fan.T_world_cam.linear().cast<float>());
  const cv::Size size_px = fan.directions.size();
  for (int y = 0; y < size_px.height; y += kLaneRows) {
    for (int x = 0; x < size_px.width; x += kLaneColumns) {
      bundle.aim(fan, {x, y});
      for (const auto& tree : trees) bundle.meet(*tree);
      bundle.show({x, y}, visit);
    }
  }
}

}  // namespace wardslam::synth

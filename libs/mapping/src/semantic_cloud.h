#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

#include "cell_hash.h"
#include "object_votes.h"
#include "view_samples.h"
#include "wardslam/mapping/map_memory.h"
#include "wardslam/mapping/mapping_options.h"
#include "wardslam/odometry/keyframe.h"

namespace wardslam::mapping {

using odometry::KeyframeId;

/// Of a point's evidence and precision.
constexpr std::int8_t kMostEvidence = 4;     // what stood for long must still be seen to be gone within a second or two
constexpr float kMostPrecision_m2 = 4.0e6F;  // (0.5 mm)^-2: systematic errors do not average out

/// A point while it is being worked on.
struct CloudPoint {
  Eigen::Vector3f p_cam_m = Eigen::Vector3f::Zero();  ///< In the camera frame of its tile's keyframe.
  Eigen::Vector3f color_rgb = Eigen::Vector3f::Zero();
  float precision_m2 = 0.0F;  ///< Sum of 1/σ² of its sightings: its weight.
  float sigma_m = 0.0F;       ///< Depth noise of its best sighting.
  std::uint64_t cell = 0;     ///< Where the index has it.
  ObjectVotes votes;
  ObjectId object = 0;           ///< The winner of the votes.
  std::uint32_t lastFusion = 0;  ///< Number of the call that worked a sighting in.
  std::uint16_t sightings = 0;
  std::int8_t evidence = 0;  ///< Grows with every sighting, sinks with every time it is seen through; bounded.
};

/// Points seen first from one keyframe.
struct Tile {
  KeyframeId keyframe = 0;
  Eigen::Isometry3f T_map_cam = Eigen::Isometry3f::Identity();
  Eigen::Isometry3f T_map_camIndexed = Eigen::Isometry3f::Identity();  ///< The pose its cells were computed with.
  float radius_m = 0.0F;                                               ///< Of a ball round the camera with all points.
  std::vector<CloudPoint> points;
};

/// A point's place: valid until the cloud changes.
struct PointRef {
  std::uint32_t tile = 0;
  std::uint32_t point = 0;
};

/// The dense coloured cloud (P8): one point per cell, fused from all its sightings, hanging on the keyframe that saw it
/// first. Points follow their keyframes; where that brings two into one cell they become one.
class SemanticCloud {
 public:
  explicit SemanticCloud(const CloudOptions& options) : options_(options) {}

  void addTile(KeyframeId keyframe, const Eigen::Isometry3d& T_map_cam);

  /// A tile of an earlier map: all that was known of it, or of older maps what they showed of it. Its points stay as
  /// they are, also where two of them fall into one cell.
  void restore(KeyframeId keyframe, const Eigen::Isometry3d& T_map_cam, const TileMemory& saved);
  void restore(KeyframeId keyframe, const Eigen::Isometry3d& T_map_cam, const SemanticCloudTile& saved);

  [[nodiscard]] static TileMemory remember(const Tile& tile);

  /// New poses of keyframes; those unknown here are left out. Returns the objects with points on keyframes that have
  /// moved by half a voxel or more since points were last put in their cells.
  std::set<ObjectId> movePoses(const std::map<KeyframeId, Eigen::Isometry3d>& T_map_cam);

  /// The points stay where they are and hang on another keyframe; the first one's tile is gone.
  void moveTile(KeyframeId from, KeyframeId onto);

  [[nodiscard]] const Tile* find(KeyframeId keyframe) const;
  [[nodiscard]] const std::vector<Tile>& tiles() const { return tiles_; }
  [[nodiscard]] const CloudPoint& at(const PointRef& ref) const { return tiles_[ref.tile].points[ref.point]; }

  /// For each sample the point it sees again: in its cell, or up to twice the depth noise before or behind on its ray.
  [[nodiscard]] std::vector<std::optional<PointRef>> recognise(const std::vector<Sample>& samples,
                                                               const Eigen::Vector3d& camera_map_m) const;

  /// Works samples into the points they see again, and hangs the others on the keyframe. `vote`: of each sample, for
  /// its object and with which weight.
  struct LabelVote {
    ObjectId object = 0;
    float weight = 0.0F;
  };
  void fuse(const std::vector<Sample>& samples, const std::vector<std::optional<PointRef>>& points,
            const std::vector<LabelVote>& votes, KeyframeId keyframe);

  /// A view looks at the cloud: points it sees through lose evidence, and in the end their place. `nearest_m`: depth,
  /// of each pixel the least in its neighbourhood; 0 where it is unknown.
  struct Look {
    std::map<ObjectId, std::size_t> inSight;  ///< Points of each object that lie where the view measures a surface.
    std::map<ObjectId, std::size_t> erased;   ///< Points of each object that were taken away.
  };
  Look look(const core::CameraModel& camera, const Eigen::Isometry3d& T_map_cam, const cv::Mat& depth_m,
            const cv::Mat& nearest_m);

  void renameObject(ObjectId from, ObjectId into);  ///< Also where another has more votes.
  void eraseObject(ObjectId object);                ///< With all its points.
  void remove(const std::vector<PointRef>& points);
  void touchObject(ObjectId object);  ///< Its tiles count as changed.

  [[nodiscard]] const std::map<ObjectId, std::size_t>& pointCounts() const { return pointCounts_; }

  /// The points of each of these objects, in the map frame.
  [[nodiscard]] std::map<ObjectId, std::vector<Eigen::Vector3f>> pointsOf(const std::set<ObjectId>& objects) const;

  /// Tiles that may have points of these objects, or votes for them, by their place in tiles(); nobody else has.
  [[nodiscard]] std::set<std::uint32_t> tilesOf(const std::set<ObjectId>& objects) const;

  /// Takes over all tiles of another cloud, whose poses must be in this cloud's map frame by now.
  void absorb(SemanticCloud&& other);

  /// Objects with points that came, went or moved, by however little, since the last call.
  [[nodiscard]] std::set<ObjectId> takeChangedObjects();

  /// Keyframes whose tiles changed since the last call.
  [[nodiscard]] std::set<KeyframeId> takeChanges() { return std::exchange(changed_, {}); }

 private:
  [[nodiscard]] std::optional<PointRef> at(std::uint64_t cell) const;
  [[nodiscard]] Eigen::Vector3f mapPosition(const PointRef& ref) const;
  CloudPoint& point(const PointRef& ref) { return tiles_[ref.tile].points[ref.point]; }
  void update(const PointRef& ref, const Sample& sample, const LabelVote& vote);
  void create(std::uint32_t tile, const Sample& sample, const LabelVote& vote);
  void relocate(std::vector<PointRef> moved);
  void merge(const PointRef& from, const PointRef& into);
  void erase(std::vector<PointRef> gone);
  void reindex(const std::vector<std::uint32_t>& tiles);
  void enter(const std::vector<std::uint32_t>& tiles);
  void enterUnchanged(std::uint32_t tile);

  void noteVote(std::uint32_t tile, ObjectId object);
  void noteVotes(std::uint32_t tile, const ObjectVotes& votes);
  void noteChange(ObjectId object);
  void setObject(CloudPoint& point, ObjectId object);

  CloudOptions options_;
  std::vector<Tile> tiles_;
  std::map<KeyframeId, std::uint32_t> tileOf_;
  std::vector<std::uint32_t> freeTiles_;  ///< Without keyframe and points, to be used again.
  std::unordered_map<std::uint64_t, PointRef, CellHash> index_;
  std::map<ObjectId, std::size_t> pointCounts_;          ///< Of every object that has points.
  std::map<ObjectId, std::set<std::uint32_t>> tilesOf_;  ///< In which a point has, or had, a vote for the object.
  std::pair<ObjectId, std::uint32_t> lastVoted_;         ///< One of these: samples that follow each other vote alike.
  std::set<KeyframeId> changed_;
  std::set<ObjectId> changedObjects_;
  ObjectId lastChanged_ = 0;      ///< One of them: points that follow each other are mostly of one object.
  std::set<KeyframeId> shifted_;  ///< Have new poses since objects were last asked for.
  std::uint32_t fusions_ = 0;
};

}  // namespace wardslam::mapping

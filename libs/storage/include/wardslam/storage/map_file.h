#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "wardslam/core/errors.h"
#include "wardslam/mapping/map_memory.h"
#include "wardslam/mapping/semantic_map.h"
#include "wardslam/odometry/keyframe.h"

namespace wardslam::storage {

/// Two keyframes and how the newer one (`to`) stood when seen from the older.
struct LoopEdge {
  odometry::KeyframeId from = 0;
  odometry::KeyframeId to = 0;
  Eigen::Isometry3d T_from_to = Eigen::Isometry3d::Identity();
  int inliers = 30;  ///< Of a loop: points that agree with it.
};

/// Who saw which point, and where the points are.
struct GraphContent {
  std::map<odometry::KeyframeId, std::vector<odometry::Sighting>> sightings;
  std::map<odometry::PointId, Eigen::Vector3d> p_map_m;
};

/// What is to be written together. What is not named stays as it is; maps and lists hold what is new or has changed.
struct MapChanges {
  std::map<odometry::KeyframeId, mapping::MappedKeyframe> keyframes;
  std::vector<std::shared_ptr<const odometry::Keyframe>> views;  ///< New: what keyframes saw. Their poses are above.
  std::map<odometry::PointId, Eigen::Vector3d> p_map_m;          ///< Points of the views; unknown ones are left out.
  std::map<odometry::PointId, odometry::PointId> fusedPoints;    ///< The first turned out to be the second.
  std::vector<odometry::PointId> removedPoints;
  std::vector<odometry::KeyframeId> removedKeyframes;  ///< With all that names them, and points nobody else saw.
  /// In place of all sightings, points and loops there are; key points that show none of the points are erased.
  std::optional<GraphContent> graph;
  std::vector<LoopEdge> loops;
  std::map<odometry::KeyframeId, mapping::SemanticCloudTile> cloud;  ///< A tile without points is removed.
  std::vector<mapping::MapObject> objects;
  std::vector<mapping::ObjectId> removedObjects;
  std::optional<std::vector<mapping::Zone>> zones;  ///< All of them.
  std::optional<mapping::FloorPlan> floorPlan;
  bool outdatesFloorPlan = false;  ///< The one there is no more that of the map; drawn anew it may come with this.
  std::optional<core::LabelSpace> labels;    ///< Names of classes, besides those there are.
  std::optional<mapping::MapMemory> memory;  ///< All of the objects; of the tiles, those that changed.
  mapping::ObjectId nextObjectId = 0;        ///< 0: as it was.
  std::optional<std::uint32_t> mapPiece;     ///< This piece is the map from now on, however large others are.
};

/// The whole of a semantic map, to be written into an empty file.
[[nodiscard]] MapChanges everythingOf(const mapping::SemanticMap& map);

/// What a new file is told once.
struct MapHeader {
  core::LabelSpace labels = core::LabelSpace::coco();
  std::string options;                          ///< YAML, as `wardslam config` writes it.
  std::map<std::uint32_t, std::string> from{};  ///< Of a map made of several: the files each piece came from.
};

/// A piece at a glance.
struct PieceInfo {
  std::uint32_t piece = 0;
  bool isMap = false;
  std::size_t keyframes = 0;
  double firstStamp_s = 0.0;
  double lastStamp_s = 0.0;
  std::string from;  ///< The files it came from, where the map was made of several.
};

/// A map file at a glance.
struct MapFileInfo {
  int schemaVersion = 0;
  std::uintmax_t size_bytes = 0;
  std::size_t keyframes = 0;           ///< Of the map, as cloud points and objects are.
  std::size_t pieces = 0;              ///< The map and what is not joined to it.
  std::vector<PieceInfo> parts;        ///< Each of them, the map first.
  std::size_t keyframesElsewhere = 0;  ///< Of the pieces that are not joined to the map.
  std::size_t trackingPoints = 0;      ///< Of key points, to recognise places by.
  std::size_t loops = 0;
  std::size_t cloudPoints = 0;
  std::size_t objects = 0;  ///< Those that are gone included.
  std::size_t zones = 0;
  double firstStamp_s = 0.0;  ///< UNIX time of the oldest keyframe; 0 without keyframes.
  double lastStamp_s = 0.0;
};

/// Another program holds the map file.
class MapInUse : public core::InputError {
 public:
  using core::InputError::InputError;
};

enum class MapAccess {
  Read,
  Write,
  Untouched,  ///< To read; nothing is written into the file, an older one is brought up to date in memory.
};
enum class CloudPart { Include, LeaveOut };
enum class PiecePart { TheMap, All };  ///< Those not joined to the map have frames of their own.

/// A map on disk, `*.wardmap`: one SQLite database (docs/file_formats.md). Every write() is one transaction: whatever
/// happens to the process or the power, the file holds all of it or nothing. What read() gives is in the map frame.
///
/// All members throw core::InputError with the file's name where it is damaged, cannot be written, or (MapInUse) is in
/// use.
class MapFile {
 public:
  static constexpr int kPatience_ms = 5000;

  /// Makes an empty map, in place of a file that may be there.
  [[nodiscard]] static MapFile create(const std::filesystem::path& file, const MapHeader& header = {});

  /// Makes a map that holds so much, in place of a file that may be there: whatever happens, that or the new one is.
  [[nodiscard]] static MapFile create(const std::filesystem::path& file, const MapHeader& header,
                                      const MapChanges& content);

  /// Leaves a file that may be there alone. Throws core::InputError where create() would.
  static void requireThatOneCanBeMade(const std::filesystem::path& file);

  /// Undoes what a killed process left half written. A file that an older version wrote is brought up to date. To leave
  /// it untouched, nothing may have been left half written.
  [[nodiscard]] static MapFile open(const std::filesystem::path& file, MapAccess access = MapAccess::Read);

  /// The map as it is at this moment, in a file of its own, in place of one that may be there.
  static void copy(const std::filesystem::path& from, const std::filesystem::path& to);

  ~MapFile();
  MapFile(MapFile&&) noexcept;
  MapFile& operator=(MapFile&&) noexcept;

  /// `patience_ms`: how long to wait for other programs that hold the file.
  void write(const MapChanges& changes, int patience_ms = kPatience_ms);

  /// Writes into a copy and gives it the file's name: programs that read the file go on reading what they opened.
  void writeBeside(const MapChanges& changes);

  /// Writes what is in the file into a new one, which takes its name: nothing is left of what was erased, and it is as
  /// small as it can be. Programs that read the file go on reading what they opened.
  void compact();

  [[nodiscard]] MapFileInfo info() const;
  [[nodiscard]] MapHeader header() const;
  [[nodiscard]] mapping::SemanticMap read(CloudPart cloud = CloudPart::Include,
                                          PiecePart pieces = PiecePart::TheMap) const;

  /// read() of the map. The floor plan of a run that was killed before it drew one is made up for.
  [[nodiscard]] mapping::SemanticMap readWithFloorPlan(CloudPart cloud) const;

  /// What is known besides, for MapBuilder::restore().
  [[nodiscard]] mapping::MapMemory readMemory() const;

  /// Of that, what is known of objects, of all pieces, without reading the rest.
  [[nodiscard]] std::map<mapping::ObjectId, mapping::ObjectMemory> readObjectMemories() const;

  /// What the keyframes of all pieces saw, in order of their ids; `submap` is the piece, sightings name points of
  /// readPoints().
  [[nodiscard]] std::vector<odometry::Keyframe> readViews() const;
  [[nodiscard]] std::uint32_t readFreeSubmap() const;  ///< No submap has had this number or a higher.
  [[nodiscard]] std::map<odometry::PointId, Eigen::Vector3d> readPoints() const;  ///< p_map_m
  [[nodiscard]] std::vector<LoopEdge> readLoops() const;

  /// Reads everything and follows every reference; one sentence for each thing that is wrong.
  [[nodiscard]] std::vector<std::string> check() const;

 private:
  struct Connection;
  explicit MapFile(std::unique_ptr<Connection> connection);

  /// Null: an empty map.
  [[nodiscard]] static MapFile createWith(const std::filesystem::path& file, const MapHeader& header,
                                          const MapChanges* content);

  /// Sightings under old ids may still come, also after the file was opened anew.
  void remember(const std::map<odometry::PointId, odometry::PointId>& fusedPoints);

  std::unique_ptr<Connection> connection_;
};

}  // namespace wardslam::storage

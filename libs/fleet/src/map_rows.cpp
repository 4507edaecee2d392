#include "map_rows.h"

#include <limits>
#include <opencv2/core.hpp>
#include <sstream>

#include "digest.h"
#include "zone_rules.h"

namespace wardslam::fleet {
namespace {

/// Takes a row's columns one after the other.
class Columns {
 public:
  explicit Columns(const pqxx::row& row) : row_(row) {}

  template <class T>
  T next() {
    return row_[index_++].as<T>();
  }
  template <class T>
  T nextOr(const T& instead) {
    return row_[index_++].as<T>(instead);
  }
  Eigen::Vector3d nextPoint() {
    const auto x = next<double>();
    const auto y = next<double>();
    return {x, y, next<double>()};
  }
  Eigen::Quaterniond nextTurn() {
    const Eigen::Vector3d imaginary = nextPoint();
    const auto w = next<double>();
    return {w, imaginary.x(), imaginary.y(), imaginary.z()};
  }
  Eigen::AlignedBox3d nextBox() {
    const Eigen::Vector3d least = nextPoint();
    return {least, nextPoint()};
  }

 private:
  pqxx::row row_;
  pqxx::row::size_type index_ = 0;
};

void putBox(Json& row, const Eigen::Vector3d& place_m, const Eigen::AlignedBox3d& box_m) {
  row["x"] = place_m.x();
  row["y"] = place_m.y();
  row["z"] = place_m.z();
  row["x0"] = box_m.min().x();
  row["y0"] = box_m.min().y();
  row["z0"] = box_m.min().z();
  row["x1"] = box_m.max().x();
  row["y1"] = box_m.max().y();
  row["z1"] = box_m.max().z();
}

Eigen::Isometry3d poseOf(const Eigen::Vector3d& t_m, const Eigen::Quaterniond& q) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = q.toRotationMatrix();
  pose.translation() = t_m;
  return pose;
}

/// A pose that was read gives other last bits when it is written again: so rows are told apart by their digests.
Json withDigest(Json row) {
  constexpr std::size_t kDigits = 32;
  row["digest"] = digestOf(parameterOf(row)).substr(0, kDigits);
  return row;
}

mapping::ObjectState stateNamed(const std::string& name) {
  using mapping::ObjectState;
  if (name == "gone") return ObjectState::Gone;
  return name == "moved" ? ObjectState::Moved : ObjectState::Static;
}

constexpr const char* kBoxColumns =
    "ST_X(place), ST_Y(place), ST_Z(place), ST_XMin(box), ST_YMin(box), ST_ZMin(box), ST_XMax(box), ST_YMax(box), "
    "ST_ZMax(box)";

mapping::MapObject objectOf(const pqxx::row& row) {
  Columns columns(row);
  mapping::MapObject object;
  object.id = columns.next<mapping::ObjectId>();
  object.classId = static_cast<core::ClassId>(columns.next<int>());
  object.probability = columns.next<double>();
  object.centroid_m = columns.nextPoint();
  object.box_m = columns.nextBox();
  const Eigen::Vector3d centre_m = columns.nextPoint();
  object.orientedBox.T_map_box = poseOf(centre_m, columns.nextTurn());
  object.orientedBox.size_m = columns.nextPoint();
  object.firstSeen_s = columns.next<double>();
  object.lastSeen_s = columns.next<double>();
  object.views = columns.next<int>();
  object.zone = columns.next<std::string>();
  object.state = stateNamed(columns.next<std::string>());
  const auto same = columns.nextOr<mapping::ObjectId>(0);
  const auto probability = columns.nextOr<double>(0.0);
  if (same != 0) object.maybeSameAs = mapping::MaybeSame{same, probability};
  return object;
}

}  // namespace

std::string parameterOf(const Json& rows) { return rows.dump(-1, ' ', false, Json::error_handler_t::replace); }

std::string arrayOf(const std::vector<std::uint64_t>& numbers) {
  std::string text = "{";
  for (const auto number : numbers) text += (text.size() > 1 ? "," : "") + std::to_string(number);
  return text + "}";
}

Json rowOf(std::uint64_t number, const mapping::MappedKeyframe& keyframe, int run) {
  const Eigen::Vector3d t_m = keyframe.T_map_cam.translation();
  const Eigen::Quaterniond q(keyframe.T_map_cam.linear());
  return withDigest({{"number", number},
                     {"run", run},
                     {"stamp_s", keyframe.stamp_s},
                     {"x", t_m.x()},
                     {"y", t_m.y()},
                     {"z", t_m.z()},
                     {"qx", q.x()},
                     {"qy", q.y()},
                     {"qz", q.z()},
                     {"qw", q.w()},
                     {"zone", keyframe.zone}});
}

Json rowOf(const mapping::MapObject& object) {
  const Eigen::Vector3d centre_m = object.orientedBox.T_map_box.translation();
  const Eigen::Quaterniond q(object.orientedBox.T_map_box.linear());
  const Eigen::Vector3d& size_m = object.orientedBox.size_m;
  Json row = {{"number", object.id},
              {"class_id", object.classId},
              {"probability", object.probability},
              {"box_x_m", centre_m.x()},
              {"box_y_m", centre_m.y()},
              {"box_z_m", centre_m.z()},
              {"box_qx", q.x()},
              {"box_qy", q.y()},
              {"box_qz", q.z()},
              {"box_qw", q.w()},
              {"box_length_m", size_m.x()},
              {"box_width_m", size_m.y()},
              {"box_height_m", size_m.z()},
              {"first_seen_s", object.firstSeen_s},
              {"last_seen_s", object.lastSeen_s},
              {"views", object.views},
              {"zone", object.zone},
              {"state", toString(object.state)},
              {"maybe_same_as", nullptr},
              {"maybe_probability", nullptr}};
  putBox(row, object.centroid_m, object.box_m);
  if (object.maybeSameAs) {
    row["maybe_same_as"] = object.maybeSameAs->id;
    row["maybe_probability"] = object.maybeSameAs->probability;
  }
  return withDigest(std::move(row));
}

Json rowOf(const building::Room& room) {
  std::ostringstream ring;
  ring.precision(std::numeric_limits<double>::max_digits10);
  for (const auto& corner : room.outline_m) ring << corner.x() << " " << corner.y() << ", ";
  ring << room.outline_m.front().x() << " " << room.outline_m.front().y();
  return withDigest({{"number", room.id}, {"name", room.name}, {"area", "POLYGON((" + ring.str() + "))"}});
}

Json rowOf(mapping::ObjectId object, const Stay& stay) {
  Json row = {{"object", object},  {"since_s", stay.since_s}, {"until_s", stay.until_s},
              {"zone", stay.zone}, {"ended", nullptr},        {"ended_s", nullptr}};
  putBox(row, stay.place_m, stay.box_m);
  if (!stay.ended.empty()) {
    row["ended"] = stay.ended;
    row["ended_s"] = stay.ended_s;
  }
  return row;
}

std::map<int, std::string> namesOf(const core::LabelSpace& labels) {
  std::map<int, std::string> names;
  for (int id = 0; id <= UINT8_MAX; ++id) {
    const std::string& name = labels.name(static_cast<core::ClassId>(id));
    if (!name.empty()) names[id] = name;
  }
  return names;
}

core::LabelSpace readLabels(pqxx::transaction_base& transaction, std::int64_t map) {
  core::LabelSpace labels;
  for (const auto& row : execute(transaction, "SELECT class_id, name FROM labels WHERE map = $1", map)) {
    labels.rename(static_cast<core::ClassId>(row[0].as<int>()), row[1].as<std::string>());
  }
  return labels;
}

std::map<std::uint64_t, mapping::MappedKeyframe> readKeyframes(pqxx::transaction_base& transaction, std::int64_t map) {
  std::map<std::uint64_t, mapping::MappedKeyframe> keyframes;
  const auto rows = execute(transaction,
                            "SELECT number, stamp_s, zone, ST_X(place), ST_Y(place), ST_Z(place), qx, qy, qz, qw "
                            "FROM keyframes WHERE map = $1",
                            map);
  for (const auto& row : rows) {
    Columns columns(row);
    auto& keyframe = keyframes[columns.next<std::uint64_t>()];
    keyframe.stamp_s = columns.next<double>();
    keyframe.zone = columns.next<std::string>();
    const Eigen::Vector3d t_m = columns.nextPoint();
    keyframe.T_map_cam = poseOf(t_m, columns.nextTurn());
  }
  return keyframes;
}

std::map<mapping::ObjectId, mapping::MapObject> readObjects(pqxx::transaction_base& transaction, std::int64_t map) {
  std::map<mapping::ObjectId, mapping::MapObject> objects;
  const auto rows = execute(transaction,
                            std::string("SELECT number, class_id, probability, ") + kBoxColumns +
                                ", box_x_m, box_y_m, box_z_m, box_qx, box_qy, box_qz, box_qw, box_length_m, "
                                "box_width_m, box_height_m, first_seen_s, last_seen_s, views, zone, state, "
                                "maybe_same_as, maybe_probability FROM objects WHERE map = $1 AND in_map",
                            map);
  for (const auto& row : rows) {
    auto object = objectOf(row);
    objects.emplace(object.id, std::move(object));
  }
  return objects;
}

std::vector<mapping::Zone> readZones(pqxx::transaction_base& transaction, std::int64_t map) {
  std::vector<mapping::Zone> zones;
  int position = -1;
  const auto rows = execute(transaction,
                            "SELECT position, name, rule, ST_X(corner.geom), ST_Y(corner.geom) FROM zones, "
                            "ST_DumpPoints(ST_ExteriorRing(area)) AS corner WHERE map = $1 "
                            "ORDER BY position, corner.path",
                            map);
  for (const auto& row : rows) {
    Columns columns(row);
    const auto number = columns.next<int>();
    const auto name = columns.next<std::string>();
    const auto rule = columns.next<std::string>();
    if (number != position) {
      zones.push_back({name, {}});
      takeRule(nlohmann::json::parse(rule), zones.back());
    }
    position = number;
    const auto x_m = columns.next<double>();
    zones.back().polygon_m.emplace_back(x_m, columns.next<double>());
  }
  for (auto& zone : zones) zone.polygon_m.pop_back();  // the ring is closed
  return zones;
}

mapping::FloorPlan readFloorPlan(pqxx::transaction_base& transaction, std::int64_t map) {
  mapping::FloorPlan plan;
  const auto rows =
      execute(transaction,
              "SELECT resolution_m, origin_x_m, origin_y_m, rows, columns, cells FROM floor_plans WHERE map = $1", map);
  if (rows.empty()) return plan;
  plan.resolution_m = rows[0][0].as<double>();
  plan.origin_m = {rows[0][1].as<double>(), rows[0][2].as<double>()};
  std::string cells = bytesOf(rows[0][5]);
  plan.cells = cv::Mat(rows[0][3].as<int>(), rows[0][4].as<int>(), CV_8UC1, cells.data()).clone();
  return plan;
}

std::map<mapping::ObjectId, Stay> readLastStays(pqxx::transaction_base& transaction, std::int64_t map) {
  std::map<mapping::ObjectId, Stay> stays;
  const auto rows =
      execute(transaction,
              std::string("SELECT DISTINCT ON (object) object, since_s, until_s, zone, coalesce(ended, ''), "
                          "coalesce(ended_s, 0), ") +
                  kBoxColumns + " FROM sightings WHERE map = $1 ORDER BY object, since_s DESC",
              map);
  for (const auto& row : rows) {
    Columns columns(row);
    Stay& stay = stays[columns.next<mapping::ObjectId>()];
    stay.since_s = columns.next<double>();
    stay.until_s = columns.next<double>();
    stay.zone = columns.next<std::string>();
    stay.ended = columns.next<std::string>();
    stay.ended_s = columns.next<double>();
    stay.place_m = columns.nextPoint();
    stay.box_m = columns.nextBox();
  }
  return stays;
}

}  // namespace wardslam::fleet

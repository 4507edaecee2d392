#include "map_rows.h"

#include <array>
#include <cmath>

namespace wardslam::storage {
namespace {

constexpr std::array<const char*, 3> kStates = {"static", "moved", "gone"};
constexpr double kShortestQuaternion = 1e-3;

}  // namespace

ParameterBinder& ParameterBinder::operator<<(const Bytes& value) {
  statement_.bind(++index_, value.data(), static_cast<int>(value.size()));
  return *this;
}

ParameterBinder& ParameterBinder::operator<<(const Eigen::Isometry3d& pose) {
  const Eigen::Quaterniond q(pose.linear());
  return *this << Eigen::Vector3d(pose.translation()) << q.x() << q.y() << q.z() << q.w();
}

ColumnReader& ColumnReader::operator>>(double& value) {
  value = statement_.getColumn(index_).getDouble();
  if (!std::isfinite(value)) failAtColumn();
  ++index_;
  return *this;
}

ColumnReader& ColumnReader::operator>>(std::string& value) {
  value = statement_.getColumn(index_++).getString();
  return *this;
}

ColumnReader& ColumnReader::operator>>(Bytes& value) {
  const SQLite::Column column = statement_.getColumn(index_++);
  const auto* const first = static_cast<const std::uint8_t*>(column.getBlob());
  value.assign(first, first + column.getBytes());
  return *this;
}

ColumnReader& ColumnReader::operator>>(Eigen::Isometry3d& pose) {
  Eigen::Vector3d t;
  Eigen::Quaterniond q;
  *this >> t >> q.x() >> q.y() >> q.z() >> q.w();
  if (q.norm() < kShortestQuaternion) throw BlobError("its quaternion is zero");
  pose = Eigen::Translation3d(t) * q.normalized();
  return *this;
}

void ColumnReader::failAtColumn() {
  throw BlobError(std::string("its ") + statement_.getColumn(index_).getName() + " is impossible");
}

const char* nameOf(mapping::ObjectState state) { return kStates.at(static_cast<std::size_t>(state)); }

mapping::ObjectState objectState(const std::string& name) {
  for (std::size_t i = 0; i < kStates.size(); ++i) {
    if (name == kStates.at(i)) return static_cast<mapping::ObjectState>(i);
  }
  throw BlobError("its state is '" + name + "'");
}

}  // namespace wardslam::storage

#include "map_rows.h"

#include <limits>

namespace wardslam::storage {
namespace {

constexpr double kShortestQuaternion = 1e-3;
constexpr double kLongestQuaternion = 1e3;

}  // namespace

ParameterBinder& ParameterBinder::operator<<(const core::Bytes& value) {
  statement_.bind(++index_, value.data(), static_cast<int>(value.size()));
  return *this;
}

ParameterBinder& ParameterBinder::operator<<(const Eigen::Isometry3d& pose) {
  const Eigen::Quaterniond q(pose.linear());
  return *this << Eigen::Vector3d(pose.translation()) << q.x() << q.y() << q.z() << q.w();
}

ColumnReader& ColumnReader::operator>>(double& value) {
  return *this >> within(value, std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max());
}

ColumnReader& ColumnReader::operator>>(const Within<double>& column) {
  requireNumber();
  column.value = statement_.getColumn(index_).getDouble();
  if (!(column.value >= column.least && column.value <= column.most)) failAtColumn(index_);
  ++index_;
  return *this;
}

ColumnReader& ColumnReader::operator>>(std::string& value) {
  value = statement_.getColumn(index_++).getString();
  return *this;
}

ColumnReader& ColumnReader::operator>>(core::Bytes& value) {
  const SQLite::Column column = statement_.getColumn(index_++);
  const auto* const first = static_cast<const std::uint8_t*>(column.getBlob());
  value.assign(first, first + column.getBytes());
  return *this;
}

ColumnReader& ColumnReader::operator>>(Eigen::Isometry3d& pose) {
  Eigen::Vector3d t;
  Eigen::Quaterniond q;
  *this >> t;
  for (double* part : {&q.x(), &q.y(), &q.z(), &q.w()}) *this >> within(*part, -kLongestQuaternion, kLongestQuaternion);
  if (q.norm() < kShortestQuaternion) throw core::BlobError("its quaternion is zero");
  pose = Eigen::Translation3d(t) * q.normalized();
  return *this;
}

void ColumnReader::requireNumber() {
  const SQLite::Column column = statement_.getColumn(index_);
  if (!column.isInteger() && !column.isFloat()) failAtColumn(index_);
}

void ColumnReader::failAtColumn(int index) {
  throw core::BlobError(std::string("its ") + statement_.getColumn(index).getName() + " is impossible");
}

mapping::ObjectState objectState(const std::string& name) {
  using mapping::ObjectState;
  for (const auto state : {ObjectState::Static, ObjectState::Moved, ObjectState::Gone}) {
    if (name == toString(state)) return state;
  }
  throw core::BlobError("its state is '" + name + "'");
}

}  // namespace wardslam::storage

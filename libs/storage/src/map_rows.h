#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <Eigen/Geometry>
#include <string>

#include "wardslam/core/blob.h"
#include "wardslam/mapping/map_object.h"

/// Between C++ values and columns of the map file.
namespace wardslam::storage {

/// Binds values to a statement's parameters, one after another, and reads columns in the same manner.
class ParameterBinder {
 public:
  explicit ParameterBinder(SQLite::Statement& statement) : statement_(statement) { statement_.reset(); }

  ParameterBinder& operator<<(double value) { return bind(value); }
  ParameterBinder& operator<<(int value) { return bind(value); }
  ParameterBinder& operator<<(std::uint32_t value) { return bind(value); }
  ParameterBinder& operator<<(std::uint64_t value) { return bind(static_cast<std::int64_t>(value)); }
  ParameterBinder& operator<<(const std::string& value) { return bind(value); }
  ParameterBinder& operator<<(const char* value) { return bind(value); }
  ParameterBinder& operator<<(const core::Bytes& value);
  ParameterBinder& operator<<(const Eigen::Vector2d& value) { return *this << value.x() << value.y(); }
  ParameterBinder& operator<<(const Eigen::Vector3d& value) { return *this << value.x() << value.y() << value.z(); }
  ParameterBinder& operator<<(const Eigen::Isometry3d& pose);  ///< x y z qx qy qz qw

  void run() { statement_.exec(); }

 private:
  template <class Value>
  ParameterBinder& bind(const Value& value) {
    statement_.bind(++index_, value);
    return *this;
  }

  SQLite::Statement& statement_;
  int index_ = 0;
};

/// A column between bounds, these included.
template <class Number>
struct Within {
  Number& value;
  Number least;
  Number most;
};
template <class Number>
[[nodiscard]] Within<Number> within(Number& value, Number least, Number most) {
  return {value, least, most};
}

/// No place on this earth counts as far in metres, nor a time of robots in seconds.
inline constexpr double kFarthest_m = 1e8;
inline constexpr double kLatest_s = 1e11;

/// Throws BlobError where a column is no number, or one outside its type or its bounds, and where a quaternion has no
/// direction. Vectors are positions or lengths (m): no farther than kFarthest_m.
class ColumnReader {
 public:
  explicit ColumnReader(SQLite::Statement& statement) : statement_(statement) {}

  ColumnReader& operator>>(double& value);  ///< Finite.
  ColumnReader& operator>>(const Within<double>& column);
  template <class Integer>
  ColumnReader& operator>>(const Within<Integer>& column) {
    integer(column.value);
    if (column.value < column.least || column.value > column.most) failAtColumn(index_ - 1);
    return *this;
  }
  ColumnReader& operator>>(int& value) { return integer(value); }
  ColumnReader& operator>>(std::uint8_t& value) { return integer(value); }
  ColumnReader& operator>>(std::uint32_t& value) { return integer(value); }
  ColumnReader& operator>>(std::uint64_t& value) { return integer(value); }
  ColumnReader& operator>>(std::string& value);
  ColumnReader& operator>>(core::Bytes& value);
  ColumnReader& operator>>(Eigen::Vector2d& value) { return length(value.x()).length(value.y()); }
  ColumnReader& operator>>(Eigen::Vector3d& value) { return length(value.x()).length(value.y()).length(value.z()); }
  ColumnReader& operator>>(Eigen::Isometry3d& pose);

 private:
  template <class Integer>
  ColumnReader& integer(Integer& value) {
    requireNumber();
    const std::int64_t number = statement_.getColumn(index_).getInt64();
    value = static_cast<Integer>(number);
    if (static_cast<std::int64_t>(value) != number || (std::is_unsigned_v<Integer> && number < 0)) failAtColumn(index_);
    ++index_;
    return *this;
  }
  ColumnReader& length(double& value) { return *this >> within(value, -kFarthest_m, kFarthest_m); }
  void requireNumber();
  [[noreturn]] void failAtColumn(int index);

  SQLite::Statement& statement_;
  int index_ = 0;
};

[[nodiscard]] mapping::ObjectState objectState(const std::string& name);  ///< Throws BlobError.

}  // namespace wardslam::storage

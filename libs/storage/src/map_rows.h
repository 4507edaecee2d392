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

/// Throws BlobError where a number lies outside its type, or a quaternion has no direction.
class ColumnReader {
 public:
  explicit ColumnReader(SQLite::Statement& statement) : statement_(statement) {}

  ColumnReader& operator>>(double& value);  ///< Finite.
  ColumnReader& operator>>(int& value) { return integer(value); }
  ColumnReader& operator>>(std::uint8_t& value) { return integer(value); }
  ColumnReader& operator>>(std::uint32_t& value) { return integer(value); }
  ColumnReader& operator>>(std::uint64_t& value) { return integer(value); }
  ColumnReader& operator>>(std::string& value);
  ColumnReader& operator>>(core::Bytes& value);
  ColumnReader& operator>>(Eigen::Vector2d& value) { return *this >> value.x() >> value.y(); }
  ColumnReader& operator>>(Eigen::Vector3d& value) { return *this >> value.x() >> value.y() >> value.z(); }
  ColumnReader& operator>>(Eigen::Isometry3d& pose);

 private:
  template <class Integer>
  ColumnReader& integer(Integer& value) {
    const std::int64_t number = statement_.getColumn(index_).getInt64();
    value = static_cast<Integer>(number);
    if (static_cast<std::int64_t>(value) != number || (std::is_unsigned_v<Integer> && number < 0)) failAtColumn();
    ++index_;
    return *this;
  }
  [[noreturn]] void failAtColumn();

  SQLite::Statement& statement_;
  int index_ = 0;
};

[[nodiscard]] mapping::ObjectState objectState(const std::string& name);  ///< Throws BlobError.

}  // namespace wardslam::storage

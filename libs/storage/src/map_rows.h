#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <Eigen/Geometry>
#include <cstdint>
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

/// What ids, pieces and counts of any map have room in; the next ones still fit where they are counted.
inline constexpr std::uint64_t kHighestId = std::uint64_t{1} << 53U;
inline constexpr std::uint32_t kHighestSmallId = 4'000'000'000;
inline constexpr std::uint32_t kMostPieces = 1'000'000'000;
inline constexpr int kMostCounted = 1'000'000'000;
[[nodiscard]] inline Within<double> stampIn(double& stamp_s) { return {stamp_s, 0.0, kLatest_s}; }
[[nodiscard]] inline Within<std::uint64_t> idIn(std::uint64_t& id) { return {id, 0, kHighestId}; }
[[nodiscard]] inline Within<std::uint32_t> idIn(std::uint32_t& id) { return {id, 0, kHighestSmallId}; }
[[nodiscard]] inline Within<std::uint32_t> pieceIn(std::uint32_t& piece) { return {piece, 0, kMostPieces}; }
[[nodiscard]] inline Within<int> countIn(int& count) { return {count, 0, kMostCounted}; }

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

/// Hands every row to `take`; trouble with a row is told with `what` it is and its first column.
template <class Take>
void forEachRow(SQLite::Database& database, const std::string& what, const char* sql, const Take& take) {
  SQLite::Statement statement(database, sql);
  while (statement.executeStep()) {
    try {
      take(ColumnReader(statement));
    } catch (const core::BlobError& error) {
      throw core::BlobError(what + " " + statement.getColumn(0).getString() + ": " + error.what());
    }
  }
}

[[nodiscard]] mapping::ObjectState objectState(const std::string& name);  ///< Throws BlobError.

}  // namespace wardslam::storage

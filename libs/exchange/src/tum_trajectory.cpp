#include "wardslam/exchange/tum_trajectory.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iomanip>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "trajectory_columns.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/rigid_transform.h"
#include "wardslam/core/text_lines.h"

namespace wardslam::exchange {
namespace {

namespace fs = std::filesystem;
using core::StampUnit;
using core::TextLine;

constexpr double kFarthest_m = 1e8;  ///< No grid on earth counts as far; squares of more may be infinite.

[[noreturn]] void fail(const fs::path& file, const TextLine& line, const std::string& expected) {
  constexpr std::size_t kShown = 80;
  throw core::InputError(file.string() + ":" + std::to_string(line.number) + ": expected " + expected + ", found '" +
                         line.text.substr(0, kShown) + "'");
}

/// Where a list is parted by blanks and every number has a comma, that is the decimal point.
std::vector<std::string> fieldsIn(const std::string& text) {
  std::string blanks = text;
  bool hasCommas = true;
  for (std::size_t at = 0; at < blanks.size() && hasCommas;) {
    const std::size_t end = std::min(blanks.find_first_of(" \t", at), blanks.size());
    const std::string word = blanks.substr(at, end - at);
    if (!word.empty()) {
      hasCommas = std::count(word.begin(), word.end(), ',') == 1 && word.front() != ',' && word.back() != ',' &&
                  word.find('.') == std::string::npos;
    }
    at = end + 1;
  }
  if (hasCommas && blanks.find_first_of(" \t") != std::string::npos) {
    std::replace(blanks.begin(), blanks.end(), ',', '.');
  }
  return core::wordsIn(blanks);
}

std::optional<double> parseNumber(std::string_view text) {
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [parsedTo, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || parsedTo != end) return std::nullopt;
  return number;
}

/// Nothing unless every field is a number.
std::optional<std::vector<double>> parseNumbers(const std::vector<std::string>& fields) {
  std::vector<double> numbers;
  for (const std::string& field : fields) {
    const auto number = parseNumber(field);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

/// The lines with poses, and what their columns mean.
struct PoseTable {
  std::vector<TextLine> lines;
  TrajectoryColumns columns;
  bool hasHeadings = false;
};

constexpr const char* kExpected = "the 8 numbers 'timestamp tx ty tz qx qy qz qw'";

PoseTable readTable(const fs::path& file) {
  PoseTable table;
  std::optional<TrajectoryColumns> headings;
  for (TextLine& line : core::readTextLines(file)) {
    const bool isFirst = table.lines.empty() && !line.isRemark;
    if (line.isRemark || (isFirst && !parseNumbers(fieldsIn(line.text)) && columnsByHeadings(line.text))) {
      if (table.lines.empty()) {
        if (const auto columns = columnsByHeadings(line.text)) headings = columns;
      }
      continue;
    }
    table.lines.push_back(std::move(line));
  }
  if (table.lines.empty()) return table;
  const auto first = parseNumbers(fieldsIn(table.lines.front().text));
  if (!first) fail(file, table.lines.front(), kExpected);
  table.hasHeadings = headings && headings->count == first->size();
  const auto columns = table.hasHeadings ? headings : columnsByNumbers(*first);
  if (!columns) fail(file, table.lines.front(), kExpected);
  table.columns = *columns;
  return table;
}

/// Angles, or another column, may stand where an orientation should.
bool isOrientation(const std::vector<double>& row, const TrajectoryColumns& columns) {
  constexpr double kTolerated = 0.05;
  if (columns.isMatrix) {
    const Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>> matrix(row.data());
    return core::isRotation(matrix.leftCols<3>(), kTolerated);
  }
  double squares = 0.0;
  for (const std::size_t column : columns.orientation) squares += row[column] * row[column];
  return std::abs(std::sqrt(squares) - 1.0) < kTolerated;
}

std::string oddOrientation(const fs::path& file, const TextLine& line, const TrajectoryColumns& columns) {
  return file.string() + ":" + std::to_string(line.number) +
         (columns.isMatrix
              ? ": has a matrix that is no rotation, and the nearest is taken"
              : ": has a quaternion whose length is not 1, and its direction is taken; angles are not read");
}

void tellOfColumns(const PoseTable& table, const fs::path& file, const TrajectoryReading& reading) {
  const TrajectoryColumns standard;
  const bool isCsv = !table.lines.empty() && table.lines.front().text.find(',') != std::string::npos &&
                     table.lines.front().text.find_first_of(" \t") == std::string::npos;
  if (isCsv && !table.hasHeadings) {
    reading.note(file.string() + ": has no headings, so quaternions are taken in the order x y z w (EuRoC's w x y z)");
  }
  if (table.lines.empty() || (table.columns.count == standard.count &&
                              table.columns.orientation == standard.orientation && table.columns.stamp == 0U)) {
    return;
  }
  if (table.columns.isMatrix) {
    reading.note(file.string() +
                 ": has 12 numbers a line, which are taken for the 3x4 matrices of KITTI, one an image");
  } else {
    reading.note(file.string() + ": has " + std::to_string(table.columns.count) +
                 " columns, whose order is taken from " +
                 (table.hasHeadings ? "its headings" : "their numbers, besides one that numbers the poses"));
  }
}

std::vector<std::string> stampsOf(const PoseTable& table) {
  std::vector<std::string> stamps;
  for (const TextLine& line : table.lines) {
    const auto fields = fieldsIn(line.text);
    const std::size_t column = table.columns.stamp.value_or(0);
    if (!table.columns.stamp) {
      stamps.push_back(std::to_string(stamps.size()));
    } else if (column < fields.size()) {
      stamps.push_back(fields[column]);
    }
  }
  return stamps;
}

/// Small whole numbers stay what they are unless it is known that they number images.
StampUnit unitOf(const std::vector<std::string>& stamps) {
  return core::recogniseStampUnit({stamps.begin(), stamps.end()}).value_or(StampUnit::Seconds);
}

core::StampClock clockFor(StampUnit unit, const fs::path& file, const TrajectoryReading& reading) {
  if (unit == StampUnit::Frames && !reading.rate_hz) return core::StampClock();
  const core::StampClock clock(unit, reading.rate_hz.value_or(1.0));
  if (!clock.isSeconds()) reading.note(file.string() + ": " + clock.sentencePart());
  return clock;
}

/// Nothing where the row holds no pose: NaN, or a quaternion without direction.
std::optional<Eigen::Isometry3d> poseOf(const std::vector<double>& row, const TrajectoryColumns& columns) {
  if (!std::all_of(row.begin(), row.end(), [](double number) { return std::isfinite(number); })) return std::nullopt;
  if (columns.isMatrix) {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    const Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>> matrix(row.data());
    T.linear() = Eigen::Quaterniond(Eigen::Matrix3d(matrix.leftCols<3>())).normalized().toRotationMatrix();
    T.translation() = matrix.col(3);
    return T;
  }
  const auto& [x, y, z, w] = columns.orientation;
  const Eigen::Quaterniond q(row[w], row[x], row[y], row[z]);
  if (q.norm() < std::numeric_limits<double>::epsilon()) return std::nullopt;
  const auto& [px, py, pz] = columns.position;
  return Eigen::Translation3d(row[px], row[py], row[pz]) * q.normalized();
}

}  // namespace

core::Trajectory readTumTrajectory(const fs::path& file, const TrajectoryReading& reading) {
  const PoseTable table = readTable(file);
  tellOfColumns(table, file, reading);
  const core::StampClock clock = clockFor(unitOf(stampsOf(table)), file, reading);
  std::map<double, Eigen::Isometry3d> poses;
  std::size_t number = 0;
  bool isOdd = false;
  for (const TextLine& line : table.lines) {
    const auto fields = fieldsIn(line.text);
    const auto row = parseNumbers(fields);
    if (!row || row->size() != table.columns.count) fail(file, line, kExpected);
    const std::string stamp = table.columns.stamp ? fields[*table.columns.stamp] : std::to_string(number++);
    const auto stamp_s = clock.seconds(stamp);
    const auto T_map_cam = stamp_s ? poseOf(*row, table.columns) : std::nullopt;
    if (T_map_cam && !(T_map_cam->translation().cwiseAbs().maxCoeff() <= kFarthest_m)) {
      fail(file, line, "a position in metres on this earth");
    }
    if (T_map_cam && !isOdd && !isOrientation(*row, table.columns)) {
      isOdd = true;
      reading.note(oddOrientation(file, line, table.columns));
    }
    if (T_map_cam) poses.insert_or_assign(*stamp_s, *T_map_cam);
  }
  if (poses.empty()) throw core::InputError(file.string() + ": holds no pose; is it the trajectory you meant?");

  core::Trajectory trajectory;
  trajectory.reserve(poses.size());
  for (const auto& [stamp_s, T_map_cam] : poses) trajectory.push_back({stamp_s, T_map_cam});
  return trajectory;
}

bool numbersImages(const fs::path& trajectory) { return unitOf(stampsOf(readTable(trajectory))) == StampUnit::Frames; }

std::vector<double> readTumStamps(const fs::path& file, const TrajectoryReading& reading) {
  std::vector<std::string> words;
  std::vector<TextLine> lines;
  for (TextLine& line : core::readTextLines(file)) {
    if (line.isRemark) continue;
    const auto fields = core::wordsIn(line.text);
    words.push_back(fields.empty() ? "" : fields.front());
    lines.push_back(std::move(line));
  }
  const core::StampClock clock = clockFor(unitOf(words), file, reading);
  std::set<double> stamps_s;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto stamp_s = clock.seconds(words[i]);
    if (!stamp_s) fail(file, lines[i], "a timestamp in the first column");
    stamps_s.insert(*stamp_s);
  }
  if (stamps_s.empty()) throw core::InputError(file.string() + ": holds no timestamp; is it the list you meant?");
  return {stamps_s.begin(), stamps_s.end()};
}

TumTrajectoryWriter::TumTrajectoryWriter(const std::filesystem::path& file) : file_(file) {
  file_.stream() << "# timestamp tx ty tz qx qy qz qw\n" << std::fixed << std::flush;
}

TumTrajectoryWriter::~TumTrajectoryWriter() {
  try {
    finish();
  } catch (const core::InputError&) {
    // What was written stays in the partial file.
  }
}

void TumTrajectoryWriter::write(const core::StampedPose& pose) {
  const Eigen::Vector3d t = pose.T_map_cam.translation();
  const Eigen::Quaterniond q(pose.T_map_cam.rotation());
  file_.stream() << std::setprecision(6) << pose.stamp_s << std::setprecision(9);
  for (const double value : {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()}) file_.stream() << ' ' << value;
  file_.stream() << '\n' << std::flush;
}

void TumTrajectoryWriter::writeComment(const std::string& line) {
  file_.stream() << "# " << line << '\n' << std::flush;
}

void TumTrajectoryWriter::finish() {
  if (finished_) return;
  file_.commit();
  finished_ = true;
}

}  // namespace wardslam::exchange

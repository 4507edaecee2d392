#include "wardslam/exchange/tum_trajectory.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "wardslam/core/errors.h"

namespace wardslam::exchange {
namespace {

constexpr std::string_view kSeparators = " \t,\r";
constexpr double kFarthest_m = 1e8;  ///< No grid on earth counts as far; squares of more may be infinite.

struct Line {
  std::size_t number = 0;
  std::string text;
};

std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> fields;
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(kSeparators), text.size()));
    if (text.empty()) return fields;
    fields.push_back(text.substr(0, text.find_first_of(kSeparators)));
    text.remove_prefix(fields.back().size());
  }
}

/// The lines that are neither blank nor a comment.
std::vector<Line> readLines(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in || std::filesystem::is_directory(file)) {
    throw core::InputError(file.string() + ": cannot be opened; is it there and a text file?");
  }
  std::vector<Line> lines;
  std::string text;
  for (std::size_t number = 1; std::getline(in, text); ++number) {
    const auto fields = split(text);
    if (!fields.empty() && fields.front().front() != '#') lines.push_back({number, text});
  }
  return lines;
}

[[noreturn]] void fail(const std::filesystem::path& file, const Line& line, const std::string& expected) {
  constexpr std::size_t kShown = 80;
  throw core::InputError(file.string() + ":" + std::to_string(line.number) + ": expected " + expected + ", found '" +
                         line.text.substr(0, kShown) + "'");
}

std::optional<double> parseNumber(std::string_view text) {
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [parsedTo, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || parsedTo != end) return std::nullopt;
  return number;
}

/// Nothing unless every field is a number.
std::optional<std::vector<double>> parseNumbers(std::string_view text) {
  std::vector<double> numbers;
  for (const std::string_view field : split(text)) {
    const auto number = parseNumber(field);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

/// `row`: timestamp tx ty tz qx qy qz qw. Nothing where it holds no pose: NaN, or a quaternion without direction.
std::optional<Eigen::Isometry3d> poseOf(const std::vector<double>& row) {
  if (!std::all_of(row.begin(), row.end(), [](double number) { return std::isfinite(number); })) return std::nullopt;
  const Eigen::Quaterniond q(row[7], row[4], row[5], row[6]);
  if (q.norm() < std::numeric_limits<double>::epsilon()) return std::nullopt;
  return Eigen::Translation3d(row[1], row[2], row[3]) * q.normalized();
}

}  // namespace

core::Trajectory readTumTrajectory(const std::filesystem::path& file) {
  std::map<double, Eigen::Isometry3d> poses;
  for (const Line& line : readLines(file)) {
    const auto row = parseNumbers(line.text);
    if (!row || row->size() != 8) fail(file, line, "the 8 numbers 'timestamp tx ty tz qx qy qz qw'");
    const auto T_map_cam = poseOf(*row);
    if (T_map_cam && !(T_map_cam->translation().cwiseAbs().maxCoeff() <= kFarthest_m)) {
      fail(file, line, "a position in metres on this earth");
    }
    if (T_map_cam) poses.insert_or_assign(row->front(), *T_map_cam);
  }
  if (poses.empty()) throw core::InputError(file.string() + ": holds no pose; is it the trajectory you meant?");

  core::Trajectory trajectory;
  trajectory.reserve(poses.size());
  for (const auto& [stamp_s, T_map_cam] : poses) trajectory.push_back({stamp_s, T_map_cam});
  return trajectory;
}

std::vector<double> readTumStamps(const std::filesystem::path& file) {
  std::set<double> stamps_s;
  for (const Line& line : readLines(file)) {
    const auto stamp_s = parseNumber(split(line.text).front());
    if (!stamp_s || !std::isfinite(*stamp_s)) fail(file, line, "a timestamp in the first column");
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

void TumTrajectoryWriter::finish() {
  if (finished_) return;
  file_.commit();
  finished_ = true;
}

}  // namespace wardslam::exchange

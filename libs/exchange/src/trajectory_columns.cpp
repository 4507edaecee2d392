#include "trajectory_columns.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "wardslam/core/text_lines.h"

namespace wardslam::exchange {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

std::string lowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

bool contains(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

/// Without '#' and without units, which stand in brackets.
std::vector<std::string> namesIn(const std::string& headings) {
  std::string text;
  bool isUnit = false;
  for (const char letter : headings) {
    isUnit = letter == '[' || letter == '(' || (isUnit && letter != ']' && letter != ')');
    if (!isUnit && letter != '#' && letter != ']' && letter != ')') text += letter;
  }
  std::vector<std::string> names;
  for (const std::string& word : core::wordsIn(text)) names.push_back(lowerCase(word));
  return names;
}

bool isStampName(const std::string& name) {
  return name == "t" || name == "ts" || contains(name, "time") || contains(name, "stamp") || name == "sec";
}

bool isOrientationName(const std::string& name) {
  return name.front() == 'q' || name.back() == 'w' || contains(name, "_q") || contains(name, "quat") ||
         contains(name, "orient") || contains(name, "rot");
}

/// Unit quaternions give the columns away.
bool isOrientationAt(const std::vector<double>& row, std::size_t first) {
  double norm = 0.0;
  for (std::size_t i = first; i < first + 4; ++i) norm += row[i] * row[i];
  return std::abs(norm - 1.0) < 0.01;
}

bool isWhole(double number) { return number == std::floor(number); }

}  // namespace

std::optional<TrajectoryColumns> columnsByHeadings(const std::string& headings) {
  const auto names = namesIn(headings);
  TrajectoryColumns columns;
  columns.count = names.size();
  columns.stamp.reset();
  columns.position.fill(kNone);
  columns.orientation.fill(kNone);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (isStampName(names[i])) {
      if (!columns.stamp) columns.stamp = i;
      continue;
    }
    const std::size_t axis = std::string("xyzw").find(names[i].back());
    if (axis == std::string::npos) continue;
    const bool isOrientation = isOrientationName(names[i]);
    if (!isOrientation && axis > 2) continue;
    std::size_t& column = isOrientation ? columns.orientation.at(axis) : columns.position.at(axis);
    if (column == kNone) column = i;  // EuRoC's velocities come behind
  }
  const auto isKnown = [](std::size_t column) { return column != kNone; };
  const bool isComplete = columns.stamp && std::all_of(columns.position.begin(), columns.position.end(), isKnown) &&
                          std::all_of(columns.orientation.begin(), columns.orientation.end(), isKnown);
  return isComplete ? std::optional(columns) : std::nullopt;
}

std::optional<TrajectoryColumns> columnsByNumbers(const std::vector<double>& row) {
  TrajectoryColumns columns;
  columns.count = row.size();
  if (row.size() == 8) return columns;
  if (row.size() == 12) {
    columns.stamp.reset();
    columns.isMatrix = true;
    return columns;
  }
  if (row.size() != 9) return std::nullopt;
  if (isOrientationAt(row, 4) && isWhole(row[8])) return columns;
  if (!isOrientationAt(row, 5) || !isWhole(row[0])) return std::nullopt;
  columns.stamp = 1;
  columns.position = {2, 3, 4};
  columns.orientation = {5, 6, 7, 8};
  return columns;
}

}  // namespace wardslam::exchange

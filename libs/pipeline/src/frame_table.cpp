#include "wardslam/pipeline/frame_table.h"

#include <charconv>
#include <cmath>
#include <iomanip>
#include <optional>
#include <string>

#include "dynamic_keypoints.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/text_lines.h"

namespace wardslam::pipeline {
namespace {

constexpr const char* kHeadings = "timestamp,state,key_points,dynamic_key_points,inliers,held_by_depth,keyframe,piece";
constexpr std::size_t kColumns = 8;

template <class Number>
bool read(const std::string& word, Number& number) {
  const char* end = word.data() + word.size();
  const auto result = std::from_chars(word.data(), end, number);
  return result.ec == std::errc() && result.ptr == end;
}

bool read(const std::string& word, bool& flag) {
  flag = word == "1";
  return word == "0" || word == "1";
}

bool read(const std::string& word, odometry::State& state) {
  for (const auto known : {odometry::State::Initialising, odometry::State::Ok, odometry::State::Lost}) {
    if (word != odometry::toString(known)) continue;
    state = known;
    return true;
  }
  return false;
}

std::optional<FrameRow> rowOf(const std::string& line) {
  const auto words = core::wordsIn(line);
  FrameRow row;
  const bool isRow = words.size() == kColumns && read(words[0], row.stamp_s) && std::isfinite(row.stamp_s) &&
                     read(words[1], row.state) && read(words[2], row.keypoints) &&
                     read(words[3], row.dynamicKeypoints) && row.dynamicKeypoints <= row.keypoints &&
                     read(words[4], row.inliers) && read(words[5], row.isHeldByDepth) &&
                     read(words[6], row.isKeyframe) && read(words[7], row.piece);
  return isRow ? std::optional(row) : std::nullopt;
}

}  // namespace

FrameTable::FrameTable(const std::filesystem::path& file) : file_(file) {
  file_.stream() << kHeadings << '\n' << std::fixed << std::setprecision(6) << std::flush;
}

void FrameTable::onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) {
  file_.stream() << frame.stamp_s - stampOrigin_s_ << ',' << odometry::toString(odometry.state) << ','
                 << frame.features.size() << ',' << countDynamic(frame.features.keypoints) << ',' << odometry.inliers
                 << ',' << odometry.isHeldByDepth << ',' << (odometry.keyframe != nullptr) << ',' << odometry.piece
                 << '\n'
                 << std::flush;
}

std::vector<FrameRow> readFrameTable(const std::filesystem::path& file) {
  const auto lines = core::readTextLines(file);
  std::vector<FrameRow> rows;
  for (const auto& line : lines) {
    if (&line == &lines.front() && line.text == kHeadings) continue;
    if (const auto row = rowOf(line.text)) {
      rows.push_back(*row);
    } else if (&line != &lines.back()) {
      throw core::InputError(file.string() + ":" + std::to_string(line.number) + ": is no line of " + kHeadings +
                             "; the file was not written by this program, or has been changed");
    }
  }
  return rows;
}

}  // namespace wardslam::pipeline

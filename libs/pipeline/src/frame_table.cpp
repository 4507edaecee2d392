#include "wardslam/pipeline/frame_table.h"

#include <cmath>
#include <iomanip>
#include <optional>
#include <string>

#include "dynamic_keypoints.h"
#include "table_text.h"

namespace wardslam::pipeline {
namespace {

constexpr const char* kHeadings = "timestamp,state,key_points,dynamic_key_points,inliers,held_by_depth,keyframe,piece";
constexpr std::size_t kColumns = 8;

bool readFlag(const std::string& word, bool& flag) {
  flag = word == "1";
  return word == "0" || word == "1";
}

bool readState(const std::string& word, odometry::State& state) {
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
  const bool isRow = words.size() == kColumns && readWord(words[0], row.stamp_s) && std::isfinite(row.stamp_s) &&
                     readState(words[1], row.state) && readWord(words[2], row.keypoints) &&
                     readWord(words[3], row.dynamicKeypoints) && row.dynamicKeypoints <= row.keypoints &&
                     readWord(words[4], row.inliers) && readFlag(words[5], row.isHeldByDepth) &&
                     readFlag(words[6], row.isKeyframe) && readWord(words[7], row.piece);
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

std::vector<FrameRow> readFrameTable(const std::filesystem::path& file) { return readTable(file, kHeadings, rowOf); }

}  // namespace wardslam::pipeline

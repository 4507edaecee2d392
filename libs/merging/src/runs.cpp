#include "runs.h"

#include <algorithm>
#include <map>
#include <opencv2/core.hpp>
#include <set>
#include <tuple>
#include <utility>

#include "wardslam/core/errors.h"

namespace wardslam::merging {
namespace {

Run readRun(const std::filesystem::path& file) {
  Run run;
  run.file = file;
  run.header = storage::MapFile::open(file, storage::MapAccess::Untouched).header();
  run.map = pipeline::readEarlierMap(file, graph::Saved::MayChange, storage::MapAccess::Untouched);
  run.map.semantic.cloud.clear();
  run.map.memory.tiles.clear();
  return run;
}

/// By when it was made; of several at the very same time by what is in them.
bool isOlder(const Run& a, const Run& b) {
  const auto signatureOf = [](const Run& run) {
    const auto& keyframes = run.map.graph.keyframes;
    const auto& points = run.map.graph.p_map_m;
    return std::tuple(keyframes.front()->stamp_s, keyframes.back()->stamp_s, keyframes.size(), points.size(),
                      points.empty() ? 0.0 : points.begin()->second.x());
  };
  return signatureOf(a) < signatureOf(b);
}

bool areSame(const odometry::Keyframe& a, const odometry::Keyframe& b) {
  const cv::Mat& first = a.features.descriptors;
  const cv::Mat& second = b.features.descriptors;
  return a.stamp_s == b.stamp_s && first.size() == second.size() &&
         (first.empty() || cv::norm(first, second, cv::NORM_L1) == 0.0);
}

/// Of the classes of things: a number means one thing, and a name has one number.
void requireSameNames(const Run& a, const Run& b) {
  const core::LabelSpace& others = b.header.labels;
  for (const auto& [id, object] : a.map.semantic.objects) {
    const std::string& name = a.header.labels.name(object.classId);
    const std::string& other = others.name(object.classId);
    const auto number = others.find(name);
    const bool isNamedOtherwise = !name.empty() && !other.empty() && name != other;
    if (!isNamedOtherwise && (name.empty() || !number || *number == object.classId)) continue;
    throw core::InputError("class " + std::to_string(object.classId) + " is '" + name + "' in " + a.file.string() +
                           ", but not in " + b.file.string() + "; only maps made with the same classes can be merged");
  }
}

void nameRuns(std::vector<Run>& runs) {
  std::map<std::string, int> uses;
  for (const Run& run : runs) ++uses[run.file.filename().string()];
  for (Run& run : runs) {
    run.name = run.file.filename().string();
    if (uses.at(run.name) > 1)
      run.name = (std::filesystem::absolute(run.file).parent_path().filename() / run.name).string();
  }
}

}  // namespace

bool shareKeyframes(const Run& a, const Run& b) {
  std::map<double, const odometry::Keyframe*> byStamp;
  for (const auto& keyframe : a.map.graph.keyframes) byStamp[keyframe->stamp_s] = keyframe.get();
  return std::any_of(b.map.graph.keyframes.begin(), b.map.graph.keyframes.end(), [&](const auto& keyframe) {
    const auto same = byStamp.find(keyframe->stamp_s);
    return same != byStamp.end() && areSame(*same->second, *keyframe);
  });
}

std::vector<Run> readRuns(const std::vector<std::filesystem::path>& maps, const ProgressSink& progress) {
  std::vector<Run> runs;
  for (const auto& file : maps) {
    runs.push_back(readRun(file));
    progress({"map", runs.size(), maps.size()});
  }
  std::sort(runs.begin(), runs.end(), isOlder);
  nameRuns(runs);
  std::vector<pipeline::EarlierMap*> all;
  for (Run& run : runs) all.push_back(&run.map);
  const auto numbers = renumber(all);
  for (std::size_t i = 0; i < runs.size(); ++i) runs[i].numbers = numbers[i];
  return runs;
}

RunCloud readCloud(const Run& run) {
  const auto file = storage::MapFile::open(run.file, storage::MapAccess::Untouched);
  RunCloud cloud;
  cloud.known = renumbered(file.readMemory().tiles, run.numbers);
  cloud.shown = renumbered(file.read(storage::CloudPart::Include, storage::PiecePart::All).cloud, run.numbers);
  for (const auto& [id, tile] : cloud.known) cloud.shown.erase(id);
  return cloud;
}

void requireThatTheyFit(const std::vector<Run>& runs) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    for (std::size_t j = i + 1; j < runs.size(); ++j) {
      requireSameNames(runs[i], runs[j]);
      requireSameNames(runs[j], runs[i]);
      if (!shareKeyframes(runs[i], runs[j])) continue;
      throw core::InputError(runs[i].file.string() + " and " + runs[j].file.string() +
                             " hold the same keyframes: one is the other, gone on with; leave the smaller one out");
    }
  }
}

}  // namespace wardslam::merging

// measure_metric_map EMBEDDED.rawlog TRAJECTORY.txt MAP.wardmap: a CSemanticMap that is filled
// with annotated scans (`rawlog-annotate --embed`) from where a run's cameras were, beside the map that the run made:
// time per scan, how much of both clouds is in both (voxels of 5 cm), points of people, things, time to write and read.
//
// measure_metric_map A.bt B.bt: occupied cells of two OctoMaps that are in both.

#include <mrpt/io/CMemoryStream.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/serialization/CArchive.h>
#include <octomap/OcTree.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <exception>
#include <iostream>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "wardslam/core/mrpt_compat.h"
#include "wardslam/exchange/tum_trajectory.h"
#include "wardslam/mapping/cloud_in_map.h"
#include "wardslam/mrpt_plugin/register_all.h"
#include "wardslam/mrpt_plugin/semantic_metric_map.h"
#include "wardslam/pipeline/slam_options.h"
#include "wardslam/storage/map_file.h"

namespace {

using namespace wardslam;
using mrpt_plugin::CSemanticMap;
using Voxel = std::array<int, 3>;

constexpr float kVoxel_m = 0.05F;
constexpr core::ClassId kPerson = 1;
constexpr double kSamePlace_m = 0.1;

template <class Do>
double milliseconds(const Do& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

const core::StampedPose* poseAt(const core::Trajectory& trajectory, double stamp_s) {
  for (const auto& pose : trajectory) {
    if (std::abs(pose.stamp_s - stamp_s) < 1e-3) return &pose;
  }
  return nullptr;
}

/// Times are per scan with what its image shows.
std::vector<double> fill(CSemanticMap& map, const std::string& rawlogFile, const core::Trajectory& trajectory) {
  mrpt::obs::CRawlog rawlog;
  if (!rawlog.loadFromRawLogFile(rawlogFile)) throw std::runtime_error(rawlogFile + ": cannot be read");
  std::vector<double> times_ms;
  mrpt::poses::CPose3D T_map_robot;
  for (std::size_t i = 0; i < rawlog.size(); ++i) {
    if (rawlog.getType(i) != mrpt::obs::CRawlog::etObservation) continue;
    const auto observation = rawlog.getAsObservation(i);
    if (const auto scan = std::dynamic_pointer_cast<mrpt::obs::CObservation3DRangeScan>(observation)) {
      const auto* camera = poseAt(trajectory, core::fromMrptTime(scan->timestamp));
      if (camera == nullptr) continue;
      T_map_robot = core::toMrpt(camera->T_map_cam) + (-(scan->sensorPose + scan->relativePoseIntensityWRTDepth));
      times_ms.push_back(0.0);
    }
    if (!times_ms.empty()) times_ms.back() += milliseconds([&] { map.insertObservation(*observation, T_map_robot); });
  }
  if (times_ms.empty()) throw std::runtime_error("no scan has a pose");
  return times_ms;
}

std::set<Voxel> voxelsOf(const mapping::SemanticMap& map) {
  std::set<Voxel> voxels;
  mapping::forEachCloudPoint(map, [&](const Eigen::Vector3f& p_m, const mapping::SemanticPoint&) {
    const auto cell = [](float at_m) { return static_cast<int>(std::floor(at_m / kVoxel_m)); };
    voxels.insert({cell(p_m.x()), cell(p_m.y()), cell(p_m.z())});
  });
  return voxels;
}

/// Voxels of `a` that are in `b`, or next to one of it: a point on the border of a voxel may fall to either side.
double shareIn(const std::set<Voxel>& a, const std::set<Voxel>& b, int around) {
  std::size_t found = 0;
  for (const auto& [x, y, z] : a) {
    bool isThere = false;
    for (int i = -around; i <= around && !isThere; ++i)
      for (int j = -around; j <= around && !isThere; ++j)
        for (int k = -around; k <= around && !isThere; ++k) isThere = b.count({x + i, y + j, z + k}) > 0;
    found += isThere ? 1 : 0;
  }
  return static_cast<double>(found) / static_cast<double>(a.size());
}

std::size_t pointsOfPeople(const mapping::SemanticMap& map) {
  std::size_t count = 0;
  mapping::forEachCloudPoint(map, [&](const Eigen::Vector3f&, const mapping::SemanticPoint& point) {
    count += point.classId == kPerson ? 1 : 0;
  });
  return count;
}

/// Things of `a` that `b` has, too: of the same class and state, in the same place.
std::string thingsIn(const mapping::SemanticMap& a, const mapping::SemanticMap& b) {
  std::size_t found = 0;
  for (const auto& [id, thing] : a.objects) {
    found += std::any_of(b.objects.begin(), b.objects.end(), [&thing = thing](const auto& other) {
      return other.second.classId == thing.classId && other.second.state == thing.state &&
             (other.second.centroid_m - thing.centroid_m).norm() < kSamePlace_m;
    });
  }
  return std::to_string(found) + " of " + std::to_string(a.objects.size());
}

/// The fastest of some, as other programs may run beside.
void measureSerialization(const CSemanticMap& map) {
  constexpr int kTimes = 7;
  double writing_ms = 1e9;
  double reading_ms = 1e9;
  for (int i = 0; i < kTimes; ++i) {
    mrpt::io::CMemoryStream stream;
    auto archive = mrpt::serialization::archiveFrom(stream);
    writing_ms = std::min(writing_ms, milliseconds([&] { archive << map; }));
    stream.Seek(0);
    CSemanticMap back;
    reading_ms = std::min(reading_ms, milliseconds([&] { archive >> back; }));
  }
  const double hundredThousand = static_cast<double>(map.points().size()) / 100000.0;
  std::cout << "per 100,000 points: written in " << writing_ms / hundredThousand << " ms, read in "
            << reading_ms / hundredThousand << " ms\n";
}

void compareMaps(char** arguments) {
  mrpt_plugin::registerAll();
  CSemanticMap filled;
  pipeline::SlamOptions run;
  filled.insertionOptions.views = run.mapping.views;
  auto times_ms = fill(filled, arguments[1], exchange::readTumTrajectory(arguments[2]));
  const mapping::SemanticMap ofRun = storage::MapFile::open(arguments[3]).read();
  const mapping::SemanticMap& ofScans = filled.map();
  const auto scans = voxelsOf(ofScans);
  const auto theRun = voxelsOf(ofRun);
  std::sort(times_ms.begin(), times_ms.end());
  const double sum_ms = std::accumulate(times_ms.begin(), times_ms.end(), 0.0);
  std::cout << times_ms.size() << " scans, mean " << sum_ms / static_cast<double>(times_ms.size()) << " ms, median "
            << times_ms[times_ms.size() / 2] << " ms, 95th percentile " << times_ms[times_ms.size() * 95 / 100]
            << " ms\n"
            << "voxels: " << scans.size() << " and " << theRun.size() << " of the run; of the scans' in the run "
            << shareIn(scans, theRun, 0) << ", of the run's in the scans' " << shareIn(theRun, scans, 0)
            << "; one voxel off: " << shareIn(scans, theRun, 1) << ", " << shareIn(theRun, scans, 1) << "\n"
            << "points of people: " << pointsOfPeople(ofScans) << " and " << pointsOfPeople(ofRun) << "\n"
            << "things of the scans in the run: " << thingsIn(ofScans, ofRun)
            << ", of the run in the scans: " << thingsIn(ofRun, ofScans) << "\n";
  measureSerialization(filled);
}

std::set<Voxel> occupiedCells(const std::string& file) {
  octomap::OcTree tree(0.1);
  if (!tree.readBinary(file)) throw std::runtime_error(file + ": is no OctoMap");
  tree.expand();
  std::set<Voxel> cells;
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    const auto key = leaf.getKey();
    if (tree.isNodeOccupied(*leaf)) cells.insert({key[0], key[1], key[2]});
  }
  return cells;
}

void compareOctomaps(const std::string& a, const std::string& b) {
  const auto ofA = occupiedCells(a);
  const auto ofB = occupiedCells(b);
  std::cout << "occupied: " << ofA.size() << " and " << ofB.size() << "; of the first in the second "
            << shareIn(ofA, ofB, 0) << ", of the second in the first " << shareIn(ofB, ofA, 0) << "\n";
}

}  // namespace

int main(int count, char** arguments) try {
  if (count == 3) {
    compareOctomaps(arguments[1], arguments[2]);
  } else if (count == 4) {
    compareMaps(arguments);
  } else {
    throw std::runtime_error(
        "usage: measure_metric_map EMBEDDED.rawlog TRAJECTORY.txt MAP.wardmap, or measure_metric_map A.bt B.bt");
  }
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 1;
}

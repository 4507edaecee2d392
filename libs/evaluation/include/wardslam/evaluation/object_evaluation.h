#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "wardslam/core/segmentation.h"
#include "wardslam/evaluation/error_statistics.h"

namespace wardslam::evaluation {

/// A thing that truly stands somewhere.
struct TrueObject {
  std::string name;
  core::ClassId classId = 0;
  std::string className;
  Eigen::AlignedBox3d box_m;
  int framesVisible = 0;
  int maxPixels = 0;  ///< In the image that shows it largest.
};

/// A thing a map says stands somewhere.
struct FoundObject {
  unsigned id = 0;
  core::ClassId classId = 0;
  std::string className;
  Eigen::Vector3d centroid_m = Eigen::Vector3d::Zero();
  Eigen::AlignedBox3d box_m;
  std::optional<Eigen::Vector3d> orientedSize_m;  ///< Lengths of its oriented box, height last.
};

/// What counts as seen well enough to be missed.
struct SeenWell {
  int frames = 15;
  int pixels = 1500;
};

struct ClassScore {
  std::string className;
  std::size_t wanted = 0;       ///< True objects seen well,
  std::size_t wantedFound = 0;  ///< and those of them that were found.
  std::size_t found = 0;        ///< Objects of the map,
  std::size_t foundTrue = 0;    ///< and those of them that are true.

  [[nodiscard]] double recall() const;     ///< NaN when nothing was wanted.
  [[nodiscard]] double precision() const;  ///< NaN when nothing was found.
};

struct ObjectEvaluation {
  ClassScore all;
  std::map<core::ClassId, ClassScore> classes;
  ErrorStatistics center_m;  ///< Distance between the centres of the boxes of matched objects.
  ErrorStatistics size_m;    ///< Length of the difference of their sizes; the longer horizontal side first.
  std::vector<std::pair<std::size_t, std::size_t>> matches;  ///< Indices: {true object, found object}.
};

/// Matches true and found objects one to one, as many as can be: of the same class, and the centres of their boxes
/// nearer than 0.25 m, or their boxes' intersection over union above 0.25, or the found centroid inside the true box.
/// All true objects make a found one true; only those seen well can be missed. Boxes in one frame, parallel to its
/// axes.
[[nodiscard]] ObjectEvaluation evaluateObjects(const std::vector<TrueObject>& truth,
                                               const std::vector<FoundObject>& found, const SeenWell& seenWell = {});

/// Found objects in another frame; boxes grow to stay parallel to its axes.
[[nodiscard]] std::vector<FoundObject> transformed(std::vector<FoundObject> objects,
                                                   const Eigen::Isometry3d& T_truth_map);

}  // namespace wardslam::evaluation

#pragma once

#include <mrpt/maps/CSimplePointsMap.h>

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "scan_pairing.h"
#include "scan_samples.h"
#include "wardslam/core/trajectory.h"
#include "wardslam/mapping/map_builder.h"
#include "wardslam/mrpt_plugin/semantic_map_options.h"
#include "wardslam/query/map_query.h"

namespace wardslam::mrpt_plugin {

/// What a CSemanticMap holds: a map as it was told last, and a builder once something was inserted. What is asked for
/// is brought up to date first and stays valid until the next insertion; several threads may ask at once.
class SemanticMapContent {
 public:
  SemanticMapContent() = default;
  explicit SemanticMapContent(mapping::SemanticMap map) : told_(std::move(map)) {}

  /// A copy of all of it.
  [[nodiscard]] std::unique_ptr<SemanticMapContent> clone();

  /// What became of an observation.
  struct Insertion {
    bool isTaken = false;         ///< It is in the map, or will be.
    bool sawUnannotated = false;  ///< A scan went in of which nobody said what moves.
  };

  // Throw core::FrameError for a scan that cannot be used, core::InputError where the options name no sound files.
  Insertion insert(const SemanticInsertionOptions& options, const mrpt::obs::CObservation3DRangeScan& scan,
                   const Eigen::Isometry3d& T_map_base);
  Insertion insert(const SemanticInsertionOptions& options, const CObservationSemanticRGBD& semantic);

  [[nodiscard]] bool isEmpty();
  [[nodiscard]] const mapping::SemanticMap& map();
  [[nodiscard]] const mrpt::maps::CSimplePointsMap& points();
  [[nodiscard]] const std::vector<core::ClassId>& classOfPoints();  ///< In the order of points().
  [[nodiscard]] const query::MapQuery& query();

  /// sampleObservation(); kept until it is asked of another observation.
  [[nodiscard]] std::shared_ptr<const std::vector<ScanSample>> samplesOf(const mrpt::obs::CObservation& observation,
                                                                         const SemanticLikelihoodOptions& options);

 private:
  /// What is made of the map when somebody asks.
  struct Views {
    mrpt::maps::CSimplePointsMap points;
    std::vector<core::ClassId> classOfPoints;
    query::MapQuery query;
  };

  [[nodiscard]] bool workIn(const PlacedFrame& placed);
  void openBuilder(const std::map<core::ClassId, std::string>& newNames);
  void refresh();
  [[nodiscard]] const Views& views();

  std::mutex asking_;
  SemanticInsertionOptions options_;  ///< Of the last insertion.
  ScanPairing pairing_;
  std::optional<core::StampedPose> last_;  ///< Worked in.
  std::optional<mapping::MapBuilder> builder_;
  odometry::Keyframe newest_;  ///< That the builder has.
  bool isTold_ = true;         ///< told_ holds all that the builder knows.
  mapping::SemanticMap told_;
  mapping::MapMemory memory_;  ///< For a builder to come.
  std::unique_ptr<const Views> views_;
  /// A particle filter asks of one observation many times.
  struct Sampled {
    const mrpt::obs::CObservation* observation = nullptr;
    mrpt::Clock::time_point stamp;
    std::shared_ptr<const std::vector<ScanSample>> samples;
  };
  Sampled sampled_;
};

}  // namespace wardslam::mrpt_plugin

#pragma once

#include <mrpt/maps/CMetricMap.h>
#include <mrpt/maps/TMetricMapInitializer.h>
#include <mrpt/math/TBoundingBox.h>
#include <mrpt/system/COutputLogger.h>

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "wardslam/core/mrpt_maps_compat.h"
#include "wardslam/mapping/semantic_map.h"
#include "wardslam/mrpt_plugin/semantic_map_options.h"
#include "wardslam/query/map_query.h"

namespace mrpt::maps {
class CSimplePointsMap;
}

namespace wardslam::mrpt_plugin {

class SemanticMapContent;

/// WardSLAM's semantic map (a coloured cloud with the class and the thing of every point, and the things) as one of
/// MRPT's metric maps: alone, or in a CMultiMetricMap beside MRPT's own, by `CSemanticMap_count = 1` in its .ini file.
///
/// - insertObservation() takes annotated CObservation3DRangeScan (rawlog-annotate) and, before or after each, the
///   CObservationSemanticRGBD of the same time, which says what the image shows: only with it there are classes and
///   things. What moves never enters; what is seen to have gone leaves. Of a scan without annotations all is inserted,
///   which a warning says once. The map needs to see a place `cloud.min_sightings` times before it shows it.
/// - Where scans were taken must be known: this map does not move what it holds.
/// - What moved is judged by what images saw since; that knowledge is copied with the map, but not serialised.
///
/// Not for several threads at once, as MRPT's maps are.
class CSemanticMap : public mrpt::maps::CMetricMap, public mrpt::system::COutputLogger {
  DEFINE_SERIALIZABLE(CSemanticMap, wardslam::mrpt_plugin)

 public:
  CSemanticMap();
  /// A map that is there, of a `.wardmap` or a run, say.
  explicit CSemanticMap(mapping::SemanticMap map);
  ~CSemanticMap() override;
  CSemanticMap(const CSemanticMap& other);  ///< All of it.
  CSemanticMap& operator=(const CSemanticMap& other);

  SemanticInsertionOptions insertionOptions;  ///< What it says when the first scan is inserted counts.
  SemanticLikelihoodOptions likelihoodOptions;
  SemanticRenderOptions renderOptions;

  /// All that the map holds, as plain data: keyframes, cloud, objects, zones, floor plan. Valid until the next change.
  [[nodiscard]] const mapping::SemanticMap& map() const;

  /// The things, those that are gone included, by id. Valid until the next change.
  [[nodiscard]] const std::map<mapping::ObjectId, mapping::MapObject>& objects() const { return map().objects; }

  /// The thing whose centroid is nearest; by default of those that stand there. Valid until the next change.
  [[nodiscard]] std::optional<query::NearObject> nearest(const mrpt::math::TPoint3D& p_map_m,
                                                         const query::ObjectFilter& filter = {}) const;

  /// The cloud as one of MRPT's maps, for its ICP and the like. Valid until the next change.
  [[nodiscard]] const mrpt::maps::CSimplePointsMap& points() const;

  bool isEmpty() const override;  ///< Nothing was inserted.
  std::string asString() const override;
  auto boundingBox() const -> mrpt::math::TBoundingBoxf WARDSLAM_OVERRIDES_BOUNDING_BOX;

  void determineMatching2D(const mrpt::maps::CMetricMap* other, const mrpt::poses::CPose2D& otherPose,
                           mrpt::tfest::TMatchingPairList& pairs, const mrpt::maps::TMatchingParams& parameters,
                           mrpt::maps::TMatchingExtraResults& extra) const override;
  /// `other`: a CSemanticMap or any of MRPT's maps of points. Throws std::runtime_error for others.
  void determineMatching3D(const mrpt::maps::CMetricMap* other, const mrpt::poses::CPose3D& otherPose,
                           mrpt::tfest::TMatchingPairList& pairs, const mrpt::maps::TMatchingParams& parameters,
                           mrpt::maps::TMatchingExtraResults& extra) const override;
  float compute3DMatchingRatio(const mrpt::maps::CMetricMap* other, const mrpt::poses::CPose3D& otherPose,
                               const mrpt::maps::TMatchingRatioParams& parameters) const override;
  float squareDistanceToClosestCorrespondence(float x0, float y0) const override;
  const mrpt::maps::CSimplePointsMap* getAsSimplePointsMap() const override { return &points(); }

  /// `PREFIX.ply` (the cloud), `PREFIX_objects.csv` and `PREFIX.3Dscene`.
  void saveMetricMapRepresentationToFile(const std::string& prefix) const override;
  void getVisualizationInto(mrpt::opengl::CSetOfObjects& view) const override;

  MAP_DEFINITION_START(CSemanticMap)
  SemanticInsertionOptions insertionOpts;
  SemanticLikelihoodOptions likelihoodOpts;
  SemanticRenderOptions renderOpts;
  MAP_DEFINITION_END(CSemanticMap)

 private:
  void internal_clear() override;
  bool internal_insertObservation(const mrpt::obs::CObservation& observation,
                                  const std::optional<const mrpt::poses::CPose3D>& robotPose) override;
  bool internal_canComputeObservationLikelihood(const mrpt::obs::CObservation& observation) const override;
  double internal_computeObservationLikelihood(const mrpt::obs::CObservation& observation,
                                               const mrpt::poses::CPose3D& takenFrom) const override;
  [[nodiscard]] const mrpt::maps::CMetricMap& pointsOf(const mrpt::maps::CMetricMap& other) const;

  std::unique_ptr<SemanticMapContent> content_;
  bool saidUnannotated_ = false;
};

}  // namespace wardslam::mrpt_plugin

#include "wardslam/mrpt_plugin/semantic_metric_map.h"

#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/opengl/CBox.h>
#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CPointCloudColoured.h>
#include <mrpt/opengl/CText.h>

#include <stdexcept>
#include <utility>

#include "semantic_map_content.h"
#include "wardslam/core/atomic_file.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/exchange/map_drawing.h"
#include "wardslam/exchange/map_export.h"

// Here, so that the linker keeps it where it keeps the class.
MAP_DEFINITION_REGISTER("wardslam::mrpt_plugin::CSemanticMap,CSemanticMap,semanticMap",
                        wardslam::mrpt_plugin::CSemanticMap)

namespace wardslam::mrpt_plugin {

IMPLEMENTS_SERIALIZABLE(CSemanticMap, CMetricMap, wardslam::mrpt_plugin)

CSemanticMap::CSemanticMap()
    : mrpt::system::COutputLogger("CSemanticMap"), content_(std::make_unique<SemanticMapContent>()) {}

CSemanticMap::CSemanticMap(mapping::SemanticMap map) : CSemanticMap() {
  content_ = std::make_unique<SemanticMapContent>(std::move(map));
}

CSemanticMap::~CSemanticMap() = default;

CSemanticMap::CSemanticMap(const CSemanticMap& other)
    : mrpt::maps::CMetricMap(other),
      mrpt::system::COutputLogger(other),
      insertionOptions(other.insertionOptions),
      likelihoodOptions(other.likelihoodOptions),
      renderOptions(other.renderOptions),
      content_(other.content_->clone()) {}

CSemanticMap& CSemanticMap::operator=(const CSemanticMap& other) {
  if (this == &other) return *this;
  mrpt::maps::CMetricMap::operator=(other);
  mrpt::system::COutputLogger::operator=(other);
  insertionOptions = other.insertionOptions;
  likelihoodOptions = other.likelihoodOptions;
  renderOptions = other.renderOptions;
  content_ = other.content_->clone();
  return *this;
}

const mapping::SemanticMap& CSemanticMap::map() const { return content_->map(); }

const mrpt::maps::CSimplePointsMap& CSemanticMap::points() const { return content_->points(); }

std::optional<query::NearObject> CSemanticMap::nearest(const mrpt::math::TPoint3D& p_map_m,
                                                       const query::ObjectFilter& filter) const {
  return content_->query().nearest(Eigen::Vector3d(p_map_m.x, p_map_m.y, p_map_m.z), filter);
}

void CSemanticMap::internal_clear() {
  content_ = std::make_unique<SemanticMapContent>();
  saidUnannotated_ = false;
}

bool CSemanticMap::isEmpty() const { return content_->isEmpty(); }

bool CSemanticMap::internal_insertObservation(const mrpt::obs::CObservation& observation,
                                              const std::optional<const mrpt::poses::CPose3D>& robotPose) {
  const Eigen::Isometry3d T_map_base = robotPose ? core::fromMrpt(*robotPose) : Eigen::Isometry3d::Identity();
  SemanticMapContent::Insertion insertion;
  if (const auto* scan = dynamic_cast<const mrpt::obs::CObservation3DRangeScan*>(&observation)) {
    try {
      insertion = content_->insert(insertionOptions, *scan, T_map_base);
    } catch (const core::FrameError& error) {
      MRPT_LOG_THROTTLE_WARN(60.0, std::string("a scan is left out: ") + error.what());
    }
  } else if (const auto* semantic = dynamic_cast<const CObservationSemanticRGBD*>(&observation)) {
    insertion = content_->insert(insertionOptions, *semantic);
  }
  if (insertion.sawUnannotated && !std::exchange(saidUnannotated_, true)) {
    MRPT_LOG_WARN("scans without annotations: all of them is inserted, people too; rawlog-annotate marks what moves");
  }
  return insertion.isTaken;
}

std::string CSemanticMap::asString() const {
  std::size_t things = 0;
  for (const auto& [id, object] : objects()) things += object.state == mapping::ObjectState::Gone ? 0 : 1;
  return "Semantic map: " + std::to_string(points().size()) + " points, " + std::to_string(things) + " things";
}

mrpt::math::TBoundingBoxf CSemanticMap::boundingBox() const { return points().boundingBox(); }

const mrpt::maps::CMetricMap& CSemanticMap::pointsOf(const mrpt::maps::CMetricMap& other) const {
  if (const auto* semantic = dynamic_cast<const CSemanticMap*>(&other)) return semantic->points();
  return other;
}

void CSemanticMap::determineMatching2D(const mrpt::maps::CMetricMap* other, const mrpt::poses::CPose2D& otherPose,
                                       mrpt::tfest::TMatchingPairList& pairs,
                                       const mrpt::maps::TMatchingParams& parameters,
                                       mrpt::maps::TMatchingExtraResults& extra) const {
  points().determineMatching2D(&pointsOf(*other), otherPose, pairs, parameters, extra);
}

void CSemanticMap::determineMatching3D(const mrpt::maps::CMetricMap* other, const mrpt::poses::CPose3D& otherPose,
                                       mrpt::tfest::TMatchingPairList& pairs,
                                       const mrpt::maps::TMatchingParams& parameters,
                                       mrpt::maps::TMatchingExtraResults& extra) const {
  points().determineMatching3D(&pointsOf(*other), otherPose, pairs, parameters, extra);
}

float CSemanticMap::compute3DMatchingRatio(const mrpt::maps::CMetricMap* other, const mrpt::poses::CPose3D& otherPose,
                                           const mrpt::maps::TMatchingRatioParams& parameters) const {
  return points().compute3DMatchingRatio(&pointsOf(*other), otherPose, parameters);
}

float CSemanticMap::squareDistanceToClosestCorrespondence(float x0, float y0) const {
  return points().squareDistanceToClosestCorrespondence(x0, y0);
}

void CSemanticMap::saveMetricMapRepresentationToFile(const std::string& prefix) const {
  exchange::exportPly(map(), prefix + ".ply");
  exchange::exportCsv(map(), prefix + "_objects.csv");
  mrpt::opengl::COpenGLScene scene;
  scene.insert(getVisualization());
  core::replaceAtomically(prefix + ".3Dscene", [&scene](const std::filesystem::path& partial) {
    if (!scene.saveToFile(partial.string())) throw core::InputError(partial.string() + ": cannot be written");
  });
}

void CSemanticMap::getVisualizationInto(mrpt::opengl::CSetOfObjects& view) const {
  if (!genericMapParams.enableSaveAs3DObject) return;
  view.insert(exchange::drawCloud(map(), renderOptions.color, static_cast<float>(renderOptions.point_size_px)));
  for (const auto& [id, object] : objects()) {
    if (object.state == mapping::ObjectState::Gone) continue;
    if (renderOptions.boxes) view.insert(exchange::drawBox(object));
    if (renderOptions.names) view.insert(exchange::drawName(object, map().labels));
  }
}

}  // namespace wardslam::mrpt_plugin

#include "wardslam/mrpt_slam/semantic_map_builder.h"

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPosePDF.h>

#include <mutex>
#include <optional>

#include "estimation_picture.h"
#include "initial_map.h"
#include "motion_of_actions.h"
#include "session.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"

namespace wardslam::mrpt_slam {
namespace {

std::optional<Eigen::Isometry3d> meanOf(const mrpt::poses::CPosePDF* x0) {
  if (x0 == nullptr) return std::nullopt;
  return core::fromMrpt(mrpt::poses::CPose3D(x0->getMeanVal()));
}

}  // namespace

CMetricMapBuilderSemantic::CMetricMapBuilderSemantic() = default;
CMetricMapBuilderSemantic::~CMetricMapBuilderSemantic() = default;

/// The base class has its critical section for functions that change the map, and does not let the others lock it; ours
/// remember what they found out.
template <class Do>
decltype(auto) CMetricMapBuilderSemantic::locked(const Do& work) const {
  const std::lock_guard lock(const_cast<std::mutex&>(critZoneChangingMap));
  return work();
}

void CMetricMapBuilderSemantic::loadFromConfigFile(const mrpt::config::CConfigFileBase& ini, const std::string& section,
                                                   const std::vector<std::string>& ofTheProgram) {
  auto read = readMapBuilderConfiguration(ini, section, ofTheProgram);
  locked([&] { configuration = std::move(read); });
}

void CMetricMapBuilderSemantic::initialize(const mrpt::maps::CSimpleMap& initialMap, const mrpt::poses::CPosePDF* x0) {
  locked([&] { begin(initialMap, x0); });
}

void CMetricMapBuilderSemantic::initialize(const std::filesystem::path& wardmap) {
  locked([&] {
    configuration.builder.map = wardmap.string();
    begin({}, nullptr);
  });
}

void CMetricMapBuilderSemantic::begin(const mrpt::maps::CSimpleMap& simple, const mrpt::poses::CPosePDF* x0) {
  updatesTheMap_ = options.enableMapUpdating;
  saidThatItIsLate_ = false;
  session_.reset();  // two runs may not fit into memory
  const auto earlier = initialMap(simple, configuration, updatesTheMap_,
                                  [this](const std::string& sentence) { MRPT_LOG_WARN(sentence); });
  session_ = std::make_unique<Session>(configuration, earlier, updatesTheMap_, meanOf(x0));
}

Session& CMetricMapBuilderSemantic::begun() {
  if (!session_) begin({}, nullptr);
  warnOfLateChange();
  return *session_;
}

void CMetricMapBuilderSemantic::warnOfLateChange() {
  if (options.enableMapUpdating == updatesTheMap_ || saidThatItIsLate_) return;
  saidThatItIsLate_ = true;
  MRPT_LOG_WARN("enableMapUpdating() counts from the next initialize() on, not from now.");
}

mrpt::poses::CPose3DPDF::Ptr CMetricMapBuilderSemantic::getCurrentPoseEstimation() const {
  return locked([&] {
    return session_ ? std::make_shared<mrpt::poses::CPose3DPDFGaussian>(session_->pose())
                    : mrpt::poses::CPose3DPDFGaussian::Create();
  });
}

void CMetricMapBuilderSemantic::processActionObservation(mrpt::obs::CActionCollection& action,
                                                         mrpt::obs::CSensoryFrame& observations) {
  locked([&] {
    Session& session = begun();
    session.addMotion(motionOf(action));
    session.add(observations);
  });
}

void CMetricMapBuilderSemantic::processObservation(const mrpt::obs::CObservation::Ptr& observation) {
  if (!observation) return;
  mrpt::obs::CSensoryFrame alone;
  alone.insert(observation);
  locked([&] {
    Session& session = begun();
    if (const auto reading = std::dynamic_pointer_cast<mrpt::obs::CObservationOdometry>(observation))
      session.add(*reading);
    session.add(alone);
  });
}

void CMetricMapBuilderSemantic::getCurrentlyBuiltMap(mrpt::maps::CSimpleMap& out_map) const {
  out_map = locked([&] { return session_ ? session_->simpleMap() : mrpt::maps::CSimpleMap(); });
}

unsigned int CMetricMapBuilderSemantic::getCurrentlyBuiltMapSize() {
  return locked([&] { return session_ ? static_cast<unsigned int>(session_->keyframes()) : 0U; });
}

core::BuiltMetricMap CMetricMapBuilderSemantic::getCurrentlyBuiltMetricMap() const {
  return locked([&]() -> core::BuiltMetricMap {
    if (!session_) throw core::InputError("there is no map yet; call initialize() first");
    return core::asBuiltMetricMap(session_->metricMaps());
  });
}

void CMetricMapBuilderSemantic::saveCurrentEstimationToImage(const std::string& file, bool /*formatEMF_BMP*/) {
  const cv::Mat picture = locked([&] {
    if (!session_) throw core::InputError(file + ": there is nothing to draw yet; call initialize() first");
    const pipeline::MapSoFar& known = session_->soFar();
    return drawEstimation(known.semantic.floorPlan, known.trajectory, session_->T_map_base());
  });
  writePicture(picture, file);
}

void CMetricMapBuilderSemantic::finish() {
  locked([&] {
    if (session_) session_->finish();
  });
}

core::Trajectory CMetricMapBuilderSemantic::trajectory() const {
  return locked([&] { return session_ ? session_->soFar().trajectory : core::Trajectory(); });
}

mapping::SemanticMap CMetricMapBuilderSemantic::semanticMap() const {
  return locked([&] { return session_ ? session_->soFar().semantic : mapping::SemanticMap(); });
}

}  // namespace wardslam::mrpt_slam

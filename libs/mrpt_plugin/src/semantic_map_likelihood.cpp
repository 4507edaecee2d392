#include <mrpt/maps/CSimplePointsMap.h>

#include <algorithm>
#include <cmath>

#include "scan_samples.h"
#include "semantic_map_content.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/mrpt_plugin/semantic_metric_map.h"

namespace wardslam::mrpt_plugin {

bool CSemanticMap::internal_canComputeObservationLikelihood(const mrpt::obs::CObservation& observation) const {
  return canBeSampled(observation);
}

double CSemanticMap::internal_computeObservationLikelihood(const mrpt::obs::CObservation& observation,
                                                           const mrpt::poses::CPose3D& takenFrom) const {
  const auto& cloud = points();
  if (cloud.empty()) return 0.0;
  const auto samples = content_->samplesOf(observation, likelihoodOptions);
  if (samples->empty()) return 0.0;
  const auto& classes = content_->classOfPoints();
  const Eigen::Isometry3d T_map_base = core::fromMrpt(takenFrom);
  const double twoVariances_m2 = 2.0 * likelihoodOptions.sigma_m * likelihoodOptions.sigma_m;
  double sum = 0.0;
  for (const ScanSample& sample : *samples) {
    const Eigen::Vector3f p_m = (T_map_base * sample.p_base_m).cast<float>();
    float squared_m2 = 0.0F;
    const std::size_t nearest = cloud.kdTreeClosestPoint3D(p_m.x(), p_m.y(), p_m.z(), squared_m2);
    const bool differ = sample.classId != 0 && classes[nearest] != 0 && sample.classId != classes[nearest];
    const double same = differ ? likelihoodOptions.class_mismatch : 1.0;
    const double hit = same * std::exp(-static_cast<double>(squared_m2) / twoVariances_m2);
    sum += std::log((1.0 - likelihoodOptions.other) * hit + likelihoodOptions.other);
  }
  const auto count = static_cast<double>(samples->size());
  return sum * std::min(1.0, likelihoodOptions.independent / count);
}

}  // namespace wardslam::mrpt_plugin

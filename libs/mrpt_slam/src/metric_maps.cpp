#include "metric_maps.h"

#include <mrpt/maps/CColouredPointsMap.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>

#include <memory>

#include "wardslam/exchange/metric_maps.h"
#include "wardslam/exchange/simple_map.h"
#include "wardslam/mrpt_plugin/semantic_metric_map.h"

namespace wardslam::mrpt_slam {
namespace {

using mrpt::maps::CSimpleMap;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::poses::CPose3D;
using mrpt_plugin::CSemanticMap;

std::shared_ptr<CSemanticMap> semanticMapLike(const CSemanticMap& asked, const mapping::SemanticMap& map) {
  auto semantic = std::make_shared<CSemanticMap>(map);
  semantic->insertionOptions = asked.insertionOptions;
  semantic->likelihoodOptions = asked.likelihoodOptions;
  semantic->renderOptions = asked.renderOptions;
  return semantic;
}

/// The laser scans, seen from a robot that stands level where each was taken: COccupancyGridMap2D takes no scan that is
/// tilted against its robot, and the robot of toSimpleMap() is the camera.
CSimpleMap levelScans(const CSimpleMap& simple) {
  CSimpleMap level;
  for (const auto& entry : simple) {
    const CPose3D from = entry.pose->getMeanVal();
    const CPose3D levelled(from.x(), from.y(), 0.0, from.yaw(), 0.0, 0.0);
    auto frame = mrpt::obs::CSensoryFrame::Create();
    for (const auto& observation : *entry.sf) {
      const auto scan = std::dynamic_pointer_cast<CObservation2DRangeScan>(observation);
      if (!scan) continue;
      auto turned = CObservation2DRangeScan::Create(*scan);
      CPose3D sensor = (from + scan->sensorPose) - levelled;
      turned->sensorPose = CPose3D(sensor.x(), sensor.y(), sensor.z(), sensor.yaw(), 0.0, 0.0);  // but for rounding
      frame->insert(turned);
    }
    level.insert(mrpt::poses::CPose3DPDF::Ptr(mrpt::poses::CPose3DPDFGaussian::Create(levelled)), frame);
  }
  return level;
}

}  // namespace

mrpt::maps::CMultiMetricMap makeMetricMaps(const mrpt::maps::TSetOfMetricMapInitializers& definitions,
                                           const mapping::SemanticMap& map) {
  mrpt::maps::CMultiMetricMap asked;
  if (definitions.size() > 0) asked.setListOfMaps(definitions);
  mrpt::maps::CMultiMetricMap made;
  if (asked.maps.empty()) made.maps.push_back(std::make_shared<CSemanticMap>(map));
  CSimpleMap scans;  // made when first needed
  for (const auto& one : asked.maps) {
    if (const auto semantic = std::dynamic_pointer_cast<CSemanticMap>(one)) {
      made.maps.push_back(semanticMapLike(*semantic, map));
    } else if (std::dynamic_pointer_cast<mrpt::maps::CColouredPointsMap>(one)) {
      made.maps.push_back(exchange::toColouredPoints(map));
    } else {
      if (scans.empty()) scans = exchange::toSimpleMap(map);
      const bool isGrid = std::dynamic_pointer_cast<mrpt::maps::COccupancyGridMap2D>(one) != nullptr;
      one->loadFromSimpleMap(isGrid ? levelScans(scans) : scans);
      made.maps.push_back(one);
    }
  }
  return made;
}

}  // namespace wardslam::mrpt_slam

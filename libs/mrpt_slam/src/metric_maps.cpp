#include "metric_maps.h"

#include <mrpt/maps/CColouredPointsMap.h>
#include <mrpt/maps/CSimpleMap.h>

#include <memory>

#include "wardslam/exchange/metric_maps.h"
#include "wardslam/exchange/simple_map.h"
#include "wardslam/mrpt_plugin/semantic_metric_map.h"

namespace wardslam::mrpt_slam {
namespace {

using mrpt::maps::CSimpleMap;
using mrpt_plugin::CSemanticMap;

std::shared_ptr<CSemanticMap> semanticMapLike(const CSemanticMap& asked, const mapping::SemanticMap& map) {
  auto semantic = std::make_shared<CSemanticMap>(map);
  semantic->insertionOptions = asked.insertionOptions;
  semantic->likelihoodOptions = asked.likelihoodOptions;
  semantic->renderOptions = asked.renderOptions;
  return semantic;
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
      one->loadFromSimpleMap(scans);
      made.maps.push_back(one);
    }
  }
  return made;
}

}  // namespace wardslam::mrpt_slam

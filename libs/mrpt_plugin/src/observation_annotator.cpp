#include "wardslam/mrpt_plugin/observation_annotator.h"

#include <mrpt/containers/yaml.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <sstream>
#include <stdexcept>

#include "wardslam/pipeline/ini_options.h"

namespace wardslam::mrpt_plugin {

IMPLEMENTS_MRPT_OBJECT(ObservationAnnotator, mrpt::rtti::CObject, wardslam::mrpt_plugin)

void ObservationAnnotator::initialize(const mrpt::containers::yaml& parameters) {
  std::ostringstream text;
  parameters.printAsYAML(text);
  const auto options = pipeline::readSlamOptions(core::ConfigNode::fromText(text.str(), "ObservationAnnotator"));
  annotator_ = std::make_shared<ScanAnnotator>(options, "");
}

void ObservationAnnotator::loadConfig(const mrpt::config::CConfigFileBase& source, const std::string& section) {
  annotator_ = std::make_shared<ScanAnnotator>(pipeline::readSlamOptions(source, section), "");
}

bool ObservationAnnotator::doFilter(const mrpt::obs::CObservation::Ptr& observation) {
  if (!annotator_) throw std::logic_error("ObservationAnnotator: call initialize() or loadConfig() first");
  const auto scan = std::dynamic_pointer_cast<mrpt::obs::CObservation3DRangeScan>(observation);
  auto found = scan ? annotator_->annotate(scan) : nullptr;
  if (!found) return false;
  found_ = std::move(found);
  return true;
}

}  // namespace wardslam::mrpt_plugin

#pragma once

#include <mrpt/obs/CObservation.h>
#include <mrpt/rtti/CObject.h>

#include <memory>
#include <string>

#include "wardslam/mrpt_plugin/observation_semantic_rgbd.h"
#include "wardslam/mrpt_plugin/scan_annotator.h"

namespace mrpt::config {
class CConfigFileBase;
}
namespace mrpt::containers {
class yaml;
}

namespace wardslam::mrpt_plugin {

/// WardSLAM's filters as one link of a chain of MRPT's observations (in the manner of mola::FilterBase), made by name
/// wherever libwardslam-mrpt.so is loaded:
///
///     auto object = mrpt::rtti::classFactory("wardslam::mrpt_plugin::ObservationAnnotator");
///     auto filter = std::dynamic_pointer_cast<wardslam::mrpt_plugin::ObservationAnnotator>(object);
///     filter->initialize(mrpt::containers::yaml::FromFile("wardslam.yaml"));
///     filter->doFilter(observation);  // pixelLabels and confidenceImage are set now
class ObservationAnnotator : public mrpt::rtti::CObject {
  DEFINE_MRPT_OBJECT(ObservationAnnotator, wardslam::mrpt_plugin)

 public:
  /// The keys of WardSLAM's configuration (docs/configuration.md): `segmentation`, `filters`, … Throws
  /// core::InputError.
  void initialize(const mrpt::containers::yaml& parameters);

  /// From an .ini file; see pipeline::readSlamOptions(). Throws core::InputError.
  void loadConfig(const mrpt::config::CConfigFileBase& source, const std::string& section);

  /// Annotates a CObservation3DRangeScan in place, and all of one sensor must pass here in order of time; lets others
  /// pass. A scan that cannot be used stays as it is. Whether it was annotated. Throws std::logic_error before
  /// initialize(), core::InputError for what no later scan mends.
  bool doFilter(const mrpt::obs::CObservation::Ptr& observation);

  /// What was found in the last annotated scan; null before.
  [[nodiscard]] const CObservationSemanticRGBD::Ptr& found() const { return found_; }

  /// Trouble, by kind. After initialize().
  [[nodiscard]] const core::EventCounts& events() const { return annotator_->events(); }

 private:
  std::shared_ptr<ScanAnnotator> annotator_;  ///< Shared, as MRPT's objects must be copyable.
  CObservationSemanticRGBD::Ptr found_;
};

}  // namespace wardslam::mrpt_plugin

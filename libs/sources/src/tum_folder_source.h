#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "wardslam/sources/observation_source.h"
#include "wardslam/sources/rgbd_camera.h"
#include "wardslam/sources/tum_lists.h"

namespace wardslam::sources {

class DamageLog;

/// The colour and depth images of a sequence in the layout of the TUM RGB-D benchmark, decoded one pair at a time.
/// Observations carry the stamp of the colour image and the sensor label "RGBD".
///
/// The camera is SourceOptions::camera, else the folder's camera.yaml, else TUM's own calibration where the folder's
/// name or the comments of rgb.txt tell which of its cameras (freiburg1, fr2, …) recorded it.
class TumFolderSource : public ObservationSource {
 public:
  /// Throws core::InputError where the lists are unsound or the camera is unknown.
  TumFolderSource(const std::filesystem::path& folder, const SourceOptions& options);
  ~TumFolderSource() override;

  [[nodiscard]] std::shared_ptr<mrpt::obs::CObservation3DRangeScan> next() override;
  [[nodiscard]] std::optional<std::size_t> size() const override { return pairs_.size(); }
  [[nodiscard]] const core::EventCounts& damage() const override;
  [[nodiscard]] core::DepthNoise depthNoise() const override { return camera_.color.depthNoise; }

 private:
  [[nodiscard]] std::shared_ptr<mrpt::obs::CObservation3DRangeScan> read(const ImagePair& pair) const;

  std::filesystem::path folder_;
  std::vector<ImagePair> pairs_;
  RgbdCamera camera_;
  std::size_t nextPair_ = 0;
  std::unique_ptr<DamageLog> damage_;
};

}  // namespace wardslam::sources

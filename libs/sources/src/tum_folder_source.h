#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "depth_scale_check.h"
#include "folder_camera.h"
#include "wardslam/sources/observation_source.h"
#include "wardslam/sources/tum_lists.h"

namespace wardslam::sources {

class DamageLog;
class InputDamage;

/// The colour and depth images of a sequence in the layout of the TUM RGB-D benchmark, decoded one pair at a time.
/// Observations carry the stamp of the colour image and the sensor label "RGBD". The camera is that of
/// chooseFolderCamera(). Depth of 65535 is no measurement; floating-point depth is in metres.
class TumFolderSource : public ObservationSource {
 public:
  /// So many pairs from the start that fail for one reason, and so do all: then next() throws core::InputError.
  static constexpr std::size_t kPatience = 10;

  /// Throws core::InputError where the lists are unsound, the camera or the unit of its depth images is unknown.
  TumFolderSource(const std::filesystem::path& folder, const SourceOptions& options);
  ~TumFolderSource() override;

  [[nodiscard]] std::shared_ptr<mrpt::obs::CObservation3DRangeScan> next() override;
  [[nodiscard]] std::optional<std::size_t> size() const override { return pairs_.size(); }
  [[nodiscard]] const core::EventCounts& damage() const override;
  [[nodiscard]] core::SensorTraits sensorTraits() const override { return camera_.camera.color.traits(); }
  [[nodiscard]] double rate_hz() const override { return camera_.camera.rate_hz; }

 private:
  [[nodiscard]] std::shared_ptr<mrpt::obs::CObservation3DRangeScan> read(const ImagePair& pair) const;
  void requireDepthUnit() const;
  void takeSizeFromImages();
  void stopIfAllFail(const InputDamage& damage, const std::string& where);

  std::filesystem::path folder_;
  NoteSink note_;
  FolderCamera camera_;
  bool isFactorGiven_;  ///< By who asks, not by the camera file.
  std::vector<ImagePair> pairs_;
  std::size_t nextPair_ = 0;
  std::string failingAlike_;  ///< Event of the first pair, while no pair could be used and all fail for that reason.
  bool mayStop_ = true;
  DepthScaleCheck scaleCheck_;
  std::unique_ptr<DamageLog> damage_;
};

}  // namespace wardslam::sources

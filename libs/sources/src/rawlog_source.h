#pragma once

#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "depth_scale_check.h"
#include "stereo_depth.h"
#include "wardslam/sources/observation_source.h"
#include "wardslam/sources/rgbd_camera.h"

namespace mrpt::obs {
class CObservation;
}

namespace wardslam::sources {

class DamageLog;
class RawlogReader;

/// The CObservation3DRangeScan of an MRPT rawlog (gz-compressed or not; a list of observations or of sensory frames),
/// read as a stream. A CObservationStereoImages becomes a scan (StereoDepth). Observations of other classes are passed
/// over, and so are those of other sensors than SourceOptions::sensor, or where that is empty the first that has both
/// images; sensors() counts them. A scan from before the one
/// delivered last is left out and counted as "sources.stamp_goes_back".
///
/// A rawlog that ends in the middle of an object delivers everything before and then counts
/// "sources.rawlog_truncated"; reading also ends at an object of a class that RawlogReader does not know.
class RawlogSource : public ObservationSource {
 public:
  /// So many observations from the start that fail for one reason, and so do all.
  static constexpr std::size_t kPatience = 10;

  /// Reads up to the first usable scan. Throws core::InputError where there is none or the file is no rawlog.
  RawlogSource(const std::filesystem::path& file, const SourceOptions& options);
  ~RawlogSource() override;

  [[nodiscard]] std::shared_ptr<mrpt::obs::CObservation3DRangeScan> next() override;
  [[nodiscard]] std::optional<std::size_t> size() const override { return std::nullopt; }
  [[nodiscard]] const core::EventCounts& damage() const override;
  [[nodiscard]] SensorCounts sensors() const override { return sensors_; }
  [[nodiscard]] core::SensorTraits sensorTraits() const override { return traits_; }

 private:
  using ScanPtr = std::shared_ptr<mrpt::obs::CObservation3DRangeScan>;
  using ObservationPtr = std::shared_ptr<mrpt::obs::CObservation>;

  [[nodiscard]] ScanPtr readScan();
  [[nodiscard]] bool fillPending();
  [[nodiscard]] ScanPtr takeIfUsable(const ObservationPtr& observation);
  void tellOfUnit(const mrpt::obs::CObservation3DRangeScan& scan) const;
  [[nodiscard]] ScanPtr prepare(const std::shared_ptr<mrpt::obs::CObservation3DRangeScan>& scan) const;
  [[nodiscard]] ScanPtr prepare(const mrpt::obs::CObservationStereoImages& pair);
  void requireOrderOfTime(const mrpt::obs::CObservation3DRangeScan& scan);
  void stopIfAllFail(const std::string& event, const std::string& what);
  [[noreturn]] void failWithoutScans() const;

  std::filesystem::path file_;
  NoteSink note_;
  std::optional<double> depth_units_per_m_;  ///< Replaces that of the scans.
  std::optional<RgbdCamera> camera_;         ///< Replaces that of the scans.
  std::unique_ptr<RawlogReader> reader_;
  std::unique_ptr<DamageLog> damage_;

  StereoDepth stereo_;
  core::SensorTraits traits_;  ///< Of the first observation's sensor.

  std::deque<ObservationPtr> pending_;  ///< From the sensory frame read last.
  ScanPtr first_;                       ///< Read when opening, delivered by the first next().
  std::optional<std::string> label_;
  SensorCounts sensors_;
  DepthScaleCheck scaleCheck_;
  std::optional<double> lastStamp_s_;
  std::set<std::string> passedOver_;  ///< Classes met that are no scans with both images.
  std::string firstDamage_;           ///< What the first observation that could not be used suffers from.
  std::string failingAlike_;          ///< Its event, while no observation could be used and all fail for that reason.
  bool mayStop_ = true;
  std::string newer_;  ///< What a newer MRPT wrote; empty: nothing was met.
  std::size_t scansRead_ = 0;
};

}  // namespace wardslam::sources

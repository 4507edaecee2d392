#pragma once

#include <filesystem>
#include <optional>

namespace mrpt::obs {
class CObservation3DRangeScan;
class CObservationStereoImages;
}  // namespace mrpt::obs

namespace wardslam::sources {

/// The folder beside a rawlog where MRPT's programs keep its external images: "<name>_Images" or "Images".
[[nodiscard]] std::optional<std::filesystem::path> findImageFolder(const std::filesystem::path& rawlog);

/// Brings externally stored images into memory. Throws InputDamage where one is missing or cut off.
void loadImages(const mrpt::obs::CObservation3DRangeScan& scan);
void loadImages(const mrpt::obs::CObservationStereoImages& pair);

}  // namespace wardslam::sources

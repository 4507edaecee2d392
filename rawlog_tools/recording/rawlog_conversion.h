#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace mrpt::obs {
class CObservation;
}

namespace wardslam::recording {

class RawlogWriter;

/// A recording that becomes a rawlog, whatever it was: what tum2rawlog and bag2rawlog do alike.
struct RawlogConversion {
  std::string program;
  std::filesystem::path input;
  std::filesystem::path output;
  std::optional<std::size_t> size;                                 ///< Of observations to come, where that is known.
  std::function<std::shared_ptr<mrpt::obs::CObservation>()> next;  ///< Null at the end.
  std::function<bool()> isDamaged;                                 ///< Whether next() had to leave something out.
  std::function<void(RawlogWriter&)> begin = [](RawlogWriter&) {};
  bool mayHoldOthers = false;  ///< Besides RGB-D scans, whose number is told then.
};

/// Writes it, with progress and Ctrl-C, and tells on standard output what it holds. The exit code: apps::kFailure where
/// parts were left out. Throws core::InputError, also when interrupted or without a single RGB-D scan; then there is no
/// rawlog.
[[nodiscard]] int convertToRawlog(const RawlogConversion& conversion);

}  // namespace wardslam::recording

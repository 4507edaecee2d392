#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "wardslam/core/trajectory.h"

/// What the gates share: renderings with their truth, and runs over them.
namespace wardslam::gates {

/// A recording made by rawlog-synth, 320×240, with all that is known about it.
struct Rendering {
  std::filesystem::path rawlog;

  [[nodiscard]] std::filesystem::path labels() const;
  [[nodiscard]] std::filesystem::path masks() const { return labels() / "masks"; }
  [[nodiscard]] std::filesystem::path truthFile() const;
  [[nodiscard]] core::Trajectory truth() const;
};

/// Throws std::runtime_error with what the program said when it fails.
Rendering render(const std::filesystem::path& rawlog, const std::vector<std::string>& arguments);

/// The folder a run has filled.
struct Run {
  std::filesystem::path out;

  [[nodiscard]] std::filesystem::path map() const { return out / "map.wardmap"; }
  [[nodiscard]] core::Trajectory trajectory() const;
  [[nodiscard]] core::Trajectory liveTrajectory() const;  ///< As told while it ran.
  [[nodiscard]] nlohmann::json summary() const;
};

/// `wardslam run` over the rendering. Throws std::runtime_error with what the program said when it fails.
Run run(const Rendering& rendering, const std::filesystem::path& out, const std::vector<std::string>& arguments);

/// Root mean square of the absolute trajectory error; NaN where less than the whole rendering has poses, for a part
/// of it can look good.
[[nodiscard]] double ate_m(const Rendering& rendering, const Run& run);

/// Programs started while this lives share one core: what a busy machine does to threads, on any machine.
class OneCore {
 public:
  OneCore();
  ~OneCore();
  OneCore(const OneCore&) = delete;
  OneCore& operator=(const OneCore&) = delete;

 private:
  std::vector<unsigned char> before_;
};

}  // namespace wardslam::gates

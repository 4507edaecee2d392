#pragma once

#include <filesystem>

namespace mrpt::config {
class CConfigFileBase;
}

namespace wardslam::mrpt_sensor {

/// A configuration as a file, for a process that is to read it; the file goes with this object.
class TemporaryIni {
 public:
  /// Throws core::InputError when it cannot be written.
  explicit TemporaryIni(const mrpt::config::CConfigFileBase& ini);
  ~TemporaryIni();
  TemporaryIni(const TemporaryIni&) = delete;
  TemporaryIni& operator=(const TemporaryIni&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace wardslam::mrpt_sensor

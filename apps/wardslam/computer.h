#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "finding.h"

namespace wardslam::apps {

/// Version of the program, operating system, processor and memory.
[[nodiscard]] Findings describeComputer();

/// The shared libraries that this process runs with, by the files they come from ("libmrpt-core.so.2.5.8").
[[nodiscard]] std::vector<std::string> loadedLibraries();

/// Which of them matter, and which networks they can run.
[[nodiscard]] Findings describeLibraries(const std::vector<std::string>& loaded);

/// Cameras that MRPT has drivers for, among what is plugged in. `usbDevices`: as Linux lists them.
[[nodiscard]] Finding lookForSensors(const std::filesystem::path& usbDevices = "/sys/bus/usb/devices");

/// Whether results can be written there, how fast, and how much. Of a folder that is absent, where it would be made.
[[nodiscard]] Finding tryDisk(const std::filesystem::path& folder);

}  // namespace wardslam::apps

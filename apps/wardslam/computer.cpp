#include "computer.h"

#include <fcntl.h>
#include <link.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <iomanip>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <thread>

#include "wardslam/core/data_files.h"

namespace wardslam::apps {
namespace {

namespace fs = std::filesystem;

constexpr double kGigabyte = 1e9;
constexpr double kTooLittle_gb = 0.2;  // a run ends in trouble
constexpr double kNotMuch_gb = 2.0;    // of a day
constexpr std::size_t kTried_mb = 32;
constexpr double kSlow_mb_per_s = 10.0;  // a keyframe's write then holds up the map

std::string decimal(double value) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << value;
  return text.str();
}

/// What stands behind `key` in a file of lines "key<separator>value".
std::string valueIn(const fs::path& file, const std::string& key, char separator) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    const auto end = line.find(separator);
    if (line.compare(0, key.size(), key) != 0 || end == std::string::npos) continue;
    const auto begin = line.find_first_not_of(" \t\"", end + 1);
    if (begin == std::string::npos) return {};
    return line.substr(begin, line.find_last_not_of(" \t\"") + 1 - begin);
  }
  return "unknown";
}

std::string lineIn(const fs::path& file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  return line;
}

int addLibrary(dl_phdr_info* info, std::size_t /*size*/, void* list) {
  const fs::path file = info->dlpi_name;
  std::error_code error;
  const fs::path real = fs::canonical(file, error);
  if (!error) static_cast<std::vector<std::string>*>(list)->push_back(real.filename().string());
  return 0;
}

fs::path nearestFolder(fs::path folder) {
  folder = fs::absolute(folder).lexically_normal();
  std::error_code error;
  while (!fs::is_directory(folder, error) && folder.has_parent_path() && folder != folder.parent_path()) {
    folder = folder.parent_path();
  }
  return folder;
}

/// Megabytes a second until the disk has them; nothing where it takes none.
std::optional<double> writingSpeed(const fs::path& folder) {
  const fs::path file = folder / ("wardslam-doctor-" + std::to_string(getpid()) + ".partial");
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (descriptor < 0) return std::nullopt;
  const std::vector<char> megabyte(1'000'000, 'w');
  const auto start = std::chrono::steady_clock::now();
  bool isTaken = true;
  for (std::size_t i = 0; i < kTried_mb && isTaken; ++i) {
    isTaken = ::write(descriptor, megabyte.data(), megabyte.size()) == static_cast<ssize_t>(megabyte.size());
  }
  isTaken = isTaken && ::fsync(descriptor) == 0;
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  ::close(descriptor);
  ::unlink(file.c_str());
  if (!isTaken) return std::nullopt;
  return static_cast<double>(kTried_mb) / std::max(1e-6, elapsed.count());
}

}  // namespace

Findings describeComputer() {
  utsname system{};
  uname(&system);
  const double memory_gb =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE)) / kGigabyte;
  return {{Finding::Kind::Good, "version", "WardSLAM " WARDSLAM_VERSION},
          {Finding::Kind::Good, "system",
           valueIn("/etc/os-release", "PRETTY_NAME", '=') + ", " + system.sysname + " " + system.release + " on " +
               system.machine},
          {Finding::Kind::Good, "computer",
           std::to_string(std::thread::hardware_concurrency()) + " x " + valueIn("/proc/cpuinfo", "model name", ':') +
               ", " + decimal(memory_gb) + " GB of memory"}};
}

std::vector<std::string> loadedLibraries() {
  std::vector<std::string> names;
  dl_iterate_phdr(addLibrary, &names);
  std::sort(names.begin(), names.end());
  return names;
}

Findings describeLibraries(const std::vector<std::string>& loaded) {
  constexpr std::array kOnes = {"libmrpt-core.", "libmrpt-obs.", "libopencv_core.", "libopencv_dnn.", "libpcl_common.",
                                "libceres.",     "libsqlite3.",  "libzstd.",        "libyaml-cpp.",   "liboctomap."};
  std::string libraries;
  bool hasOnnxRuntime = false;
  for (const std::string& name : loaded) {
    const auto begins = [&name](const char* one) { return name.rfind(one, 0) == 0; };
    hasOnnxRuntime = hasOnnxRuntime || begins("libonnxruntime.");
    if (std::any_of(kOnes.begin(), kOnes.end(), begins)) libraries += (libraries.empty() ? "" : ", ") + name;
  }
  return {{Finding::Kind::Good, "libraries", libraries.empty() ? "linked statically" : libraries},
          {Finding::Kind::Good, "networks run on",
           hasOnnxRuntime ? "OpenCV, ONNX Runtime" : "OpenCV (built without ONNX Runtime)"}};
}

Finding lookForSensors(const fs::path& usbDevices) {
  const std::map<std::string, std::string> kMakers = {
      {"1d27", "PrimeSense"}, {"045e", "Microsoft"}, {"2bc5", "Orbbec"}, {"0b05", "Asus"}, {"8086", "Intel"}};
  const std::set<std::string> kKinds = {"045e:02ae", "0b05:0600", "0b05:0601"};
  std::string seen;
  std::error_code absent;
  for (const auto& device : fs::directory_iterator(usbDevices, absent)) {
    const std::string maker = lineIn(device.path() / "idVendor");
    const std::string product = lineIn(device.path() / "product");
    const auto known = kMakers.find(maker);
    if (known == kMakers.end()) continue;
    const bool isCamera = maker == "1d27" || maker == "2bc5" || product.find("RealSense") != std::string::npos ||
                          kKinds.count(maker + ":" + lineIn(device.path() / "idProduct")) > 0;
    if (isCamera) seen += (seen.empty() ? "" : ", ") + known->second + " " + product;
  }
  if (seen.empty()) return {Finding::Kind::Note, "sensors", "no depth camera is plugged in (USB)"};
  if (core::findProgram("wardslam-sensor").has_parent_path()) return {Finding::Kind::Good, "sensors", seen};
  return {Finding::Kind::Trouble, "sensors", seen + "; the program wardslam-sensor, which reads them, is missing"};
}

Finding tryDisk(const fs::path& folder) {
  using Kind = Finding::Kind;
  const fs::path there = nearestFolder(folder);
  const auto tell = [&there](Kind kind, const std::string& text) {
    return Finding{kind, "disk", there.string() + ": " + text};
  };
  std::error_code error;
  const double free_gb = static_cast<double>(fs::space(there, error).available) / kGigabyte;
  if (error) return tell(Kind::Trouble, "how much is free cannot be told: " + error.message());
  const std::string room = decimal(free_gb) + " GB free";
  if (free_gb < kTooLittle_gb) return tell(Kind::Trouble, room);
  const auto speed = writingSpeed(there);
  if (!speed) return tell(Kind::Trouble, "nothing can be written; may you write there?");
  const bool isPoor = free_gb < kNotMuch_gb || *speed < kSlow_mb_per_s;
  return tell(isPoor ? Kind::Note : Kind::Good, room + ", writes " + decimal(*speed) + " MB/s");
}

}  // namespace wardslam::apps

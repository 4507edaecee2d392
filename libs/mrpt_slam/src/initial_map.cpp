#include "initial_map.h"

#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "wardslam/core/errors.h"
#include "wardslam/mrpt_slam/simple_map_file.h"

namespace wardslam::mrpt_slam {
namespace {

/// Gone with all in it when it goes out of scope.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "wardslam_map_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw core::InputError(name + ": cannot be made; is there room in the folder for temporary files?");
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace

pipeline::EarlierMap initialMap(const mrpt::maps::CSimpleMap& simple, const MapBuilderConfiguration& configuration,
                                bool updatesTheMap, const std::function<void(const std::string&)>& warn) {
  const auto use = updatesTheMap ? graph::Saved::MayChange : graph::Saved::IsHeld;
  if (simple.empty()) {
    const auto& file = configuration.builder.map;
    return file.empty() ? pipeline::EarlierMap() : pipeline::readEarlierMap(file, use);
  }
  const ScratchFolder scratch;
  const auto file = scratch.path() / "simple.wardmap";
  const auto placed = makeMapFile(simple, configuration.slam, configuration.builder.sensor_label, file);
  if (placed < simple.size()) {
    warn("Of the " + std::to_string(simple.size()) + " keyframes of the simple map " + std::to_string(placed) +
         " found their place; the others share too little with the rest and are left out.");
  }
  return pipeline::readEarlierMap(file, use);
}

}  // namespace wardslam::mrpt_slam

#include "bag_source.h"
#include "foreign_input.h"
#include "prefetching_source.h"
#include "rawlog_source.h"
#include "tum_folder_source.h"
#include "wardslam/bags/bag_reader.h"
#include "wardslam/core/errors.h"
#include "wardslam/sources/observation_source.h"

namespace wardslam::sources {
namespace {

/// Images taken from a recording of ROS may lie beside it.
bool isTumFolder(const std::filesystem::path& input) {
  return std::filesystem::exists(input / "rgb.txt") || std::filesystem::exists(input / "associations.txt");
}

}  // namespace

std::unique_ptr<ObservationSource> openSource(const std::filesystem::path& input, const SourceOptions& options) {
  if (!std::filesystem::exists(input)) throw core::InputError(input.string() + ": no such file or folder");
  const auto open = [&](WarningSink warn) -> std::unique_ptr<ObservationSource> {
    SourceOptions innerOptions = options;
    innerOptions.warn = std::move(warn);
    if (!isTumFolder(input) && bags::isBag(input)) return std::make_unique<BagSource>(input, innerOptions);
    if (std::filesystem::is_directory(input)) return std::make_unique<TumFolderSource>(input, innerOptions);
    refuseForeignInput(input);
    return std::make_unique<RawlogSource>(input, innerOptions);
  };
  return std::make_unique<PrefetchingSource>(open, options.warn);
}

}  // namespace wardslam::sources

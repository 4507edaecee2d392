#include "wardslam/core/data_files.h"

#include <dlfcn.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "wardslam/core/errors.h"

namespace wardslam::core {
namespace {

/// Things are found from where this library lies, so that an installation may be moved as a whole.
std::filesystem::path fromLibrary(const std::filesystem::path& way) {
  static const char kPartOfThisLibrary = 0;
  Dl_info library{};
  if (dladdr(&kPartOfThisLibrary, &library) == 0 || library.dli_fname == nullptr) return {};
  return (std::filesystem::path(library.dli_fname).parent_path() / way).lexically_normal();
}

}  // namespace

std::filesystem::path findDataFile(const std::filesystem::path& name, const std::filesystem::path& referringFile) {
  if (name.is_absolute()) {
    if (std::filesystem::exists(name)) return name;
    throw InputError(name.string() + ": no such file");
  }
  std::vector<std::filesystem::path> folders;
  if (!referringFile.empty()) folders.push_back(referringFile.parent_path());
  if (const char* chosen = std::getenv("WARDSLAM_DATA_DIR")) folders.emplace_back(chosen);
  const auto installed = fromLibrary(WARDSLAM_DATA_DIR_FROM_LIBRARY);
  for (const auto& folder : {installed, installed.parent_path()}) folders.push_back(folder);
  for (const char* folder : {WARDSLAM_SOURCE_DATA_DIR, WARDSLAM_SOURCE_SHARE_DIR}) folders.emplace_back(folder);

  std::string tried;
  for (const auto& folder : folders) {
    if (std::filesystem::exists(folder / name)) return folder / name;
    tried += (tried.empty() ? "" : ", ") + (folder.empty() ? std::string(".") : folder.string());
  }
  throw InputError(name.string() + ": not found in " + tried + "; give its full path or set WARDSLAM_DATA_DIR");
}

std::filesystem::path findProgram(const std::filesystem::path& name) {
  if (name.has_parent_path()) return name;
  for (const char* folder : {WARDSLAM_BIN_DIR_FROM_LIBRARY, "../bin"}) {  // installed; build tree
    auto program = fromLibrary(folder) / name;
    if (std::filesystem::exists(program)) return program;
  }
  return name;
}

}  // namespace wardslam::core

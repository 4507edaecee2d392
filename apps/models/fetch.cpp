#include "models/fetch.h"

#include <cstdlib>

#include "wardslam/core/digest.h"
#include "wardslam/core/errors.h"

namespace wardslam::apps {
namespace {

namespace fs = std::filesystem;

void createFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw core::InputError(folder.string() + ": cannot be made (" + error.message() + ")");
}

/// Moves a download into place, unless it is not what was promised.
Verification accept(const ModelFile& wanted, const fs::path& partial, const fs::path& file) {
  try {
    const Verification verification = verifyFile(wanted, partial);
    fs::rename(partial, file);
    return verification;
  } catch (const core::InputError& error) {
    fs::remove(partial);
    throw core::InputError(std::string(error.what()) + "; it came from " + wanted.url + " and was deleted");
  }
}

/// Tells what can be done about it here.
void downloadModel(const std::string& url, const fs::path& partial, const DownloadObserver& observer) {
  try {
    download(url, partial, observer);
  } catch (const Unreachable& error) {
    throw core::InputError(std::string(error.what()) + ", and `wardslam models verify` checks a copy");
  }
}

}  // namespace

Verification verifyFile(const ModelFile& expected, const fs::path& file) {
  const auto fail = [&](const std::string& what) { throw core::InputError(file.string() + ": " + what); };
  if (!fs::is_regular_file(file)) fail("no such file");
  const std::uint64_t size_bytes = fs::file_size(file);
  if (expected.size_bytes && size_bytes != *expected.size_bytes) {
    fail("has " + std::to_string(size_bytes) + " bytes where " + expected.name + " has " +
         std::to_string(*expected.size_bytes));
  }
  if (!expected.checksum) return Verification::NoChecksumKnown;
  const auto& [algorithm, hex] = *expected.checksum;
  const std::string digest = core::digestOfFile(file, algorithm);
  if (digest != hex) fail("its " + algorithm + " is " + digest + " where that of " + expected.name + " is " + hex);
  return Verification::Matches;
}

Fetched fetchFile(const ModelFile& wanted, const fs::path& folder, const DownloadObserver& observer) {
  createFolder(folder);
  const fs::path file = folder / wanted.name;
  if (fs::exists(file)) {
    try {
      return {file, verifyFile(wanted, file), true};
    } catch (const core::InputError& error) {
      throw core::InputError(std::string(error.what()) + "; move it away to fetch it anew");
    }
  }
  const fs::path partial = folder / (wanted.name + ".partial");
  if (!wanted.checksum) fs::remove(partial);
  const bool isComplete = wanted.size_bytes && fs::exists(partial) && fs::file_size(partial) == *wanted.size_bytes;
  if (!isComplete) downloadModel(wanted.url, partial, observer);
  return {file, accept(wanted, partial, file), false};
}

fs::path defaultModelFolder() {
  const char* data = std::getenv("XDG_DATA_HOME");
  if (data != nullptr && fs::path(data).is_absolute()) return fs::path(data) / "wardslam" / "models";
  const char* home = std::getenv("HOME");
  if (home == nullptr) throw core::InputError("HOME is not set; say where the files are to lie (--to DIR)");
  return fs::path(home) / ".local" / "share" / "wardslam" / "models";
}

}  // namespace wardslam::apps

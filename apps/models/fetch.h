#pragma once

#include <filesystem>
#include <string>

#include "models/download.h"
#include "models/model_manifest.h"

namespace wardslam::apps {

enum class Verification { Matches, NoChecksumKnown };

/// Compares size and checksum with what the manifest states. Throws core::InputError when they differ or the file
/// cannot be read.
[[nodiscard]] Verification verifyFile(const ModelFile& expected, const std::filesystem::path& file);

struct Fetched {
  std::filesystem::path file;
  Verification verification = Verification::NoChecksumKnown;
  bool wasThere = false;  ///< Nothing was downloaded.
};

/// Downloads a file into the folder (made when absent) as "<name>.partial", verifies it and renames it. An interrupted
/// download is continued when a checksum can tell whether the whole is right, else begun anew. A file that is there
/// already is verified and left alone. Throws core::InputError; what was downloaded but is not what the manifest states
/// is deleted.
[[nodiscard]] Fetched fetchFile(const ModelFile& wanted, const std::filesystem::path& folder,
                                const DownloadObserver& observer = {});

/// $XDG_DATA_HOME/wardslam/models, which is ~/.local/share/wardslam/models where that is not set.
[[nodiscard]] std::filesystem::path defaultModelFolder();

}  // namespace wardslam::apps

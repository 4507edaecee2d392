#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "wardslam/core/errors.h"

namespace wardslam::apps {

/// How far a download is. What an earlier, interrupted one left counts as done.
struct DownloadState {
  std::uint64_t resumedFrom_bytes = 0;
  std::uint64_t done_bytes = 0;
  std::optional<std::uint64_t> total_bytes;
};

/// No connection: others will not come either.
class Unreachable : public core::InputError {
 public:
  using InputError::InputError;
};

/// Called several times a second; false ends the download.
using DownloadObserver = std::function<bool(const DownloadState&)>;

/// Writes what `url` (http or https) holds to `file`. What `file` holds already is taken for the beginning and only the
/// rest is asked for; where the server cannot do that, all of it anew. Whatever happens, what has arrived stays there.
/// Throws Unreachable (offline?), and core::InputError, with one sentence: no such file, server trouble, interrupted,
/// disk full.
void download(const std::string& url, const std::filesystem::path& file, const DownloadObserver& observer);

}  // namespace wardslam::apps

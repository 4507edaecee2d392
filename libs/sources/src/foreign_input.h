#pragma once

#include <filesystem>

namespace wardslam::sources {

/// Throws core::InputError where the first bytes tell that the file is no rawlog but an archive, a map, a video, …:
/// what it is, and what to do with it.
void refuseForeignInput(const std::filesystem::path& file);

}  // namespace wardslam::sources

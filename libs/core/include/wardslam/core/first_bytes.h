#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace wardslam::core {

/// The first bytes of a file, at most `count`, as they stand there: they tell what it is. Empty where it cannot be
/// read.
[[nodiscard]] std::string firstBytes(const std::filesystem::path& file, std::size_t count);

}  // namespace wardslam::core

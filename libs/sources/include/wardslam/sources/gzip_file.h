#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace wardslam::sources {

/// The size of the content, modulo 2^32, that the last four bytes of a gz file tell; nothing where it is no gz file. A
/// file that was cut off tells some other number. (RFC 1952: ISIZE.)
[[nodiscard]] std::optional<std::uint32_t> gzipContentSize(const std::filesystem::path& file);

}  // namespace wardslam::sources

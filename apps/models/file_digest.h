#pragma once

#include <filesystem>
#include <string>

namespace wardslam::apps {

/// Checksum of a file's content in lower-case hexadecimal. `algorithm`: "sha256" or another that OpenSSL knows by name.
/// Throws core::InputError when the file cannot be read, std::invalid_argument when there is no such algorithm.
[[nodiscard]] std::string fileDigest(const std::filesystem::path& file, const std::string& algorithm);

/// Number of digits of such a checksum; 0 when there is no such algorithm.
[[nodiscard]] std::size_t digestLength(const std::string& algorithm);

}  // namespace wardslam::apps

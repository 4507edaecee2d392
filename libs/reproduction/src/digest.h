#pragma once

#include <filesystem>
#include <string>

namespace wardslam::reproduction {

/// SHA-256 of a file's bytes in lower-case hexadecimal; "absent" where there is none.
[[nodiscard]] std::string digestOfFile(const std::filesystem::path& file);

/// How many files a folder holds and how large they are together; "absent" where there is none.
[[nodiscard]] std::string extentOfFolder(const std::filesystem::path& folder);

}  // namespace wardslam::reproduction

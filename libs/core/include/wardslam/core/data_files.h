#pragma once

#include <filesystem>

namespace wardslam::core {

/// Finds a file that ships with the program (config/knowledge/hospital.yaml). `name` is tried as given when absolute;
/// else beside `referringFile` (the configuration that names it), in $WARDSLAM_DATA_DIR, in the installed data folder
/// (share/wardslam/config, then share/wardslam) and in config/ and share/ of the source tree the program was built
/// from. Throws InputError listing the places when none has it.
[[nodiscard]] std::filesystem::path findDataFile(const std::filesystem::path& name,
                                                 const std::filesystem::path& referringFile = {});

/// A program that comes with the library, by where the library lies; its bare name, for a search in $PATH, where it is
/// not there. A name with a folder is taken as it is.
[[nodiscard]] std::filesystem::path findProgram(const std::filesystem::path& name);

}  // namespace wardslam::core

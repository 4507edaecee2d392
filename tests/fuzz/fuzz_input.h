#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "wardslam/core/errors.h"

namespace wardslam::fuzz {

/// A folder of this process, in memory where the system has such; gone with the process.
class ScratchFolder {
 public:
  ScratchFolder() {
    const std::filesystem::path memory = "/dev/shm";
    const auto base = std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
    path_ = base / ("wardslam_fuzz_" + std::to_string(getpid()));
    std::filesystem::create_directories(path_);
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// Writes a file of this name, in place of one that may be there.
  std::filesystem::path write(const std::string& name, const std::uint8_t* data, std::size_t size) const {
    const auto file = path_ / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream out(file, std::ios::binary | std::ios::trunc);
    out.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    return file;
  }

 private:
  std::filesystem::path path_;
};

inline const ScratchFolder& scratch() {
  static const ScratchFolder folder;
  return folder;
}

/// A parser may refuse its input by core::InputError, and by `Refusals`. What else it throws ends the process.
template <class... Refusals>
struct MayRefuse;

template <>
struct MayRefuse<> {
  template <class Parse>
  static void run(const Parse& parse) {
    try {
      parse();
    } catch (const core::InputError&) {
    }
  }
};

template <class Refusal, class... Others>
struct MayRefuse<Refusal, Others...> {
  template <class Parse>
  static void run(const Parse& parse) {
    try {
      MayRefuse<Others...>::run(parse);
    } catch (const Refusal&) {
    }
  }
};

template <class... Refusals, class Parse>
void mayRefuse(const Parse& parse) {
  MayRefuse<Refusals...>::run(parse);
}

}  // namespace wardslam::fuzz

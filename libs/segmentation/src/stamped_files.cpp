#include "wardslam/segmentation/stamped_files.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <iterator>
#include <string>
#include <system_error>

#include "wardslam/core/errors.h"

namespace wardslam::segmentation {
namespace {

// Microseconds as integers: stamps that went through text and back compare equal.
std::int64_t toMicroseconds(double stamp_s) { return std::llround(stamp_s * 1e6); }

std::optional<std::int64_t> stampOf(const std::filesystem::path& file) {
  const std::string stem = file.stem().string();
  const char* const end = stem.data() + stem.size();
  double stamp_s = 0.0;
  const auto parsed = std::from_chars(stem.data(), end, stamp_s, std::chars_format::fixed);
  const bool plausible = parsed.ec == std::errc() && parsed.ptr == end && std::abs(stamp_s) < 1e12;
  return plausible ? std::optional(toMicroseconds(stamp_s)) : std::nullopt;
}

std::string lowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

}  // namespace

StampedFiles::StampedFiles(const std::filesystem::path& folder, const std::filesystem::path& extension) {
  std::error_code trouble;
  std::filesystem::directory_iterator entries(folder, trouble);
  if (trouble) {
    throw core::InputError(folder.string() + ": cannot be listed (" + trouble.message() +
                           "); give the folder that holds one file per image, named by its stamp");
  }
  for (const auto& entry : entries) {
    if (lowerCase(entry.path().extension().string()) != extension.string()) continue;
    if (const auto stamp_us = stampOf(entry.path())) files_.push_back({*stamp_us, entry.path()});
  }
  if (files_.empty()) {
    throw core::InputError(folder.string() + ": holds no " + extension.string() +
                           " file named by the stamp of an image, such as 1305031234.293697" + extension.string());
  }
  std::sort(files_.begin(), files_.end(), [](const File& a, const File& b) {
    return a.stamp_us != b.stamp_us ? a.stamp_us < b.stamp_us : a.path < b.path;
  });
}

std::optional<std::filesystem::path> StampedFiles::nearest(double stamp_s, double tolerance_s) const {
  const std::int64_t stamp_us = toMicroseconds(stamp_s);
  const auto distance_us = [&](const File& file) { return std::abs(file.stamp_us - stamp_us); };
  auto found = std::lower_bound(files_.begin(), files_.end(), stamp_us,
                                [](const File& file, std::int64_t wanted_us) { return file.stamp_us < wanted_us; });
  if (found == files_.end() || (found != files_.begin() && distance_us(*std::prev(found)) < distance_us(*found))) {
    --found;
  }
  if (distance_us(*found) > toMicroseconds(tolerance_s)) return std::nullopt;
  return found->path;
}

double StampedFiles::firstStamp_s() const { return static_cast<double>(files_.front().stamp_us) * 1e-6; }

double StampedFiles::lastStamp_s() const { return static_cast<double>(files_.back().stamp_us) * 1e-6; }

}  // namespace wardslam::segmentation

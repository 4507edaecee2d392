#include "wardslam/segmentation/stamped_files.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <string>
#include <system_error>

#include "wardslam/core/errors.h"

namespace wardslam::segmentation {
namespace {

// Microseconds as integers: stamps that went through text and back compare equal. Within what can be subtracted.
std::int64_t toMicroseconds(double stamp_s) {
  constexpr double kLatest_us = 4e18;
  return std::llround(std::clamp(stamp_s * 1e6, -kLatest_us, kLatest_us));
}

std::string lowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

bool isImageEnding(const std::string& extension) {
  return extension == ".png" || extension == ".jpg" || extension == ".jpeg";
}

/// The digits of a name; nothing where it is not a number.
std::optional<std::string> stampIn(const std::filesystem::path& file) {
  std::filesystem::path stem = file.stem();
  if (isImageEnding(lowerCase(stem.extension().string()))) stem = stem.stem();
  std::string stamp = stem.string();
  if (std::count(stamp.begin(), stamp.end(), '_') == 1 && stamp.find('.') == std::string::npos) {
    std::replace(stamp.begin(), stamp.end(), '_', '.');
  }
  const bool isPlain = std::all_of(stamp.begin(), stamp.end(), [](unsigned char letter) {
    return std::isdigit(letter) != 0 || letter == '.' || letter == '-';
  });
  return isPlain && core::StampClock().seconds(stamp) ? std::optional(stamp) : std::nullopt;
}

core::StampClock clockOf(const std::filesystem::path& folder, std::vector<std::string> stamps, double rate_hz) {
  const auto valueOf = [](const std::string& stamp) { return *core::StampClock().seconds(stamp); };
  std::sort(stamps.begin(), stamps.end(),
            [&](const std::string& a, const std::string& b) { return valueOf(a) < valueOf(b); });
  if (const auto unit = core::recogniseStampUnit({stamps.begin(), stamps.end()}))
    return core::StampClock(*unit, rate_hz);
  throw core::InputError(folder.string() + ": names such as " + stamps.front() +
                         " may count milliseconds as well as images; name the files by the stamps of the images, in "
                         "seconds");
}

}  // namespace

StampedFiles::StampedFiles(const std::filesystem::path& folder, const std::filesystem::path& extension,
                           double rate_hz) {
  std::error_code trouble;
  std::filesystem::directory_iterator entries(folder, trouble);
  if (trouble) {
    throw core::InputError(folder.string() + ": cannot be listed (" + trouble.message() +
                           "); give the folder that holds one file per image, named by its stamp");
  }
  std::vector<std::filesystem::path> paths;
  std::vector<std::string> stamps;
  for (const auto& entry : entries) {
    if (lowerCase(entry.path().extension().string()) != extension.string()) continue;
    const auto stamp = stampIn(entry.path());
    if (!stamp) continue;
    paths.push_back(entry.path());
    stamps.push_back(*stamp);
  }
  if (paths.empty()) {
    throw core::InputError(folder.string() + ": holds no " + extension.string() +
                           " file named by the stamp of an image, such as 1305031234.293697" + extension.string());
  }
  clock_ = clockOf(folder, stamps, rate_hz);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    files_.push_back({toMicroseconds(clock_.seconds(stamps[i]).value_or(0.0)), paths[i]});
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

#include "foreign_input.h"

#include <string>
#include <string_view>
#include <utility>

#include "byte_source.h"
#include "wardslam/core/errors.h"

namespace wardslam::sources {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kHead_bytes = 512;
constexpr std::size_t kTarMarkAt = 257;

/// A mark at the beginning of a file's content, what it marks, and what to do with that.
struct Kind {
  std::string_view mark;
  const char* name;
  const char* advice;
};

constexpr const char* kUnpack = "unpack it and give the folder or the .rawlog in it";
constexpr const char* kNoRecording = "give a .rawlog, a folder in the layout of the TUM benchmark or an .ini file";

constexpr const char* kExport = "export its images as a folder in the layout of the TUM benchmark";
constexpr const char* kUnpackBag = "unpack it (gunzip, zstd -d) and give what comes out";

constexpr Kind kKinds[] = {
    {"PK\x03\x04", "a zip archive", kUnpack},
    {"BZh", "an archive compressed with bzip2", kUnpack},
    {"\xFD"
     "7zXZ",
     "an archive compressed with xz", kUnpack},
    {"7z\xBC\xAF\x27\x1C", "a 7z archive", kUnpack},
    {"Rar!", "a rar archive", kUnpack},
    {"\x89PNG", "a picture", kNoRecording},
    {"\xFF\xD8\xFF", "a picture", kNoRecording},
    {"\x89HDF", "an HDF5 file", kNoRecording},
    {"\x1A\x45\xDF\xA3", "a Matroska video (of Azure Kinect, perhaps)", kExport},
    {"ply\n", "a point cloud", kNoRecording},
    {"# .PCD", "a point cloud", kNoRecording},
    {"NI10", "a recording of OpenNI (.oni)", kExport},
    {"RIFF", "a video", kExport},
    {"#ROSBAG", "a packed bag of ROS 1", kUnpackBag},
    {"\x89MCAP0", "a packed MCAP file", kUnpackBag},
};

std::string headOf(const fs::path& file) {
  std::string head(kHead_bytes, '\0');
  head.resize(openBytes(file)->read(reinterpret_cast<std::uint8_t*>(head.data()), head.size()));
  return head;
}

[[noreturn]] void fail(const fs::path& file, const std::string& name, const std::string& advice) {
  throw core::InputError(file.string() + ": is " + name + ", no rawlog; " + advice);
}

}  // namespace

void refuseForeignInput(const fs::path& file) {
  const std::string head = headOf(file);
  for (const Kind& kind : kKinds) {
    if (head.compare(0, kind.mark.size(), kind.mark) == 0) fail(file, kind.name, kind.advice);
  }
  if (head.compare(0, 15, "SQLite format 3") == 0) {
    fail(file, "a map", "give the recording, and this map with --map to go on in it");
  }
  if (head.size() > kTarMarkAt && head.compare(kTarMarkAt, 5, "ustar") == 0) {
    fail(file, "a tar archive",
         "unpack it (tar xf " + file.filename().string() + ") and give the folder that is in it");
  }
  if (head.size() > 8 && head.compare(4, 4, "ftyp") == 0) fail(file, "a video", kExport);
  for (const auto& [extension, program] :
       {std::pair(".klg", "Logger2"), std::pair(".sens", "ScanNet"), std::pair(".svo", "ZED cameras")}) {
    if (file.extension() == extension) fail(file, std::string("a recording of ") + program, kExport);
  }
}

}  // namespace wardslam::sources

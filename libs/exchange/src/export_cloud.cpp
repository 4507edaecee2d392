#include <ostream>

#include "wardslam/core/atomic_file.h"
#include "wardslam/core/blob.h"
#include "wardslam/exchange/map_export.h"
#include "wardslam/mapping/cloud_in_map.h"

namespace wardslam::exchange {
namespace {

/// The points as records of bytes, one after another.
struct Records {
  std::size_t count = 0;
  core::ByteWriter bytes;
};

void putPosition(core::ByteWriter& out, const Eigen::Vector3f& p_map_m) {
  for (const float coordinate : p_map_m) out.put(coordinate);
}

/// The class twice: CloudCompare takes properties called scalar_…, PCL a label of 4 bytes.
Records plyRecords(const mapping::SemanticMap& map) {
  Records records;
  mapping::forEachCloudPoint(map, [&records](const Eigen::Vector3f& p_map_m, const mapping::SemanticPoint& point) {
    putPosition(records.bytes, p_map_m);
    for (const std::uint8_t channel : point.color_rgb) records.bytes.put(channel);
    records.bytes.put(point.classId);
    records.bytes.put(point.object);
    records.bytes.put(std::uint32_t{point.classId});
    ++records.count;
  });
  return records;
}

/// PCL's convention for colours: 0x00RRGGBB.
std::uint32_t packedColor(const std::array<std::uint8_t, 3>& rgb) {
  return (std::uint32_t{rgb[0]} << 16U) | (std::uint32_t{rgb[1]} << 8U) | std::uint32_t{rgb[2]};
}

Records pcdRecords(const mapping::SemanticMap& map) {
  Records records;
  mapping::forEachCloudPoint(map, [&records](const Eigen::Vector3f& p_map_m, const mapping::SemanticPoint& point) {
    putPosition(records.bytes, p_map_m);
    records.bytes.put(packedColor(point.color_rgb));
    records.bytes.put(std::uint32_t{point.classId});
    records.bytes.put(point.object);
    ++records.count;
  });
  return records;
}

void write(const std::filesystem::path& file, const std::string& header, const Records& records) {
  core::AtomicFile out(file);
  const core::Bytes& bytes = records.bytes.bytes();
  out.stream() << header;
  out.stream().write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  out.commit();
}

}  // namespace

void exportPly(const mapping::SemanticMap& map, const std::filesystem::path& file) {
  const Records records = plyRecords(map);
  write(file,
        "ply\nformat binary_little_endian 1.0\ncomment WardSLAM semantic cloud, map frame, metres\n"
        "element vertex " +
            std::to_string(records.count) +
            "\nproperty float x\nproperty float y\nproperty float z\n"
            "property uchar red\nproperty uchar green\nproperty uchar blue\n"
            "property uchar scalar_class\nproperty uint scalar_instance\nproperty uint label\nend_header\n",
        records);
}

void exportPcd(const mapping::SemanticMap& map, const std::filesystem::path& file) {
  const Records records = pcdRecords(map);
  const std::string count = std::to_string(records.count);
  write(file,
        "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z rgb label instance\n"
        "SIZE 4 4 4 4 4 4\nTYPE F F F F U U\nCOUNT 1 1 1 1 1 1\nWIDTH " +
            count + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + count + "\nDATA binary\n",
        records);
}

}  // namespace wardslam::exchange

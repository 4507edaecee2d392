#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "wardslam/bags/bag_damage.h"
#include "wardslam/bags/byte_view.h"

namespace wardslam::bags {

/// How messages are serialised.
enum class Wire { Ros1, Cdr, Unknown };

struct Topic {
  std::string name;  ///< "/camera/color/image_raw"
  std::string type;  ///< As ROS 1 writes it, whichever wrote the bag: "sensor_msgs/Image".
  Wire wire = Wire::Unknown;
  std::size_t messages = 0;
};

/// One message, not read yet.
struct Entry {
  std::size_t topic = 0;       ///< Index into topics().
  std::int64_t logged_ns = 0;  ///< When it was recorded, since 1970.
};

/// The messages of a recording of ROS. All are listed when it is opened; each is read when it is asked for.
class BagReader {
 public:
  virtual ~BagReader() = default;

  [[nodiscard]] const std::vector<Topic>& topics() const { return topics_; }

  /// In order of time.
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }

  /// What was found damaged when it was opened; entries() lists what can still be read.
  [[nodiscard]] const std::vector<BagDamage>& damage() const { return damage_; }

  /// The serialised message. Reading in order of time is fast: chunks are unpacked once. Throws BagDamage.
  [[nodiscard]] virtual Bytes read(std::size_t entry) = 0;

 protected:
  std::vector<Topic> topics_;
  std::vector<Entry> entries_;
  std::vector<BagDamage> damage_;
};

/// Whether a path is a recording of ROS, by its first bytes: a ROS 1 bag, an MCAP file, a ROS 2 bag in an SQLite
/// database, or the folder of a ROS 2 bag.
[[nodiscard]] bool isBag(const std::filesystem::path& path);

/// Throws core::InputError where it is none, or of a kind or version that is not read.
[[nodiscard]] std::unique_ptr<BagReader> openBag(const std::filesystem::path& path);

}  // namespace wardslam::bags

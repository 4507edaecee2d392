#include "mcap_bag.h"
#include "ros1_bag.h"
#include "split_bag.h"
#include "sqlite_bag.h"
#include "wardslam/bags/bag_reader.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/first_bytes.h"

namespace wardslam::bags {
namespace {

constexpr std::size_t kHead_bytes = 16;

bool startsWith(const std::string& text, const std::string& mark) { return text.compare(0, mark.size(), mark) == 0; }

const std::string kMcapMagic(McapBag::kMagic, McapBag::kMagic_bytes);

}  // namespace

bool isBag(const std::filesystem::path& path) {
  if (std::filesystem::is_directory(path)) return SplitBag::isOne(path);
  const std::string head = core::firstBytes(path, kHead_bytes);
  return startsWith(head, Ros1Bag::kMagic) || startsWith(head, kMcapMagic) ||
         (startsWith(head, SqliteBag::kMagic) && path.extension() != ".wardmap");
}

std::unique_ptr<BagReader> openBag(const std::filesystem::path& path) {
  if (std::filesystem::is_directory(path)) return std::make_unique<SplitBag>(path);
  const std::string head = core::firstBytes(path, kHead_bytes);
  if (startsWith(head, Ros1Bag::kMagic)) return std::make_unique<Ros1Bag>(path);
  if (startsWith(head, kMcapMagic)) return std::make_unique<McapBag>(path);
  if (startsWith(head, SqliteBag::kMagic)) return std::make_unique<SqliteBag>(path);
  throw core::InputError(path.string() + ": is no recording of ROS: neither a bag of ROS 1, nor MCAP, nor a .db3 file");
}

}  // namespace wardslam::bags

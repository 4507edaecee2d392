#include <algorithm>
#include <fstream>

#include "mcap_bag.h"
#include "ros1_bag.h"
#include "split_bag.h"
#include "sqlite_bag.h"
#include "wardslam/bags/bag_reader.h"
#include "wardslam/core/errors.h"

namespace wardslam::bags {
namespace {

std::string firstBytes(const std::filesystem::path& file) {
  std::string head(16, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  return head;
}

bool startsWith(const std::string& text, const std::string& mark) { return text.compare(0, mark.size(), mark) == 0; }

const std::string kMcapMagic(McapBag::kMagic, McapBag::kMagic_bytes);

}  // namespace

bool isBag(const std::filesystem::path& path) {
  if (std::filesystem::is_directory(path)) return SplitBag::isOne(path);
  const std::string head = firstBytes(path);
  return startsWith(head, Ros1Bag::kMagic) || startsWith(head, kMcapMagic) ||
         (startsWith(head, SqliteBag::kMagic) && path.extension() != ".wardmap");
}

std::unique_ptr<BagReader> openBag(const std::filesystem::path& path) {
  if (std::filesystem::is_directory(path)) return std::make_unique<SplitBag>(path);
  const std::string head = firstBytes(path);
  if (startsWith(head, Ros1Bag::kMagic)) return std::make_unique<Ros1Bag>(path);
  if (startsWith(head, kMcapMagic)) return std::make_unique<McapBag>(path);
  if (startsWith(head, SqliteBag::kMagic)) return std::make_unique<SqliteBag>(path);
  throw core::InputError(path.string() + ": is no recording of ROS: neither a bag of ROS 1, nor MCAP, nor a .db3 file");
}

}  // namespace wardslam::bags

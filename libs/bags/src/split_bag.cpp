#include "split_bag.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <tuple>

#include "wardslam/core/errors.h"

namespace wardslam::bags {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMetadata = "metadata.yaml";
constexpr const char* kInformation = "rosbag2_bagfile_information";

bool isPart(const fs::path& file) { return file.extension() == ".mcap" || file.extension() == ".db3"; }

std::vector<fs::path> partsOf(const fs::path& folder) {
  std::vector<fs::path> parts;
  std::error_code unreadable;
  for (const auto& entry : fs::directory_iterator(folder, unreadable)) {
    if (isPart(entry.path())) parts.push_back(entry.path());
  }
  const auto order = [](const fs::path& file) {  // bag_10 comes after bag_9
    const std::string name = file.filename().string();
    return std::tuple(name.size(), name);
  };
  std::sort(parts.begin(), parts.end(), [&](const fs::path& a, const fs::path& b) { return order(a) < order(b); });
  return parts;
}

std::vector<fs::path> partsByMetadata(const fs::path& folder) {
  const fs::path file = folder / kMetadata;
  std::vector<fs::path> parts;
  try {
    const YAML::Node information = YAML::LoadFile(file.string())[kInformation];
    for (const YAML::Node& part : information["relative_file_paths"]) parts.push_back(folder / part.as<std::string>());
  } catch (const YAML::Exception& error) {
    throw core::InputError(file.string() + ": cannot be read as the description of a ROS 2 bag: " + error.what());
  }
  return parts;
}

}  // namespace

bool SplitBag::isOne(const fs::path& folder) {
  if (!fs::is_directory(folder)) return false;
  if (!fs::exists(folder / kMetadata)) return !partsOf(folder).empty();
  try {
    return YAML::LoadFile((folder / kMetadata).string())[kInformation].IsDefined();
  } catch (const YAML::Exception&) {
    return false;
  }
}

SplitBag::SplitBag(const fs::path& folder) {
  const auto parts = fs::exists(folder / kMetadata) ? partsByMetadata(folder) : partsOf(folder);
  for (const fs::path& part : parts) {
    if (part.extension() == ".zstd") {
      throw core::InputError(part.string() +
                             ": is packed as a whole; unpack it with 'zstd -d' and give what comes out");
    }
    if (!fs::is_regular_file(part)) {
      throw core::InputError(part.string() + ": is missing, though " + (folder / kMetadata).string() +
                             " lists it; copy it there, or give one of the files that are there");
    }
    append(part);
  }
  if (parts.empty()) throw core::InputError(folder.string() + ": is a ROS 2 bag that lists no file");
}

void SplitBag::append(const fs::path& file) {
  auto part = openBag(file);
  std::vector<std::size_t> topicOf;
  for (const Topic& topic : part->topics()) {
    const auto known = std::find_if(topics_.begin(), topics_.end(), [&](const Topic& other) {
      return other.name == topic.name && other.type == topic.type && other.wire == topic.wire;
    });
    topicOf.push_back(static_cast<std::size_t>(known - topics_.begin()));
    if (known == topics_.end()) topics_.push_back({topic.name, topic.type, topic.wire, 0});
    topics_[topicOf.back()].messages += topic.messages;
  }
  firstEntry_.push_back(entries_.size());
  for (const Entry& entry : part->entries()) entries_.push_back({topicOf[entry.topic], entry.logged_ns});
  for (const BagDamage& damage : part->damage()) {
    damage_.emplace_back(damage.event(), file.filename().string() + " " + damage.what());
  }
  parts_.push_back(std::move(part));
}

Bytes SplitBag::read(std::size_t entry) {
  const auto behind = std::upper_bound(firstEntry_.begin(), firstEntry_.end(), entry);
  const auto part = static_cast<std::size_t>(behind - firstEntry_.begin()) - 1;
  return parts_.at(part)->read(entry - firstEntry_[part]);
}

}  // namespace wardslam::bags

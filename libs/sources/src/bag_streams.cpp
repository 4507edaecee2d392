#include "bag_streams.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <tuple>

#include "wardslam/bags/image_decoding.h"
#include "wardslam/bags/messages.h"
#include "wardslam/core/errors.h"
#include "wardslam/sources/choice_needed.h"

namespace wardslam::sources {
namespace {

using bags::BagReader;
using bags::Topic;

constexpr const char* kImage = "sensor_msgs/Image";
constexpr const char* kCompressedImage = "sensor_msgs/CompressedImage";
constexpr const char* kCameraInfo = "sensor_msgs/CameraInfo";
constexpr const char* kOdometry = "nav_msgs/Odometry";
constexpr const char* kTransform = "geometry_msgs/Transform";
constexpr const char* kNumber = "std_msgs/Float32";
constexpr const char* kText = "std_msgs/String";
const std::vector<std::string> kImages = {kImage, kCompressedImage};

bool contains(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

std::string described(const Topic& topic) {
  return topic.name + " (" + topic.type + ", " + std::to_string(topic.messages) + ")";
}

std::string listed(const BagReader& bag, const std::vector<std::size_t>& topics) {
  std::string text;
  for (const std::size_t i : topics) text += (text.empty() ? "" : ", ") + described(bag.topics()[i]);
  return text;
}

std::string allTopics(const BagReader& bag) {
  std::vector<std::size_t> all(bag.topics().size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  if (!all.empty()) return "its topics are " + listed(bag, all);
  return bag.damage().empty() ? std::string("it holds no topic")
                              : std::string("it holds no topic, and ") + bag.damage().front().what();
}

/// The name without what image_transport appends for a packing.
std::string withoutTransport(const std::string& name) {
  const std::size_t end = name.find_last_of('/');
  return end != std::string::npos && name.compare(end + 1, 10, "compressed") == 0 ? name.substr(0, end) : name;
}

/// How far two names agree, part by part.
std::size_t sharedParts(const std::string& a, const std::string& b) {
  std::size_t parts = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()) && a[i] == b[i]; ++i) parts += a[i] == '/' ? 1 : 0;
  return parts;
}

/// What the first image of a topic is; empty where it cannot be read.
std::string encodingOf(BagReader& bag, std::size_t topic) {
  const auto& entries = bag.entries();
  const auto first =
      std::find_if(entries.begin(), entries.end(), [topic](const bags::Entry& entry) { return entry.topic == topic; });
  if (first == entries.end()) return {};
  const Topic& about = bag.topics()[topic];
  try {
    const bags::Bytes message = bag.read(static_cast<std::size_t>(first - entries.begin()));
    return about.type == kImage ? bags::readImage(message, about.wire).encoding
                                : bags::readCompressedImage(message, about.wire).format;
  } catch (const bags::BagDamage&) {
    return {};
  }
}

/// Smaller is more likely; nothing where it is none.
std::optional<int> rankAsColor(const Topic& topic, const std::string& encoding) {
  const bool isCompressed = topic.type == kCompressedImage;
  if (isCompressed ? bags::isCompressedDepth(encoding) : !bags::isColorEncoding(encoding)) return std::nullopt;
  const bool isGrey = contains(encoding, "mono") || encoding == "8UC1" || contains(topic.name, "infra");
  const bool isPictureOfDepth = contains(topic.name, "depth") && !contains(topic.name, "rgb");
  if (isCompressed && isPictureOfDepth) return std::nullopt;
  return (isPictureOfDepth ? 2 : 0) + (isGrey ? 1 : 0);
}

std::optional<int> rankAsDepth(const Topic& topic, const std::string& encoding) {
  const bool isNamed = contains(topic.name, "depth") || contains(topic.name, "Depth");
  const bool isCompressed = topic.type == kCompressedImage;
  const bool isDepth = isCompressed ? bags::isCompressedDepth(encoding) || isNamed : bags::isDepthEncoding(encoding);
  if (!isDepth || (encoding == "mono16" && !isNamed)) return std::nullopt;
  if (contains(topic.name, "confidence") || contains(topic.name, "disparity")) return std::nullopt;
  return (isNamed ? 0 : 2) + (isRegisteredByName(topic.name) ? 0 : 1);
}

/// Those of the best rank, packed ones only where there is no other of the same name.
std::vector<std::size_t> best(const BagReader& bag, const std::map<std::size_t, int>& ranks) {
  std::map<std::string, std::size_t> unpacked;
  for (const auto& [topic, rank] : ranks) {
    const auto [twin, isNew] = unpacked.try_emplace(withoutTransport(bag.topics()[topic].name), topic);
    if (!isNew && bag.topics()[topic].type == kImage) twin->second = topic;
  }
  int bestRank = 100;
  for (const auto& [name, topic] : unpacked) bestRank = std::min(bestRank, ranks.at(topic));
  std::vector<std::size_t> topics;
  for (const auto& [name, topic] : unpacked) {
    if (ranks.at(topic) == bestRank) topics.push_back(topic);
  }
  return topics;
}

/// Those whose names share most with another topic.
std::vector<std::size_t> nearest(const BagReader& bag, const std::vector<std::size_t>& topics,
                                 const std::string& name) {
  std::size_t most = 0;
  for (const std::size_t i : topics) most = std::max(most, sharedParts(bag.topics()[i].name, name));
  std::vector<std::size_t> near;
  for (const std::size_t i : topics) {
    if (sharedParts(bag.topics()[i].name, name) == most) near.push_back(i);
  }
  return near;
}

class Finder {
 public:
  Finder(BagReader& bag, const std::string& file) : bag_(bag), file_(file) {
    for (std::size_t i = 0; i < bag.topics().size(); ++i) {
      const Topic& topic = bag.topics()[i];
      if ((topic.type != kImage && topic.type != kCompressedImage) || topic.messages == 0) continue;
      const std::string encoding = encodingOf(bag, i);
      if (const auto rank = rankAsColor(topic, encoding)) colors_.emplace(i, *rank);
      if (const auto rank = rankAsDepth(topic, encoding)) depths_.emplace(i, *rank);
    }
  }

  [[nodiscard]] std::size_t wished(const std::string& name, const std::string& option,
                                   const std::vector<std::string>& types) const {
    for (const std::size_t i : ofType(types)) {
      const std::string& known = bag_.topics()[i].name;
      if (known == name || known == "/" + name) return i;
    }
    throw core::InputError(file_ + ": has no topic '" + name + "' of a type for " + option + "; " + allTopics(bag_));
  }

  /// Colour and depth; where one is told or clear, it helps to find the other.
  [[nodiscard]] std::pair<std::size_t, std::size_t> images(const BagTopics& wishes) const {
    auto colors = wishes.color.empty() ? best(bag_, colors_) : std::vector{wished(wishes.color, "--color", kImages)};
    auto depths = wishes.depth.empty() ? best(bag_, depths_) : std::vector{wished(wishes.depth, "--depth", kImages)};
    if (colors.size() == 1 && depths.size() > 1) depths = nearest(bag_, depths, bag_.topics()[colors.front()].name);
    if (depths.size() == 1 && colors.size() > 1) colors = nearest(bag_, colors, bag_.topics()[depths.front()].name);
    return {one(colors, "colour images", "--color"), one(depths, "depth images", "--depth")};
  }

  [[nodiscard]] std::size_t one(const std::vector<std::size_t>& topics, const std::string& what,
                                const std::string& option) const {
    if (topics.empty())
      throw core::InputError(file_ + ": holds no topic of " + what + " that is read; " + allTopics(bag_));
    if (topics.size() > 1) {
      throw ChoiceNeeded(file_ + ": holds several topics of " + what + ": " + listed(bag_, topics) + "; choose with " +
                         option);
    }
    return topics.front();
  }

  [[nodiscard]] std::vector<std::size_t> ofType(const std::vector<std::string>& types) const {
    std::vector<std::size_t> topics;
    for (std::size_t i = 0; i < bag_.topics().size(); ++i) {
      const Topic& topic = bag_.topics()[i];
      if (topic.messages > 0 && std::find(types.begin(), types.end(), topic.type) != types.end()) topics.push_back(i);
    }
    return topics;
  }

  /// The calibration beside images, where ROS and RealSense's own recorder put it.
  [[nodiscard]] std::optional<std::size_t> infoBeside(std::size_t images) const {
    const std::string base = withoutTransport(bag_.topics()[images].name);
    const std::string space = base.substr(0, base.find_last_of('/') + 1);
    const std::string above = space.substr(0, space.find_last_of('/', space.size() - 2) + 1);
    for (const std::size_t i : ofType({kCameraInfo})) {
      const std::string& name = bag_.topics()[i].name;
      if (name == space + "camera_info" || name == base + "/camera_info" || name == above + "info/camera_info")
        return i;
    }
    const std::string stream = realSenseStream(bag_.topics()[images].name);
    for (const std::size_t i : stream.empty() ? std::vector<std::size_t>() : ofType({kText})) {
      if (bag_.topics()[i].name == stream + "/camera_info") return i;
    }
    return std::nullopt;
  }

  [[nodiscard]] std::size_t info(std::size_t color, const std::string& wish) const {
    if (!wish.empty()) return wished(wish, "--info", {kCameraInfo});
    if (const auto beside = infoBeside(color)) return *beside;
    const auto all = ofType({kCameraInfo});
    if (all.empty()) {
      throw core::InputError(file_ + ": holds no sensor_msgs/CameraInfo, so the camera of " +
                             bag_.topics()[color].name + " is not known; give --camera with its calibration");
    }
    return one(all, "calibrations, of which none stands beside " + bag_.topics()[color].name, "--info");
  }

  /// Of /device_0/sensor_1/Color_0/image/data as RealSense's own recorder writes it: /device_0/sensor_1/Color_0/tf/0,
  /// in recordings of ROS 2 …/tf/ref_0.
  [[nodiscard]] std::optional<std::size_t> placeOf(std::size_t images) const {
    const std::string stream = realSenseStream(bag_.topics()[images].name);
    for (const std::size_t i : stream.empty() ? std::vector<std::size_t>() : ofType({kTransform, kText})) {
      if (bag_.topics()[i].name.compare(0, stream.size() + 4, stream + "/tf/") == 0) return i;
    }
    return std::nullopt;
  }

  /// Of /device_0/sensor_0/Depth_0/image/data: /device_0/sensor_0/option/Depth Units/value.
  [[nodiscard]] std::optional<std::size_t> unitOf(std::size_t images) const {
    const std::string stream = realSenseStream(bag_.topics()[images].name);
    const std::string options = stream.substr(0, stream.find_last_of('/') + 1) + "option/Depth";
    for (const std::size_t i : stream.empty() ? std::vector<std::size_t>() : ofType({kNumber, kText})) {
      const std::string& name = bag_.topics()[i].name;
      if (name == options + " Units/value" || name == options + "_Units/value") return i;
    }
    return std::nullopt;
  }

 private:
  BagReader& bag_;
  const std::string& file_;
  std::map<std::size_t, int> colors_;  ///< Topics that may be colour, and their rank.
  std::map<std::size_t, int> depths_;
};

}  // namespace

bool isRegisteredByName(const std::string& depthTopic) {
  return contains(depthTopic, "registered") || contains(depthTopic, "aligned") || contains(depthTopic, "to_color") ||
         contains(depthTopic, "to_rgb");
}

std::string realSenseStream(const std::string& imageTopic) {
  constexpr std::string_view kEnd = "/image/data";
  const std::string topic = withoutTransport(imageTopic);
  if (topic.compare(0, 8, "/device_") != 0 || topic.size() <= kEnd.size()) return {};
  const std::size_t end = topic.size() - kEnd.size();
  return topic.compare(end, kEnd.size(), kEnd) == 0 ? topic.substr(0, end) : std::string();
}

BagStreams findStreams(BagReader& bag, const BagTopics& wishes, bool needsInfo, const std::string& file,
                       const NoteSink& note) {
  const Finder finder(bag, file);
  BagStreams streams;
  std::tie(streams.color, streams.depth) = finder.images(wishes);
  streams.colorInfo = needsInfo ? finder.info(streams.color, wishes.info) : finder.infoBeside(streams.color);
  streams.depthInfo = finder.infoBeside(streams.depth);
  streams.transforms = finder.ofType({"tf2_msgs/TFMessage", "tf/tfMessage"});
  streams.colorPlace = finder.placeOf(streams.color);
  streams.depthPlace = finder.placeOf(streams.depth);
  streams.depthUnit = finder.unitOf(streams.depth);
  streams.imus = finder.ofType({"sensor_msgs/Imu"});
  const auto odometries = wishes.odometry.empty()
                              ? finder.ofType({kOdometry})
                              : std::vector{finder.wished(wishes.odometry, "--odometry", {kOdometry})};
  if (odometries.size() == 1) streams.odometry = odometries.front();

  if (odometries.size() > 1) {
    note(file + ": holds several odometries, of which none is taken: " + listed(bag, odometries) +
         "; bag2rawlog chooses one with --odometry");
  }
  return streams;
}

}  // namespace wardslam::sources

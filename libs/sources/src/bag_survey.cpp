#include "bag_survey.h"

#include <algorithm>
#include <cstdio>

#include "real_sense_text.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/stamp_association.h"
#include "wardslam/core/stamp_clock.h"

namespace wardslam::sources {
namespace {

std::string textOf(double stamp_s) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6f", stamp_s);
  return text;
}

void sortByStamp(std::vector<BagMessage>& messages) {
  std::stable_sort(messages.begin(), messages.end(),
                   [](const BagMessage& a, const BagMessage& b) { return a.stamp_s < b.stamp_s; });
  const auto isDouble = [](const BagMessage& a, const BagMessage& b) { return a.stamp_s == b.stamp_s; };
  messages.erase(std::unique(messages.begin(), messages.end(), isDouble), messages.end());
}

std::vector<double> stampsOf(const std::vector<BagMessage>& messages) {
  std::vector<double> stamps_s;
  stamps_s.reserve(messages.size());
  for (const BagMessage& message : messages) stamps_s.push_back(message.stamp_s);
  return stamps_s;
}

class Surveyor {
 public:
  Surveyor(bags::BagReader& bag, const BagStreams& streams) : bag_(bag), streams_(streams) {}

  void look(std::size_t entry) {
    const std::size_t topic = bag_.entries()[entry].topic;
    const bool isTransform = isAmong(streams_.transforms, topic);
    const bool isImu = isAmong(streams_.imus, topic);
    const bool isStamped = topic == streams_.color || topic == streams_.depth || topic == streams_.odometry || isImu;
    const bool isInfo = topic == streams_.colorInfo || topic == streams_.depthInfo;
    const bool isPlace = topic == streams_.colorPlace || topic == streams_.depthPlace;
    const bool isUnit = topic == streams_.depthUnit;
    if (!isStamped && !isInfo && !isTransform && !isPlace && !isUnit) return;
    const bags::Bytes message = bag_.read(entry);
    const bags::Wire wire = bag_.topics()[topic].wire;
    if (isUnit) {
      const double unit_m = isText(topic) ? realSenseNumber(bags::readText(message, wire))
                                          : static_cast<double>(bags::readFloat32(message, wire));
      if (unit_m > 0.0 && unit_m < 1.0) found_.depthUnit_m = unit_m;
      return;
    }
    if (isPlace) {
      addPlace(topic,
               isText(topic) ? realSensePlace(bags::readText(message, wire)) : bags::readTransform(message, wire));
      return;
    }
    if (isTransform) {
      for (const bags::Transform& transform : bags::readTransforms(message, wire)) found_.transforms.add(transform);
      return;
    }
    if (isInfo) {
      lookAtInfo(topic,
                 isText(topic) ? realSenseCamera(bags::readText(message, wire)) : bags::readCameraInfo(message, wire));
      return;
    }
    const bags::Header header = bags::readHeader(message, wire);
    const BagMessage stamped{core::secondsOf(header.stamp_ns), entry};
    if (isImu) found_.imus.push_back(stamped);
    if (topic == streams_.odometry) {
      if (found_.odometries.empty()) found_.robotFrame = bags::readOdometry(message, wire).child;
      found_.odometries.push_back(stamped);
    }
    if (topic == streams_.color) addImage(found_.colors, found_.colorFrame, stamped, header);
    if (topic == streams_.depth) addImage(found_.depths, found_.depthFrame, stamped, header);
  }

  BagSurvey finish(const std::string& file) {
    const auto hasNone = [](const BagMessage& message) { return message.stamp_s == 0.0; };
    found_.hasNoStamps = std::all_of(found_.colors.begin(), found_.colors.end(), hasNone) ||
                         std::all_of(found_.depths.begin(), found_.depths.end(), hasNone);
    if (found_.hasNoStamps) {
      for (auto* messages : {&found_.colors, &found_.depths, &found_.odometries, &found_.imus})
        takeTimesOfRecording(*messages);
    }
    for (auto* messages : {&found_.colors, &found_.depths, &found_.odometries}) sortByStamp(*messages);
    std::stable_sort(found_.imus.begin(), found_.imus.end(),
                     [](const BagMessage& a, const BagMessage& b) { return a.stamp_s < b.stamp_s; });
    nameRealSenseFrames();
    found_.pairs = core::associateByStamp(stampsOf(found_.colors), stampsOf(found_.depths));
    if (found_.pairs.empty()) failWithoutPairs(file);
    return std::move(found_);
  }

 private:
  [[nodiscard]] bool isText(std::size_t topic) const { return bag_.topics()[topic].type == "std_msgs/String"; }

  static bool isAmong(const std::vector<std::size_t>& topics, std::size_t topic) {
    return std::find(topics.begin(), topics.end(), topic) != topics.end();
  }

  static void addImage(std::vector<BagMessage>& images, std::string& frame, const BagMessage& stamped,
                       const bags::Header& header) {
    if (images.empty()) frame = header.frame;
    images.push_back(stamped);
  }

  /// RealSense tells how a point of the device is seen by the stream, one for all streams of a device: what
  /// librealsense's recorder writes (ros_writer::write_extrinsics) leads from the stream of reference to that at hand
  /// (device::get_extrinsics), and its player takes it so (playback_device::calc_extrinsic: to * inverse(from)).
  void addPlace(std::size_t topic, const Eigen::Isometry3d& T_stream_device) {
    const auto add = [&](std::size_t images) {
      const std::string stream = realSenseStream(bag_.topics()[images].name);
      bags::Transform place;
      place.header.frame =
          bag_.topics()[topic].name.substr(stream.size()) + " of " + stream.substr(0, stream.find('/', 1));
      place.child = stream;
      place.T_parent_child = T_stream_device.inverse();
      found_.transforms.add(place);
    };
    if (topic == streams_.colorPlace) add(streams_.color);
    if (topic == streams_.depthPlace) add(streams_.depth);
  }

  /// It calls the frames of all its images "0".
  void nameRealSenseFrames() {
    if (streams_.colorPlace) found_.colorFrame = realSenseStream(bag_.topics()[streams_.color].name);
    if (streams_.depthPlace) found_.depthFrame = realSenseStream(bag_.topics()[streams_.depth].name);
  }

  /// One topic may be the calibration of both.
  void lookAtInfo(std::size_t topic, const bags::CameraInfo& info) {
    const auto keep = [&](std::optional<bags::CameraInfo>& first) {
      if (!first) first = info;
      const bool isSame = first->k == info.k && first->d == info.d && first->p == info.p;
      if (!isSame) found_.infoChanges = true;
    };
    if (topic == streams_.colorInfo) keep(found_.colorInfo);
    if (topic == streams_.depthInfo) keep(found_.depthInfo);
  }

  void takeTimesOfRecording(std::vector<BagMessage>& messages) const {
    for (BagMessage& message : messages) {
      message.stamp_s = core::secondsOf(bag_.entries()[message.entry].logged_ns);
    }
  }

  [[noreturn]] void failWithoutPairs(const std::string& file) const {
    const std::string color = bag_.topics()[streams_.color].name;
    const std::string depth = bag_.topics()[streams_.depth].name;
    if (found_.colors.empty() || found_.depths.empty()) {
      throw core::InputError(file + ": no message of " + (found_.colors.empty() ? color : depth) + " can be read");
    }
    throw core::InputError(file + ": no image of " + color + " is within 0.02 s of one of " + depth +
                           ": the first were taken at " + textOf(found_.colors.front().stamp_s) + " s and " +
                           textOf(found_.depths.front().stamp_s) +
                           " s; choose topics of one camera with --color and --depth, whose drivers use one clock");
  }

  bags::BagReader& bag_;
  const BagStreams& streams_;
  BagSurvey found_;
};

}  // namespace

std::string nameOf(const bags::BagReader& bag, std::size_t entry) {
  const bags::Entry& about = bag.entries()[entry];
  return "topic " + bag.topics()[about.topic].name + ", message recorded at " +
         textOf(core::secondsOf(about.logged_ns)) + " s";
}

BagSurvey survey(bags::BagReader& bag, const BagStreams& streams, const std::string& file, DamageLog& damage) {
  Surveyor surveyor(bag, streams);
  for (std::size_t entry = 0; entry < bag.entries().size(); ++entry) {
    try {
      surveyor.look(entry);
    } catch (const bags::BagDamage& trouble) {
      damage.add(trouble.event(),
                 file + ": " + nameOf(bag, entry) + ": " + trouble.what() + "; it is left out, as are others like it");
    }
  }
  return surveyor.finish(file);
}

}  // namespace wardslam::sources

#pragma once

#include <string>
#include <vector>

#include "bags/bag_writing.h"
#include "wardslam/bags/bag_reader.h"

namespace wardslam::test {

/// A recording of ROS 1 made in memory.
class FakeBag : public bags::BagReader {
 public:
  void add(const std::string& topic, const std::string& type, double stamp_s, const bags::Bytes& message) {
    std::size_t index = 0;
    while (index < topics_.size() && topics_[index].name != topic) ++index;
    if (index == topics_.size()) topics_.push_back({topic, type, bags::Wire::Ros1, 0});
    ++topics_[index].messages;
    entries_.push_back({index, static_cast<std::int64_t>(stamp_s * 1e9)});
    messages_.push_back(message);
  }

  void addImage(const std::string& topic, const std::string& encoding, double stamp_s,
                const std::string& frame = "camera") {
    const std::uint32_t step = encoding == "rgb8"                            ? 3
                               : encoding == "32FC1"                         ? 4
                               : encoding == "16UC1" || encoding == "mono16" ? 2
                                                                             : 1;
    add(topic, "sensor_msgs/Image", stamp_s,
        header(stamp_s, frame)
            .number<std::uint32_t>(1)
            .number<std::uint32_t>(1)
            .text(encoding)
            .number<std::uint8_t>(0)
            .number(step)
            .text(std::string(step, '\1'))
            .bytes());
  }

  void addCompressed(const std::string& topic, const std::string& format, double stamp_s) {
    add(topic, "sensor_msgs/CompressedImage", stamp_s, header(stamp_s, "camera").text(format).text("?").bytes());
  }

  void addInfo(const std::string& topic, double stamp_s, double focal_px = 500.0) {
    BytesMaker message = header(stamp_s, "camera");
    message.number<std::uint32_t>(480).number<std::uint32_t>(640).text("plumb_bob").number<std::uint32_t>(0);
    for (const double k : {focal_px, 0.0, 320.0, 0.0, focal_px, 240.0, 0.0, 0.0, 1.0}) message.number(k);
    for (int i = 0; i < 9 + 12; ++i) message.number(0.0);
    for (int i = 0; i < 6; ++i) message.number<std::uint32_t>(0);
    message.number<std::uint8_t>(0);
    add(topic, "sensor_msgs/CameraInfo", stamp_s, message.bytes());
  }

  /// As RealSense's own recorder writes a stream: where it sits, and images whose frame is called "0".
  void addRealSense(const std::string& stream, const std::string& encoding, double focal_px, double x_m) {
    addInfo(stream + "/info/camera_info", 0.0, focal_px);
    BytesMaker place;
    for (const double number : {x_m, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}) place.number(number);
    add(stream + "/tf/0", "geometry_msgs/Transform", 0.0, place.bytes());
    addImage(stream + "/image/data", encoding, 10.0, "0");
  }

  /// As it writes a stream into recordings of ROS 2: calibration and place as text.
  void addRealSenseText(const std::string& stream, const std::string& encoding, const std::string& place) {
    const std::string type = "std_msgs/String";
    add(stream + "/camera_info", type, 0.0,
        BytesMaker()
            .text("width=640;height=480;fx=500;ppx=320;fy=500;ppy=240;model=Brown Conrady;coeffs=0,0,0,0,0")
            .bytes());
    add(stream + "/tf/ref_0", type, 0.0, BytesMaker().text(place).bytes());
    addImage(stream + "/image/data", encoding, 10.0, stream.substr(stream.find_last_of('/') + 1));
  }

  void addText(const std::string& topic, const std::string& text) {
    add(topic, "std_msgs/String", 0.0, BytesMaker().text(text).bytes());
  }

  void addNumber(const std::string& topic, float number) {
    add(topic, "std_msgs/Float32", 0.0, BytesMaker().number(number).bytes());
  }

  [[nodiscard]] bags::Bytes read(std::size_t entry) override { return messages_.at(entry); }

 private:
  static BytesMaker header(double stamp_s, const std::string& frame) {
    const auto seconds = static_cast<std::uint32_t>(stamp_s);
    BytesMaker message;
    message.number<std::uint32_t>(0).number(seconds);
    message.number(static_cast<std::uint32_t>((stamp_s - seconds) * 1e9 + 0.5)).text(frame);
    return message;
  }

  std::vector<bags::Bytes> messages_;
};

}  // namespace wardslam::test

/// An OpenNI2 driver without a camera: it shows the images of a folder. $WARDSLAM_VIRTUAL_CAMERA names its settings
/// (camera_settings.h). Unplugging is real: OpenNI2 is told that the device has gone, and frames stop.

// The driver interface leaves these two to the driver.
#define XN_NEW(Type, ...) new Type(__VA_ARGS__)
#define XN_DELETE(pointer) delete (pointer)

#include <Driver/OniDriverAPI.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <set>
#include <thread>

#include "camera_settings.h"
#include "image_loop.h"

namespace wardslam::test {
namespace {

constexpr const char* kUri = "virtual/1";

std::filesystem::path settingsFile() {
  const char* file = std::getenv("WARDSLAM_VIRTUAL_CAMERA");
  return file == nullptr ? "" : file;
}

template <class Value>
OniStatus give(const Value& value, void* data, int* size) {
  if (*size != static_cast<int>(sizeof(Value))) return ONI_STATUS_BAD_PARAMETER;
  std::memcpy(data, &value, sizeof(Value));
  return ONI_STATUS_OK;
}

class VirtualStream : public oni::driver::StreamBase {
 public:
  VirtualStream(OniSensorType type, const CameraSettings& settings) : type_(type), settings_(settings) {}

  [[nodiscard]] OniVideoMode mode() const {
    const auto format = type_ == ONI_SENSOR_DEPTH ? ONI_PIXEL_FORMAT_DEPTH_1_MM : ONI_PIXEL_FORMAT_RGB888;
    return {format, settings_.mode_width_px, settings_.mode_height_px, 30};
  }

  OniStatus start() override {
    if (type_ == ONI_SENSOR_IR) return ONI_STATUS_ERROR;  // as on a device that cannot show colour and infrared at once
    isStarted_ = true;
    return ONI_STATUS_OK;
  }
  void stop() override { isStarted_ = false; }

  int getRequiredFrameSize() override { return settings_.mode_width_px * settings_.mode_height_px * bytesPerPixel(); }

  OniBool isPropertySupported(int id) override {
    return static_cast<OniBool>(id == ONI_STREAM_PROPERTY_VIDEO_MODE || id == ONI_STREAM_PROPERTY_MIRRORING ||
                                id == ONI_STREAM_PROPERTY_HORIZONTAL_FOV || id == ONI_STREAM_PROPERTY_VERTICAL_FOV);
  }
  OniStatus getProperty(int id, void* data, int* size) override {
    switch (id) {
      case ONI_STREAM_PROPERTY_VIDEO_MODE:
        return give(mode(), data, size);
      case ONI_STREAM_PROPERTY_MIRRORING:
        return give(OniBool{0}, data, size);
      case ONI_STREAM_PROPERTY_HORIZONTAL_FOV:
        return give(fieldOfView_rad(settings_.mode_width_px), data, size);
      case ONI_STREAM_PROPERTY_VERTICAL_FOV:
        return give(fieldOfView_rad(settings_.mode_height_px), data, size);
      default:
        return ONI_STATUS_NOT_SUPPORTED;
    }
  }
  OniStatus setProperty(int id, const void* /*data*/, int /*size*/) override {
    return isPropertySupported(id) != 0 ? ONI_STATUS_OK : ONI_STATUS_NOT_SUPPORTED;
  }

  void show(const ImageLoop::Images& images, int index, std::uint64_t stamp_us) {
    if (!isStarted_) return;
    const cv::Mat& image = type_ == ONI_SENSOR_DEPTH ? images.depth_mm : images.color_rgb;
    OniFrame* frame = getServices().acquireFrame();
    if (frame == nullptr) return;
    const auto bytes = image.total() * image.elemSize();
    if (bytes <= static_cast<std::size_t>(frame->dataSize)) {
      std::memcpy(frame->data, image.data, bytes);
      frame->videoMode = mode();
      frame->sensorType = type_;
      frame->width = image.cols;
      frame->height = image.rows;
      frame->stride = image.cols * bytesPerPixel();
      frame->croppingEnabled = 0;
      frame->cropOriginX = frame->cropOriginY = 0;
      frame->frameIndex = index;
      frame->timestamp = stamp_us;
      raiseNewFrame(frame);
    }
    getServices().releaseFrame(frame);
  }

 private:
  [[nodiscard]] int bytesPerPixel() const { return type_ == ONI_SENSOR_DEPTH ? 2 : 3; }
  [[nodiscard]] float fieldOfView_rad(int size_px) const {
    return static_cast<float>(2.0 * std::atan(0.5 * size_px / settings_.focal_length_px));
  }

  OniSensorType type_;
  CameraSettings settings_;
  std::atomic<bool> isStarted_{false};
};

class VirtualDevice : public oni::driver::DeviceBase {
 public:
  explicit VirtualDevice(CameraSettings settings)
      : settings_(std::move(settings)), images_(settings_.folder), player_([this] { play(); }) {
    constexpr std::array kTypes = {ONI_SENSOR_COLOR, ONI_SENSOR_DEPTH, ONI_SENSOR_IR};
    for (std::size_t i = 0; i < kTypes.size(); ++i) {
      modes_[i] = VirtualStream(kTypes[i], settings_).mode();
      sensors_[i] = {kTypes[i], 1, &modes_[i]};
    }
  }
  ~VirtualDevice() override {
    isClosing_ = true;
    player_.join();
  }
  VirtualDevice(const VirtualDevice&) = delete;
  VirtualDevice& operator=(const VirtualDevice&) = delete;

  OniStatus getSensorInfoList(OniSensorInfo** sensors, int* count) override {
    *sensors = sensors_.data();
    *count = settings_.infrared == CameraSettings::Infrared::Absent ? 2 : 3;
    return ONI_STATUS_OK;
  }
  oni::driver::StreamBase* createStream(OniSensorType type) override {
    const std::lock_guard lock(mutex_);
    return *streams_.insert(new VirtualStream(type, settings_)).first;
  }
  void destroyStream(oni::driver::StreamBase* stream) override {
    const std::lock_guard lock(mutex_);
    streams_.erase(static_cast<VirtualStream*>(stream));
    delete stream;
  }
  OniStatus setProperty(int id, const void* /*data*/, int /*size*/) override {
    return id == ONI_DEVICE_PROPERTY_IMAGE_REGISTRATION ? ONI_STATUS_OK : ONI_STATUS_NOT_SUPPORTED;
  }
  OniBool isImageRegistrationModeSupported(OniImageRegistrationMode /*mode*/) override { return 1; }

 private:
  /// By the clock on the wall, so that the sequence goes on where a new process takes it up.
  void play() {
    using Clock = std::chrono::system_clock;
    while (!isClosing_) {
      const CameraSettings now = readCameraSettings(settingsFile());
      const std::chrono::duration<double> period(1.0 / now.rate_hz);
      const auto index = static_cast<std::uint64_t>(Clock::now().time_since_epoch() / period) + 1;
      const auto images = images_.at(index, {now.width_px, now.height_px});
      const auto due = std::chrono::duration_cast<Clock::duration>(static_cast<double>(index) * period);
      std::this_thread::sleep_until(Clock::time_point(due));
      if (now.state != CameraSettings::State::Plugged) continue;
      const auto stamp_us = std::chrono::duration_cast<std::chrono::microseconds>(due);
      const std::lock_guard lock(mutex_);
      for (VirtualStream* stream : streams_) {
        stream->show(images, static_cast<int>(index % (1U << 30U)), static_cast<std::uint64_t>(stamp_us.count()));
      }
    }
  }

  CameraSettings settings_;
  ImageLoop images_;
  std::array<OniVideoMode, 3> modes_{};
  std::array<OniSensorInfo, 3> sensors_{};
  std::mutex mutex_;
  std::set<VirtualStream*> streams_;
  std::atomic<bool> isClosing_{false};
  std::thread player_;
};

class VirtualDriver : public oni::driver::DriverBase {
 public:
  using DriverBase::DriverBase;

  OniStatus initialize(oni::driver::DeviceConnectedCallback connected,
                       oni::driver::DeviceDisconnectedCallback disconnected,
                       oni::driver::DeviceStateChangedCallback stateChanged, void* cookie) override {
    DriverBase::initialize(connected, disconnected, stateChanged, cookie);
    follow();
    watcher_ = std::thread([this] { watch(); });
    return ONI_STATUS_OK;
  }
  oni::driver::DeviceBase* deviceOpen(const char* /*uri*/, const char* /*mode*/) override {
    return new VirtualDevice(readCameraSettings(settingsFile()));
  }
  void deviceClose(oni::driver::DeviceBase* device) override { delete device; }
  void shutdown() override {
    isClosing_ = true;
    if (watcher_.joinable()) watcher_.join();
  }

 private:
  void follow() {
    const bool isPlugged = readCameraSettings(settingsFile()).state != CameraSettings::State::Unplugged;
    if (isPlugged == isConnected_) return;
    isConnected_ = isPlugged;
    OniDeviceInfo info{};
    std::strncpy(info.uri, kUri, sizeof(info.uri) - 1);
    std::strncpy(info.vendor, "WardSLAM", sizeof(info.vendor) - 1);
    std::strncpy(info.name, "virtual camera", sizeof(info.name) - 1);
    isPlugged ? deviceConnected(&info) : deviceDisconnected(&info);
  }
  void watch() {
    while (!isClosing_) {
      follow();
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }

  bool isConnected_ = false;
  std::atomic<bool> isClosing_{false};
  std::thread watcher_;
};

}  // namespace
}  // namespace wardslam::test

ONI_EXPORT_DRIVER(wardslam::test::VirtualDriver)

#include <fstream>
#include <iomanip>
#include <sstream>

#include "output/png.h"
#include "output/recording.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/options.h"
#include "wardslam/sources/rgbd_camera.h"

namespace wardslam::synth {
namespace {

namespace fs = std::filesystem;

constexpr double kUnitsPerMetre = 5000.0;
constexpr double kFarthest_m = 65535 / kUnitsPerMetre;

/// A list that grows line by line.
class List {
 public:
  List(const fs::path& file, const std::string& head) : file_(file), out_(file, std::ios::binary) { line(head); }
  void line(const std::string& text) { out_ << text << "\n"; }
  void finish() {
    out_.flush();
    if (!out_) throw core::InputError(file_.string() + ": could not be written; is the disk full?");
  }

 private:
  fs::path file_;
  std::ofstream out_;
};

std::string numbers(std::initializer_list<double> values) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(9);
  for (const double value : values) text << " " << value;
  return text.str();
}

/// Makes FOLDER.partial; returns its name.
fs::path prepared(const fs::path& folder) {
  if (fs::exists(folder) && !(fs::is_directory(folder) && fs::is_empty(folder))) {
    throw core::InputError(folder.string() + ": is there already; give another -o or remove it");
  }
  const fs::path partial = folder.string() + ".partial";
  std::error_code error;
  fs::remove_all(partial, error);
  for (const char* images : {"rgb", "depth"}) {
    fs::create_directories(partial / images, error);
    if (error) throw core::InputError(partial.string() + ": cannot be made: " + error.message());
  }
  return partial;
}

class TumRecording : public Recording {
 public:
  TumRecording(const fs::path& folder, const SequenceCamera& camera)
      : folder_(folder),
        partial_(prepared(folder)),
        colors_(partial_ / "rgb.txt", "# color images\n# timestamp filename"),
        depths_(partial_ / "depth.txt", "# depth maps\n# timestamp filename"),
        both_(partial_ / "associations.txt", "# timestamp color timestamp depth") {
    writeFile("camera.yaml", core::writeOptions(sources::RgbdCamera{camera.model, kUnitsPerMetre, camera.rate_hz}));
  }
  ~TumRecording() override {
    std::error_code ignored;
    fs::remove_all(partial_, ignored);  // there only when it was not finished
  }

  [[nodiscard]] std::vector<Bytes> encode(const SequenceFrame& frame) const override {
    cv::Mat depth;
    frame.depth_m.convertTo(depth, CV_16U, kUnitsPerMetre);
    depth.setTo(0, frame.depth_m > kFarthest_m);
    return {picturePng(frame.color_bgr), picturePng(depth)};
  }

  void writeFrame(double stamp_s, const std::vector<Bytes>& parts) override {
    const std::string stamp = stampText(stamp_s);
    const std::string color = stamp + " rgb/" + stamp + ".png";
    const std::string depth = stamp + " depth/" + stamp + ".png";
    writeBytes(partial_ / "rgb" / (stamp + ".png"), parts.at(0));
    writeBytes(partial_ / "depth" / (stamp + ".png"), parts.at(1));
    colors_.line(color);
    depths_.line(depth);
    both_.line(color + " " + depth);
  }
  void writeOdometry(double stamp_s, const OdometryReading& reading) override {
    if (!odometry_) odometry_.emplace(partial_ / "odometry.txt", "# timestamp x_m y_m heading_rad");
    odometry_->line(stampText(stamp_s) + numbers({reading.pose.x(), reading.pose.y(), reading.pose.z()}));
  }
  void writeImu(double stamp_s, const ImuReading& reading) override {
    if (!imu_)
      imu_.emplace(partial_ / "imu.txt", "# timestamp wx wy wz (rad/s) ax ay az (m/s^2), camera's sensor frame");
    const auto& w = reading.angularVelocity;
    const auto& a = reading.specificForce;
    imu_->line(stampText(stamp_s) + numbers({w.x(), w.y(), w.z(), a.x(), a.y(), a.z()}));
  }

  void commit() override {
    for (List* list : {&colors_, &depths_, &both_}) list->finish();
    if (odometry_) odometry_->finish();
    if (imu_) imu_->finish();
    std::error_code error;
    fs::remove(folder_, error);  // an empty one
    fs::rename(partial_, folder_, error);
    if (error) throw core::InputError(folder_.string() + ": cannot be made: " + error.message());
  }

 private:
  void writeFile(const char* name, const std::string& text) const {
    writeBytes(partial_ / name, Bytes(text.begin(), text.end()));
  }

  fs::path folder_;
  fs::path partial_;
  List colors_;
  List depths_;
  List both_;
  std::optional<List> odometry_;
  std::optional<List> imu_;
};

}  // namespace

std::unique_ptr<Recording> makeTumRecording(const fs::path& folder, const SequenceCamera& camera) {
  return std::make_unique<TumRecording>(folder, camera);
}

}  // namespace wardslam::synth

#include "sequence_writer.h"

#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationStereoImages.h>

#include <iomanip>
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <sstream>
#include <utility>

#include "wardslam/core/atomic_file.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/sources/rawlog_writer.h"
#include "wardslam/storage/map_export.h"
#include "wardslam/storage/tum_trajectory.h"

namespace wardslam::synth {
namespace fs = std::filesystem;
namespace {

constexpr double kRangeUnits_m = 0.001;
constexpr double kCameraHeight_m = 1.1;
constexpr const char* kGroundTruth = "groundtruth.txt";  // until it gets its name beside the rawlog
constexpr const char* kLabelFolders[] = {"masks", "instances", "dynamic"};

fs::path withSuffix(const fs::path& rawlog, const std::string& suffix) {
  return rawlog.parent_path() / (rawlog.stem().string() + suffix);
}

fs::path partial(const fs::path& path) { return path.string() + ".partial"; }

void giveName(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) throw core::InputError(to.string() + ": cannot be replaced: " + error.message());
}

/// Class id of every instance id, for cv::LUT-like use.
std::vector<core::ClassId> classTable(const std::vector<Label>& labels) {
  std::vector<core::ClassId> classOf(1, 0);
  for (const Label& label : labels) {
    if (classOf.size() <= label.id) classOf.resize(label.id + 1U, 0);
    classOf[label.id] = label.classId;
  }
  return classOf;
}

cv::Mat classMask(const cv::Mat& instanceIds, const std::vector<core::ClassId>& classOf) {
  cv::Mat mask(instanceIds.size(), CV_8UC1);
  mask.forEach<std::uint8_t>(
      [&](std::uint8_t& out, const int* at) { out = classOf.at(instanceIds.at<std::uint16_t>(at[0], at[1])); });
  return mask;
}

std::string classesText(const std::vector<Label>& labels) {
  std::map<core::ClassId, std::string> names;
  for (const Label& label : labels) {
    if (label.classId != 0) names[label.classId] = label.className;
  }
  std::ostringstream text;
  for (const auto& [id, name] : names) text << static_cast<int>(id) << " " << name << "\n";
  return text.str();
}

std::string objectsText(const std::vector<StaticObject>& objects) {
  std::ostringstream text;
  text << "instance_id,name,class_id,class_name,cx,cy,cz,xmin,ymin,zmin,xmax,ymax,zmax,static_from_s\n"
       << std::fixed << std::setprecision(3);
  for (const StaticObject& object : objects) {
    text << object.label.id << "," << object.label.name << "," << static_cast<int>(object.label.classId) << ","
         << object.label.className;
    for (const Eigen::Vector3f& p : {Eigen::Vector3f(object.box_m.center()), object.box_m.min(), object.box_m.max()}) {
      text << "," << p.x() << "," << p.y() << "," << p.z();
    }
    text << "," << object.restsFrom_s << "\n";
  }
  return text.str();
}

/// Makes the partial folder, empty but for the folders of images; returns the name it will have.
fs::path prepareLabelsFolder(const fs::path& finalFolder) {
  if (fs::exists(finalFolder) && !fs::exists(finalFolder / "objects.csv")) {
    throw core::InputError(finalFolder.string() + ": is there already and was not made by this program; move it away");
  }
  std::error_code error;
  fs::remove_all(partial(finalFolder), error);
  for (const char* folder : kLabelFolders) {
    fs::create_directories(partial(finalFolder) / folder, error);
    if (error) throw core::InputError(partial(finalFolder).string() + ": cannot be created: " + error.message());
  }
  return finalFolder;
}

std::string stampText(double stamp_s) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(6) << stamp_s;
  return text.str();
}

void writePng(const fs::path& file, const cv::Mat& image) {
  // Run-length matching is what suits label images, and it is fast.
  const std::vector<int> parameters = {cv::IMWRITE_PNG_COMPRESSION, 1, cv::IMWRITE_PNG_STRATEGY,
                                       cv::IMWRITE_PNG_STRATEGY_RLE};
  if (!cv::imwrite(file.string(), image, parameters)) {
    throw core::InputError(file.string() + ": could not be written; is the disk full?");
  }
}

mrpt::obs::CObservation3DRangeScan toObservation(const SequenceFrame& frame, const mrpt::img::TCamera& camera) {
  mrpt::obs::CObservation3DRangeScan scan;
  scan.sensorLabel = "RGBD";
  scan.timestamp = core::toMrptTime(frame.stamp_s);
  scan.sensorPose = mrpt::poses::CPose3D(0, 0, kCameraHeight_m, 0, 0, 0);
  scan.range_is_depth = true;
  scan.maxRange = 8.0F;
  scan.stdError = 0.01F;
  scan.cameraParams = camera;
  scan.cameraParamsIntensity = camera;
  scan.relativePoseIntensityWRTDepth = mrpt::poses::CPose3D(core::toMrpt(core::T_sensor_cam()));
  scan.intensityImageChannel = mrpt::obs::CObservation3DRangeScan::CH_VISIBLE;
  scan.hasIntensityImage = true;
  scan.intensityImage = mrpt::img::CImage(frame.color_bgr, mrpt::img::SHALLOW_COPY);
  scan.hasRangeImage = true;
  scan.rangeUnits = static_cast<float>(kRangeUnits_m);
  scan.rangeImage.resize(frame.depth_m.rows, frame.depth_m.cols);
  cv::Mat range(frame.depth_m.size(), CV_16UC1, scan.rangeImage.data());
  frame.depth_m.convertTo(range, CV_16U, 1.0 / kRangeUnits_m);
  return scan;
}

mrpt::obs::CObservationStereoImages toStereoObservation(const SequenceFrame& frame, const mrpt::img::TCamera& camera,
                                                        double baseline_m) {
  mrpt::obs::CObservationStereoImages pair;
  pair.sensorLabel = "STEREO";
  pair.timestamp = core::toMrptTime(frame.stamp_s);
  const mrpt::poses::CPose3D T_base_sensor(0, 0, kCameraHeight_m, 0, 0, 0);
  pair.cameraPose = mrpt::poses::CPose3DQuat(T_base_sensor + core::toMrpt(core::T_sensor_cam()));
  pair.rightCameraPose = mrpt::poses::CPose3DQuat(mrpt::poses::CPose3D(baseline_m, 0, 0, 0, 0, 0));
  pair.leftCamera = pair.rightCamera = camera;
  pair.imageLeft = mrpt::img::CImage(frame.color_bgr, mrpt::img::SHALLOW_COPY);
  pair.imageRight = mrpt::img::CImage(frame.right_bgr, mrpt::img::SHALLOW_COPY);
  pair.hasImageRight = true;
  return pair;
}

}  // namespace

fs::path groundTruthFile(const fs::path& rawlog) { return withSuffix(rawlog, ".groundtruth.txt"); }
fs::path labelsFolder(const fs::path& rawlog) { return withSuffix(rawlog, "_labels"); }

struct SequenceWriter::Impl {
  Impl(fs::path rawlogFile, const SequenceCamera& sequenceCamera, std::vector<Label> allLabels)
      : rawlog(std::move(rawlogFile)),
        camera(core::toMrpt(sequenceCamera.model)),
        stereoBaseline_m(sequenceCamera.stereoBaseline_m),
        labels(std::move(allLabels)),
        classOf(classTable(labels)),
        observations(rawlog, sources::ImageCoding::Jpeg),
        labelled(prepareLabelsFolder(labelsFolder(rawlog))),
        groundTruth(partial(labelled) / kGroundTruth) {}

  ~Impl() {
    std::error_code ignored;
    fs::remove_all(partial(labelled), ignored);  // there only when it was not finished
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  fs::path rawlog;
  mrpt::img::TCamera camera;
  std::optional<double> stereoBaseline_m;
  std::vector<Label> labels;
  std::vector<core::ClassId> classOf;
  sources::RawlogWriter observations;
  fs::path labelled;
  storage::TumTrajectoryWriter groundTruth;
};

SequenceWriter::SequenceWriter(const fs::path& rawlog, const SequenceCamera& camera, std::vector<Label> labels)
    : impl_(std::make_unique<Impl>(rawlog, camera, std::move(labels))) {}

SequenceWriter::~SequenceWriter() = default;

void SequenceWriter::write(const SequenceFrame& frame) {
  if (impl_->stereoBaseline_m) {
    impl_->observations.write(toStereoObservation(frame, impl_->camera, *impl_->stereoBaseline_m));
  } else {
    impl_->observations.write(toObservation(frame, impl_->camera));
  }
  impl_->groundTruth.write({frame.stamp_s, frame.T_world_cam});

  const std::string name = stampText(frame.stamp_s) + ".png";
  const fs::path folder = partial(impl_->labelled);
  writePng(folder / "masks" / name, classMask(frame.instanceIds, impl_->classOf));
  writePng(folder / "instances" / name, frame.instanceIds);
  writePng(folder / "dynamic" / name, frame.dynamic);
}

void SequenceWriter::finish(const std::vector<StaticObject>& objects, const mapping::FloorPlan& floor,
                            const std::function<void(const fs::path&)>& writeMore) {
  const fs::path folder = partial(impl_->labelled);
  core::writeFileAtomically(folder / "classes.txt", classesText(impl_->labels));
  core::writeFileAtomically(folder / "objects.csv", objectsText(objects));
  mapping::SemanticMap map;
  map.floorPlan = floor;
  storage::exportRosMap(map, folder / "floor.yaml");
  writeMore(folder);
  impl_->groundTruth.finish();
  giveName(folder / kGroundTruth, groundTruthFile(impl_->rawlog));
  std::error_code error;
  fs::remove_all(impl_->labelled, error);
  giveName(folder, impl_->labelled);
  impl_->observations.commit();
}

}  // namespace wardslam::synth

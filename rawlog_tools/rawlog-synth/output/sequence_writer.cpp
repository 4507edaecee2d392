#include "output/sequence_writer.h"

#include <algorithm>
#include <iomanip>
#include <map>
#include <sstream>
#include <utility>

#include "output/png.h"
#include "wardslam/core/atomic_file.h"
#include "wardslam/core/errors.h"
#include "wardslam/exchange/map_export.h"
#include "wardslam/exchange/tum_trajectory.h"

namespace wardslam::synth {
namespace fs = std::filesystem;
namespace {

constexpr const char* kGroundTruth = "groundtruth.txt";  // until it gets its name beside the rawlog
constexpr const char* kLabelFolders[] = {"masks", "instances", "dynamic"};

fs::path withSuffix(const fs::path& file, const std::string& suffix) {
  const bool isRawlog = file.extension() == ".rawlog";
  return file.parent_path() / ((isRawlog ? file.stem() : file.filename()).string() + suffix);
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
  const bool roomsKnown = std::any_of(objects.begin(), objects.end(), [](const auto& o) { return o.room.has_value(); });
  const bool storeysKnown =
      std::any_of(objects.begin(), objects.end(), [](const auto& o) { return o.storey.has_value(); });
  text << "instance_id,name,class_id,class_name,cx,cy,cz,xmin,ymin,zmin,xmax,ymax,zmax,static_from_s"
       << (roomsKnown ? ",identity,room" : "") << (storeysKnown ? ",storey\n" : "\n") << std::fixed
       << std::setprecision(3);
  for (const StaticObject& object : objects) {
    text << object.label.id << "," << object.label.name << "," << static_cast<int>(object.label.classId) << ","
         << object.label.className;
    for (const Eigen::Vector3f& p : {Eigen::Vector3f(object.box_m.center()), object.box_m.min(), object.box_m.max()}) {
      text << "," << p.x() << "," << p.y() << "," << p.z();
    }
    text << "," << object.restsFrom_s;
    if (roomsKnown) text << "," << object.label.id << "," << object.room.value_or("");
    if (storeysKnown) text << "," << object.storey.value_or(0);
    text << "\n";
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

}  // namespace

fs::path groundTruthFile(const OutputOptions& output) {
  return output.isTumFolder ? output.file / "groundtruth.txt" : withSuffix(output.file, ".groundtruth.txt");
}
fs::path labelsFolder(const OutputOptions& output) { return withSuffix(output.file, "_labels"); }

struct SequenceWriter::Impl {
  Impl(const OutputOptions& outputOptions, const SequenceCamera& camera, std::vector<Label> allLabels)
      : output(outputOptions),
        labels(std::move(allLabels)),
        classOf(classTable(labels)),
        recording(output.isTumFolder ? makeTumRecording(output.file, camera)
                                     : makeRawlogRecording(output.file, camera)),
        labelled(prepareLabelsFolder(labelsFolder(output))),
        groundTruth(partial(labelled) / kGroundTruth) {}

  ~Impl() {
    std::error_code ignored;
    fs::remove_all(partial(labelled), ignored);  // there only when it was not finished
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  OutputOptions output;
  std::vector<Label> labels;
  std::vector<core::ClassId> classOf;
  std::unique_ptr<Recording> recording;
  fs::path labelled;
  exchange::TumTrajectoryWriter groundTruth;
};

SequenceWriter::SequenceWriter(const OutputOptions& output, const SequenceCamera& camera, std::vector<Label> labels)
    : impl_(std::make_unique<Impl>(output, camera, std::move(labels))) {}

SequenceWriter::~SequenceWriter() = default;

Recording& SequenceWriter::recording() { return *impl_->recording; }

EncodedFrame SequenceWriter::encode(const SequenceFrame& frame) const {
  return {
      frame.stamp_s,
      frame.T_world_cam,
      impl_->recording->encode(frame),
      {labelPng(classMask(frame.instanceIds, impl_->classOf)), labelPng(frame.instanceIds), labelPng(frame.dynamic)}};
}

void SequenceWriter::write(const EncodedFrame& frame) {
  impl_->groundTruth.write({frame.stamp_s, frame.T_world_cam});
  if (frame.recorded.empty()) return;
  impl_->recording->writeFrame(frame.stamp_s, frame.recorded);
  const std::string name = stampText(frame.stamp_s) + ".png";
  for (std::size_t i = 0; i < frame.labels.size(); ++i) {
    writeBytes(partial(impl_->labelled) / kLabelFolders[i] / name, frame.labels[i]);
  }
}

void SequenceWriter::finish(const std::vector<StaticObject>& objects, const mapping::FloorPlan& floor,
                            const std::function<void(const fs::path&)>& writeMore) {
  const fs::path folder = partial(impl_->labelled);
  core::writeFileAtomically(folder / "classes.txt", classesText(impl_->labels));
  core::writeFileAtomically(folder / "objects.csv", objectsText(objects));
  mapping::SemanticMap map;
  map.floorPlan = floor;
  exchange::exportRosMap(map, folder / "floor.yaml");
  writeMore(folder);
  impl_->groundTruth.finish();
  if (impl_->output.isTumFolder) impl_->recording->commit();  // where the ground truth goes into
  giveName(folder / kGroundTruth, groundTruthFile(impl_->output));
  std::error_code error;
  fs::remove_all(impl_->labelled, error);
  giveName(folder, impl_->labelled);
  if (!impl_->output.isTumFolder) impl_->recording->commit();
}

}  // namespace wardslam::synth

#include "wardslam/segmentation/yolo_segmenter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/core/version.hpp>
#include <opencv2/imgcodecs.hpp>

#include "segmentation/onnx_writer.h"
#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"

namespace wardslam::segmentation {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::ThrowsMessage;

const fs::path kShared(WARDSLAM_SHARED_DIR);

class YoloSegmenterTest : public ::testing::Test {
 protected:
  static void open(const fs::path& file) {
    YoloOptions options;
    options.model = file.string();
    const YoloSegmenter segmenter(options);
  }

  /// Expects one sentence that begins with the file and has these parts.
  static void expectRefused(const fs::path& file, const std::string& part, const std::string& other = {}) {
    EXPECT_THAT([&] { open(file); },
                ThrowsMessage<core::InputError>(AllOf(::testing::StartsWith(file.string() + ": "), HasSubstr(part),
                                                      HasSubstr(other), Not(HasSubstr("\n")))));
  }

  test::TemporaryFolder folder_;
};

TEST_F(YoloSegmenterTest, RefusesAMissingFile) {
  EXPECT_THAT([] { open({}); }, ThrowsMessage<core::InputError>(HasSubstr("yolo.model")));
  expectRefused(folder_.path() / "missing.onnx", "cannot be opened");
  expectRefused(folder_.path(), "cannot be opened");
}

TEST_F(YoloSegmenterTest, RefusesWhatIsNotOnnx) {
  expectRefused(folder_.write("text.onnx", "this is text and not a network\n"), "not a complete ONNX file");
  expectRefused(folder_.write("empty.onnx", ""), "not a complete ONNX file");
  expectRefused(folder_.write("noise.onnx", std::string(4096, '\xa5')), "not a complete ONNX file");
}

TEST_F(YoloSegmenterTest, SaysHowToExportNetworksOfOtherLibraries) {
  const std::string rest(500, '\0');
  expectRefused(folder_.write("a.pt", "PK\x03\x04" + rest), "PyTorch", "yolo export model=a.pt format=onnx");
  expectRefused(folder_.write("a.tflite", std::string("\x1C\0\0\0TFL3", 8) + rest), "TensorFlow Lite", "as ONNX");
  expectRefused(folder_.write("a.engine", "ftrt" + rest), "TensorRT", "as ONNX");
  expectRefused(folder_.write("a.xml", "<?xml version=\"1.0\"?><net/>"), "OpenVINO", "as ONNX");
}

TEST_F(YoloSegmenterTest, RefusesATruncatedNetwork) {
  const fs::path whole = kShared / "models" / "yolov5n-seg_320x256.onnx";
  if (!fs::exists(whole)) GTEST_SKIP() << whole << " is absent";
  const std::string bytes = test::readText(whole);
  expectRefused(folder_.write("cut.onnx", bytes.substr(0, bytes.size() / 2)), "not a complete ONNX file");
  expectRefused(folder_.write("end.onnx", bytes.substr(0, bytes.size() - 100)), "not a complete ONNX file");
}

// What official YOLOv8-seg exports do: boxes times strides, where the strides lack the batch dimension.
TEST_F(YoloSegmenterTest, SaysWhichOpenCvAnOfficialYoloV8ExportNeeds) {
  if (CV_VERSION_MAJOR > 4 || CV_VERSION_MINOR >= 7) GTEST_SKIP() << "OpenCV " CV_VERSION " can run this";
  test::OnnxWriter onnx;
  onnx.addInput("images", {1, 3, 4, 8});
  onnx.addConstant("strides", {1, 8}, std::vector<float>(8, 8.0F));
  onnx.addNode("Mul", "/model.22/Mul_2", {"images", "strides"}, "output0");
  onnx.addOutput("output0");
  expectRefused(folder_.write("official.onnx", onnx.model()), "OpenCV " CV_VERSION " cannot run it",
                "OpenCV 4.7 or newer");
}

TEST_F(YoloSegmenterTest, NamesTheOperationThatCannotBeLoaded) {
  test::OnnxWriter onnx;
  onnx.addInput("images", {1, 3, 4, 8});
  onnx.addNode("Mystery", "/model.22/Mystery", {"images"}, "output0");
  onnx.addOutput("output0");
  const fs::path file = folder_.write("mystery.onnx", onnx.model());
  expectRefused(file, "Mystery", "OpenCV 4.7 or newer");
}

TEST_F(YoloSegmenterTest, RefusesANetworkOfAnotherKind) {
  test::OnnxWriter onnx;
  onnx.addInput("images", {1, 3, 16, 8});
  onnx.addNode("Relu", "relu", {"images"}, "output0");
  onnx.addOutput("output0");
  expectRefused(folder_.write("relu.onnx", onnx.model()), "[1,3,16,8]", "segmentation model");
}

TEST_F(YoloSegmenterTest, RefusesAnInputThatIsNoImageOrOfOpenSize) {
  for (const auto& shape : {std::vector<std::uint64_t>{1, 8}, std::vector<std::uint64_t>{1, 3, 0, 0}}) {
    test::OnnxWriter onnx;
    onnx.addInput("images", shape);
    onnx.addNode("Relu", "relu", {"images"}, "output0");
    onnx.addOutput("output0");
    const fs::path file = folder_.write("input.onnx", onnx.model());
    expectRefused(file, shape.size() == 2 ? "no image" : "export it with a fixed one");
  }
}

TEST_F(YoloSegmenterTest, NamesAnOpenSizeBeforeWhatCannotBeLoaded) {
  test::OnnxWriter onnx;
  onnx.addInput("images", {1, 3, 0, 0});
  onnx.addNode("Mystery", "mystery", {"images"}, "output0");
  onnx.addOutput("output0");
  expectRefused(folder_.write("open.onnx", onnx.model()), "leaves the size of its input open", "dynamic=False");
}

TEST_F(YoloSegmenterTest, NamesHalfFloatsBeforeWhatCannotBeLoaded) {
  test::OnnxWriter onnx;
  onnx.addInput("images", {1, 3, 64, 64}, test::OnnxWriter::ElementType::Float16);
  onnx.addNode("Mystery", "mystery", {"images"}, "output0");
  onnx.addOutput("output0");
  expectRefused(folder_.write("half.onnx", onnx.model()), "16-bit floating-point numbers", "half=False");
}

/// A network of 64x64 pixels with two classes that finds one thing of class 1, whatever it sees.
class MadeYolo {
 public:
  float confidence = 0.8F;
  std::string names;
  bool putsPrototypesFirst = false;
  bool hasThirdOutput = false;

  [[nodiscard]] std::string model() const {
    test::OnnxWriter onnx;
    onnx.addInput("images", {1, 3, 64, 64});
    if (putsPrototypesFirst) addPrototypes(onnx);
    addDetections(onnx);
    if (!putsPrototypesFirst) addPrototypes(onnx);
    if (hasThirdOutput) onnx.addFixedOutput("extra", "images", {1, 8, 8}, std::vector<float>(64, 0.0F));
    if (!names.empty()) onnx.addMetadata("names", names);
    return onnx.model();
  }

 private:
  static constexpr std::size_t kAnchors = 8 * 8 + 4 * 4 + 2 * 2;  // of strides 8, 16 and 32
  static constexpr std::size_t kAnchor = 7;

  /// Middle, size, two scores and one coefficient, each for all anchors.
  void addDetections(test::OnnxWriter& onnx) const {
    std::vector<float> values(7 * kAnchors, 0.0F);
    std::size_t row = 0;
    for (const float value : {25.0F, 32.0F, 30.0F, 24.0F, 0.0F, confidence, 10.0F}) {
      values[row++ * kAnchors + kAnchor] = value;
    }
    onnx.addFixedOutput("output0", "images", {1, 7, kAnchors}, values);
  }
  static void addPrototypes(test::OnnxWriter& onnx) {
    onnx.addFixedOutput("output1", "images", {1, 1, 16, 16}, std::vector<float>(256, 1.0F));
  }
};

class MadeYoloTest : public ::testing::Test {
 protected:
  [[nodiscard]] YoloSegmenter open() const {
    YoloOptions options;
    options.model = folder_.write("made.onnx", made_.model()).string();
    return YoloSegmenter(options, classes_);
  }
  [[nodiscard]] core::Segmentation segment() const {
    return open().segment({cv::Mat(64, 64, CV_8UC3, cv::Scalar::all(90)), 0.0}).segmentation;
  }
  void expectTheWheelchair() const {
    const auto found = segment();
    ASSERT_EQ(found.instances.size(), 1U);
    EXPECT_EQ(found.instances[0].classId, 105);  // of labels/hospital.yaml
    EXPECT_EQ(found.instances[0].box_px, cv::Rect(10, 20, 30, 24));
  }

  test::TemporaryFolder folder_;
  MadeYolo made_;
  fs::path classes_;
};

TEST_F(MadeYoloTest, TakesTheNamesOfClassesFromTheFile) {
  made_.names = "{0: 'person', 1: 'wheelchair'}";
  EXPECT_EQ(open().labelSpace().name(105), "wheelchair");
  expectTheWheelchair();
}

TEST_F(MadeYoloTest, TakesTheNamesThatAreGivenBeforeThoseOfTheFile) {
  made_.names = "{0: 'person', 1: 'bed'}";
  classes_ = folder_.write("two.yaml", "extends: hospital.yaml\nclasses: [person, wheelchair]\n");
  expectTheWheelchair();
}

TEST_F(MadeYoloTest, AsksForNamesWhereThereAreNone) {
  EXPECT_THAT([&] { (void)open(); },
              ThrowsMessage<core::InputError>(AllOf(HasSubstr("made.onnx: knows 2 classes"), HasSubstr("--classes"))));
}

TEST_F(MadeYoloTest, PassesOverAThirdOutputAndTakesAnyOrder) {
  made_.names = "{0: 'person', 1: 'wheelchair'}";
  made_.hasThirdOutput = true;
  expectTheWheelchair();
  made_.putsPrototypesFirst = true;
  expectTheWheelchair();
}

TEST_F(MadeYoloTest, RefusesAConfidenceAboveOne) {
  made_.names = "{0: 'person', 1: 'wheelchair'}";
  made_.confidence = 56.0F;
  EXPECT_THAT([&] { (void)segment(); },
              ThrowsMessage<core::InputError>(AllOf(HasSubstr("made.onnx: puts out"), HasSubstr("56"),
                                                    HasSubstr("above 1"), HasSubstr("another layout"))));
}

/// Intersection over union of what is called a person and what is one, per image with a large person.
std::vector<double> personOverlaps(YoloSegmenter& segmenter, const fs::path& sequence, std::size_t step) {
  std::vector<fs::path> images;
  for (const auto& entry : fs::directory_iterator(sequence / "rgb")) images.push_back(entry.path());
  std::sort(images.begin(), images.end());
  std::vector<double> overlaps;
  for (std::size_t i = 0; i < images.size(); i += step) {
    const fs::path mask = sequence / "masks" / images[i].filename().replace_extension(".png");
    const cv::Mat truth = cv::imread(mask.string(), cv::IMREAD_UNCHANGED) == 1;
    if (cv::countNonZero(truth) < 2500) continue;
    const auto result = segmenter.segment({cv::imread(images[i].string()), 0.0});
    const cv::Mat person = result.segmentation.classIds == 1;
    overlaps.push_back(static_cast<double>(cv::countNonZero(truth & person)) / cv::countNonZero(truth | person));
  }
  return overlaps;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0.0 : values[values.size() / 2];
}

class YoloOnRecordings : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!fs::exists(model()) || !fs::exists(kShared / "data")) GTEST_SKIP() << model() << " or recordings are absent";
    YoloOptions options;
    options.model = model().string();
    segmenter_ = std::make_unique<YoloSegmenter>(options);
  }
  [[nodiscard]] static fs::path model() { return kShared / "models" / GetParam(); }

  std::unique_ptr<YoloSegmenter> segmenter_;
};

TEST_P(YoloOnRecordings, FindsPeople) {
  EXPECT_EQ(segmenter_->inputSize_px(), cv::Size(320, 256));
  EXPECT_EQ(segmenter_->labelSpace().name(1), "person");
  const auto ward = personOverlaps(*segmenter_, kShared / "data" / "ward_walking", 20);
  EXPECT_GE(ward.size(), 10U);
  EXPECT_GE(median(ward), 0.8);
  // Lower: a real man in the picture is a person to the network, but not in the recorded masks.
  const auto walk = personOverlaps(*segmenter_, kShared / "data" / "rpy_walk", 10);
  EXPECT_GE(walk.size(), 10U);
  EXPECT_GE(median(walk), 0.65);
}

TEST_P(YoloOnRecordings, PutsOutTheSizeOfTheImageWhateverThatIs) {
  const fs::path image = kShared / "data" / "ward_walking" / "rgb" / "1700000005.000000.jpg";
  const cv::Mat whole = cv::imread(image.string());
  for (const cv::Rect& part : {cv::Rect(0, 0, 640, 480), cv::Rect(0, 0, 301, 480), cv::Rect(0, 100, 640, 77)}) {
    const auto result = segmenter_->segment({whole(part), 0.0});
    EXPECT_TRUE(result.events.empty());
    EXPECT_EQ(result.segmentation.classIds.size(), part.size());
    EXPECT_EQ(result.segmentation.instanceIds.size(), part.size());
  }
}

TEST_P(YoloOnRecordings, GivesTheSameMasksOnBothBackends) {
  YoloOptions options;
  options.model = model().string();
  std::unique_ptr<YoloSegmenter> other;
  try {
    other = std::make_unique<YoloSegmenter>(options, "", Backend::OnnxRuntime);
  } catch (const core::InputError& error) {
    GTEST_SKIP() << error.what();
  }
  for (const char* name : {"1700000003.000000.jpg", "1700000005.000000.jpg", "1700000007.000000.jpg"}) {
    const cv::Mat image = cv::imread((kShared / "data" / "ward_walking" / "rgb" / name).string());
    ASSERT_FALSE(image.empty()) << name;
    const auto one = segmenter_->segment({image, 0.0}).segmentation;
    const auto two = other->segment({image, 0.0}).segmentation;
    EXPECT_EQ(one.instances.size(), two.instances.size()) << name;
    EXPECT_LT(cv::countNonZero(one.classIds != two.classIds), 100) << name;  // sums are rounded in another order
  }
}

TEST_P(YoloOnRecordings, SurvivesAnImageItCannotTake) {
  const auto result = segmenter_->segment({cv::Mat(), 0.0});
  EXPECT_TRUE(result.segmentation.empty());
  EXPECT_EQ(result.events.count("segmentation.network_failed"), 1U);
  EXPECT_FALSE(segmenter_->segment({cv::Mat(480, 640, CV_8UC3, cv::Scalar::all(90)), 0.0}).segmentation.empty());
}

INSTANTIATE_TEST_SUITE_P(Layouts, YoloOnRecordings,
                         ::testing::Values("yolov8n-seg_320x256.onnx", "yolov5n-seg_320x256.onnx"),
                         [](const auto& parameter) { return std::string(parameter.param).substr(0, 7); });

}  // namespace
}  // namespace wardslam::segmentation

#include "wardslam/sources/rgbd_camera.h"

#include <gmock/gmock.h>

#include "support/temporary_folder.h"
#include "wardslam/core/data_files.h"
#include "wardslam/core/errors.h"

namespace wardslam::sources {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::ThrowsMessage;

const std::string kPinhole = "width: 640\nheight: 480\nfx: 525.0\nfy: 520\ncx: 319.5\ncy: 239.5\n";

class RgbdCameraFile : public ::testing::Test {
 protected:
  [[nodiscard]] RgbdCamera read(const std::string& text) const {
    return readRgbdCamera(folder.write("camera.yaml", text));
  }
  [[nodiscard]] std::vector<std::string> notesOf(const std::string& text) const {
    std::vector<std::string> notes;
    const auto note = [&](const std::string& sentence) { notes.push_back(sentence); };
    static_cast<void>(readRgbdCamera(folder.write("camera.yaml", text), note));
    return notes;
  }
  test::TemporaryFolder folder;
};

TEST_F(RgbdCameraFile, TakesItsKeys) {
  const RgbdCamera camera = read(kPinhole + "k1: 0.2\ndepth_factor: 1000\nfps: 15\n");
  EXPECT_EQ(camera.color.width_px, 640);
  EXPECT_EQ(camera.color.fy_px, 520.0);
  EXPECT_EQ(camera.color.k1, 0.2);
  EXPECT_EQ(camera.depth_units_per_m, 1000.0);
  EXPECT_EQ(camera.rate_hz, 15.0);
}

TEST_F(RgbdCameraFile, NumbersThatNoCameraHasAreRefused) {
  const auto refuses = [&](const std::string& text, const std::string& what) {
    EXPECT_THAT([&] { return read(text); }, ThrowsMessage<core::InputError>(HasSubstr(what))) << text;
  };
  const std::string numbers = "fx: 525, fy: 525, cx: 319.5, cy: 239.5";
  refuses("cam: {W: 1e30, H: 480, " + numbers + "}\n", "at most 16384 pixels");
  refuses("cam: {W: 640, H: -480, " + numbers + "}\n", "at most 16384 pixels");
  refuses("Camera: {cols: 3e9, rows: 480, " + numbers + "}\n", "at most 16384 pixels");
  refuses("cam0: {resolution: [640, 99999], intrinsics: [525, 525, 319.5, 239.5]}\n", "at most 16384 pixels");
  refuses("Camera.fx: 525\nCamera.fy: 525\nCamera.cx: 319.5\nCamera.cy: 239.5\nCamera.width: 1e10\nCamera.height: 1\n",
          "at most 16384 pixels");
  refuses("K: [525, 0, 319.5, 0, 525, 239.5, 0, 0, 1]\nwidth: 1e12\nheight: 480\n", "at most 16384 pixels");
  refuses("cam: {W: 640, H: 480, " + numbers + ", distortion: [1e300]}\n", "coefficient of the lens");
  refuses("525 525 1e300 239.5\n", "principal point that no camera has");
}

TEST_F(RgbdCameraFile, TellsNoDepthUnitThatIsNotThere) {
  EXPECT_EQ(read(kPinhole).depth_units_per_m, 0.0);
  EXPECT_FALSE(read(kPinhole).color.hasDistortion());
}

TEST_F(RgbdCameraFile, MustNameItsFocalLength) {
  EXPECT_THAT([&] { return read("width: 640\nheight: 480\nfy: 1\ncx: 1\ncy: 1\n"); },
              ThrowsMessage<core::InputError>(AllOf(HasSubstr("camera.yaml"), HasSubstr("'fx' is missing"))));
}

TEST_F(RgbdCameraFile, RefusesANegativeFocalLength) {
  EXPECT_THAT([&] { return read("width: 640\nheight: 480\nfx: -525\nfy: 1\ncx: 1\ncy: 1\n"); },
              ThrowsMessage<core::InputError>(HasSubstr("camera.yaml:3: 'fx': -525 is outside")));
}

TEST_F(RgbdCameraFile, NamesTheNearestKeyOfAMisspeltOne) {
  EXPECT_THAT([&] { return read(kPinhole + "depth_facter: 5000\n"); },
              ThrowsMessage<core::InputError>(AllOf(HasSubstr("camera.yaml:7"), HasSubstr("'depth_factor'"))));
}

TEST_F(RgbdCameraFile, RefusesAnImpossibleDepthUnit) {
  EXPECT_THAT([&] { return read(kPinhole + "depth_factor: 0\n"); },
              ThrowsMessage<core::InputError>(HasSubstr("depth_factor")));
}

TEST_F(RgbdCameraFile, RefusesAPrincipalPointOutsideTheImage) {
  EXPECT_THAT([&] { return read("width: 640\nheight: 480\nfx: 912\nfy: 911\ncx: 641.2\ncy: 364.9\n"); },
              ThrowsMessage<core::InputError>(AllOf(HasSubstr("camera.yaml"), HasSubstr("(641.2, 364.9)"),
                                                    HasSubstr("640x480"), HasSubstr("1282x730"))));
}

TEST_F(RgbdCameraFile, SaysWhatIsOdd) {
  EXPECT_THAT(notesOf(kPinhole), IsEmpty());
  EXPECT_THAT(notesOf("width: 640\nheight: 480\nfx: 600\nfy: 500\ncx: 319.5\ncy: 239.5\n"),
              ElementsAre(HasSubstr("more than 10 % apart")));
  EXPECT_THAT(notesOf("width: 640\nheight: 480\nfx: 525\nfy: 525\ncx: 319.5\ncy: 150\n"),
              ElementsAre(HasSubstr("far from the middle")));
}

TEST_F(RgbdCameraFile, SaysWhatToWriteForTheNegativeFyOfIclNuim) {
  EXPECT_THAT([&] { return read("width: 640\nheight: 480\nfx: 481.2\nfy: -480\ncx: 319.5\ncy: 239.5\n"); },
              ThrowsMessage<core::InputError>(AllOf(HasSubstr("camera.yaml:4"), HasSubstr("write 480"))));
}

TEST_F(RgbdCameraFile, KnowsOtherNamesOfTheDepthFactor) {
  for (const char* name : {"depth_scale", "png_depth_scale", "depth_map_factor"}) {
    EXPECT_EQ(read(kPinhole + name + ": 6553.5\n").depth_units_per_m, 6553.5) << name;
  }
  EXPECT_EQ(read(kPinhole + "depth_scale: 0.001\n").depth_units_per_m, 1000.0);
}

/// All the formats below describe this camera.
void expectTheCamera(const RgbdCamera& camera, double depthUnits_per_m) {
  EXPECT_EQ(camera.color.width_px, 640);
  EXPECT_EQ(camera.color.height_px, 480);
  EXPECT_EQ(camera.color.fx_px, 525.0);
  EXPECT_EQ(camera.color.fy_px, 526.0);
  EXPECT_EQ(camera.color.cx_px, 319.5);
  EXPECT_EQ(camera.color.cy_px, 239.5);
  EXPECT_EQ(camera.depth_units_per_m, depthUnits_per_m);
}

TEST_F(RgbdCameraFile, ReadsThatOfOrbSlam2) {
  const auto camera = read(
      "%YAML:1.0\n\nCamera.fx: 525.0\nCamera.fy: 526.0\nCamera.cx: 319.5\nCamera.cy: 239.5\n"
      "Camera.k1: 0.1\nCamera.p2: 0.2\nCamera.width: 640\nCamera.height: 480\nCamera.fps: 15.0\nCamera.bf: 40.0\n"
      "DepthMapFactor: 5000.0\nORBextractor.nFeatures: 1000\n");
  expectTheCamera(camera, 5000.0);
  EXPECT_EQ(camera.color.k1, 0.1);
  EXPECT_EQ(camera.color.p2, 0.2);
  EXPECT_EQ(camera.rate_hz, 15.0);
}

TEST_F(RgbdCameraFile, ReadsThatOfOrbSlam3) {
  const std::string text =
      "%YAML:1.0\nFile.version: \"1.0\"\nCamera.type: \"PinHole\"\nCamera1.fx: 525.0\nCamera1.fy: 526.0\n"
      "Camera1.cx: 319.5\nCamera1.cy: 239.5\nCamera1.k1: 0.1\nCamera.width: 640\nCamera.height: 480\n"
      "Camera.fps: 30\nRGBD.DepthMapFactor: 1000.0\n";
  expectTheCamera(read(text), 1000.0);
  std::string fisheye = text;
  fisheye.replace(fisheye.find("PinHole"), 7, "KannalaBrandt8");
  EXPECT_THAT([&] { return read(fisheye); }, ThrowsMessage<core::InputError>(HasSubstr("rectify the images")));
}

TEST_F(RgbdCameraFile, ReadsThatOfStella) {
  expectTheCamera(read("Camera:\n  name: \"a\"\n  setup: \"RGBD\"\n  model: \"perspective\"\n  fx: 525\n  fy: 526\n"
                       "  cx: 319.5\n  cy: 239.5\n  k1: 0.0\n  fps: 30.0\n  cols: 640\n  rows: 480\n"
                       "Preprocessing:\n  depthmap_factor: 5000.0\n"),
                  5000.0);
}

TEST_F(RgbdCameraFile, ReadsThatOfRosCameraCalibration) {
  const auto camera = read(
      "image_width: 640\nimage_height: 480\ncamera_name: rgb\ncamera_matrix:\n  rows: 3\n  cols: 3\n"
      "  data: [525., 0., 319.5, 0., 526., 239.5, 0., 0., 1.]\ndistortion_model: plumb_bob\n"
      "distortion_coefficients:\n  rows: 1\n  cols: 5\n  data: [0.1, 0.2, 0.3, 0.4, 0.5]\n");
  expectTheCamera(camera, 0.0);
  EXPECT_EQ(camera.color.k2, 0.2);
  EXPECT_EQ(camera.color.k3, 0.5);
}

TEST_F(RgbdCameraFile, ReadsWhatRostopicEchoPrints) {
  const std::string head = "header:\n  seq: 1\n  frame_id: \"camera\"\nheight: 480\nwidth: 640\n";
  expectTheCamera(read(head + "distortion_model: \"plumb_bob\"\nD: [0.0, 0.0, 0.0, 0.0, 0.0]\n"
                              "K: [525.0, 0.0, 319.5, 0.0, 526.0, 239.5, 0.0, 0.0, 1.0]\n---\n"),
                  0.0);
  expectTheCamera(read(head + "distortion_model: plumb_bob\nd:\n- 0.0\n- 0.0\nk:\n- 525.0\n- 0.0\n- 319.5\n- 0.0\n"
                              "- 526.0\n- 239.5\n- 0.0\n- 0.0\n- 1.0\n"),
                  0.0);
  EXPECT_THAT([&] { return read(head + "D: [1, 2, 3, 4, 5, 6, 7, 8]\nK: [525, 0, 319.5, 0, 526, 239.5, 0, 0, 1]\n"); },
              ThrowsMessage<core::InputError>(HasSubstr("more than five coefficients")));
}

TEST_F(RgbdCameraFile, ReadsMatricesByColumnsAndInRows) {
  expectTheCamera(read("{\"width\": 640, \"height\": 480, \"K\": [525, 0, 0, 0, 526, 0, 319.5, 239.5, 1]}"), 0.0);
  expectTheCamera(read("{\"width\": 640, \"height\": 480, \"K\": [[525, 0, 319.5], [0, 526, 239.5], [0, 0, 1]]}"), 0.0);
}

TEST_F(RgbdCameraFile, ReadsThatOfOpenCv) {
  expectTheCamera(read("%YAML:1.0\n---\nimage_width:640\nimage_height:480\ncamera_matrix: !!opencv-matrix\n rows: 3\n"
                       " cols: 3\n dt: f\n data: [525, 0, 319.5, 0, 526, 239.5, 0, 0, 1 ]\ndepth_factor: 1000\n"),
                  1000.0);
}

// As settings of ORB-SLAM are copied about, by parts.
TEST_F(RgbdCameraFile, ReadsThatOfOpenCvWithoutItsFirstLine) {
  expectTheCamera(read("Camera.fx:525.0\nCamera.fy:526.0\nCamera.cx:319.5\nCamera.cy:239.5\nCamera.width:640\n"
                       "Camera.height:480\nDepthMapFactor:1000.0\n"),
                  1000.0);
}

// As cv::FileStorage of today puts it, lines broken in the middle of a matrix.
TEST_F(RgbdCameraFile, ReadsThatOfOpenCvWithBlanks) {
  const auto camera = read(
      "%YAML:1.0\n---\ncalibration_time: \"Sat 28 Nov 2026 12:00:00\"\nimage_width: 640\nimage_height: 480\nflags: 0\n"
      "camera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [ 525., 0., 3.1950000000000000e+02, "
      "0.,\n"
      "       526., 2.3950000000000000e+02, 0., 0., 1. ]\ndistortion_coefficients: !!opencv-matrix\n   rows: 5\n"
      "   cols: 1\n   dt: d\n   data: [ 1.2500000000000000e-01, 0., 0., 0., -0.5 ]\nDepthMapFactor: 1000.\n");
  expectTheCamera(camera, 1000.0);
  EXPECT_EQ(camera.color.k1, 0.125);
  EXPECT_EQ(camera.color.k3, -0.5);
}

TEST_F(RgbdCameraFile, SaysWhatToWriteInPlaceOfXml) {
  EXPECT_THAT([&] { return read("<?xml version=\"1.0\"?>\n<opencv_storage></opencv_storage>\n"); },
              ThrowsMessage<core::InputError>(AllOf(HasSubstr("camera.yaml: is XML"), HasSubstr("'fx: "))));
}

TEST_F(RgbdCameraFile, ReadsThatOfKalibr) {
  const std::string camera =
      "cam0:\n  camera_model: pinhole\n  distortion_coeffs: [0.1, 0.0, 0.0, 0.0]\n  distortion_model: radtan\n"
      "  intrinsics: [525.0, 526.0, 319.5, 239.5]\n  resolution: [640, 480]\n";
  expectTheCamera(read(camera), 0.0);
  expectTheCamera(read(camera + "  depth_factor: 1000\n"), 1000.0);
  expectTheCamera(read(camera + "depth_factor: 1000\n"), 1000.0);
  std::string fisheye = camera;
  fisheye.replace(fisheye.find("radtan"), 6, "equidistant");
  EXPECT_THAT([&] { return read(fisheye); }, ThrowsMessage<core::InputError>(HasSubstr("'equidistant'")));
  EXPECT_THAT([&] { return read(camera + "cam1:\n  camera_model: pinhole\n"); },
              ThrowsMessage<core::InputError>(HasSubstr("several cameras")));
}

TEST_F(RgbdCameraFile, ReadsThoseOfOpen3dAndNiceSlam) {
  expectTheCamera(read("{\"width\": 640, \"height\": 480, \"depth_scale\": 1000,\n"
                       " \"intrinsic_matrix\": [525, 0, 0, 0, 526, 0, 319.5, 239.5, 1]}\n"),
                  1000.0);
  expectTheCamera(read("dataset: tum\ncam:\n  H: 480\n  W: 640\n  fx: 525\n  fy: 526\n  cx: 319.5\n  cy: 239.5\n"
                       "  png_depth_scale: 5000.0\n"),
                  5000.0);
}

TEST_F(RgbdCameraFile, ReadsNumbersAlone) {
  for (const char* text : {"525 526 319.5 239.5\n", "525.0, 526.0, 319.5, 239.5", "525 0 319.5\n0 526 239.5\n0 0 1\n",
                           "5.25e2 0 319.5 0\n0 526 239.5 0\n0 0 1 0\n0 0 0 1\n"}) {
    const auto camera = read(text);
    EXPECT_EQ(camera.color.width_px, 0) << text;
    EXPECT_EQ(camera.color.fx_px, 525.0) << text;
    EXPECT_EQ(camera.color.fy_px, 526.0) << text;
    EXPECT_EQ(camera.color.cx_px, 319.5) << text;
    EXPECT_EQ(camera.color.cy_px, 239.5) << text;
    EXPECT_EQ(camera.depth_units_per_m, 0.0) << text;
  }
  for (const char* text : {"525 526 319.5\n", "525 1 319.5 0 526 239.5 0 0 1", "Pinhole 525 526 319.5 239.5\n"}) {
    EXPECT_THROW(static_cast<void>(read(text)), core::InputError) << text;
  }
}

TEST_F(RgbdCameraFile, SaysHowToWriteNumbersThatAreNoCamera) {
  EXPECT_THAT([&] { return read("525 526 319.5 239.5 0.1 -0.2 0 0 0\n"); },
              ThrowsMessage<core::InputError>(AllOf(HasSubstr("9 numbers alone"), HasSubstr("'fx: "))));
}

TEST_F(RgbdCameraFile, SaysAsWhatAForeignFileIsRead) {
  EXPECT_THAT(notesOf("%YAML:1.0\nCamera.fx: 525.0\nCamera.fy: 526.0\nCamera.cx: 319.5\nCamera.cy: 239.5\n"
                      "Camera.width: 640\nCamera.height: 480\nDepthMapFactor: 5000.0\n"),
              ElementsAre(AllOf(HasSubstr("ORB-SLAM"), HasSubstr("640x480"), HasSubstr("5000 units a metre"))));
}

TEST_F(RgbdCameraFile, NamesUtf16) {
  EXPECT_THAT([&] { return read(std::string("\xFF\xFEw\0i\0", 6)); },
              ThrowsMessage<core::InputError>(AllOf(HasSubstr("UTF-16"), HasSubstr("iconv"))));
  EXPECT_EQ(read("\xEF\xBB\xBF" + kPinhole).color.width_px, 640);
}

TEST(ShippedCameras, AreTheOnesTumPublished) {
  const auto readShipped = [](const std::string& name) {
    return readRgbdCamera(core::findDataFile("cameras/" + name + ".yaml"));
  };
  const auto camera1 = readShipped("tum_freiburg1").color;
  EXPECT_EQ(camera1.fx_px, 517.3);
  EXPECT_EQ(camera1.fy_px, 516.5);
  EXPECT_EQ(camera1.cx_px, 318.6);
  EXPECT_EQ(camera1.cy_px, 255.3);
  EXPECT_EQ(camera1.k2, -0.9531);
  EXPECT_EQ(camera1.k3, 1.1633);
  EXPECT_EQ(camera1.readout_s, 0.03055);
  EXPECT_EQ(readShipped("tum_freiburg2").color.p2, -0.0001);
  EXPECT_EQ(readShipped("tum_freiburg3").color.fy_px, 539.2);
  EXPECT_FALSE(readShipped("tum_freiburg3").color.hasDistortion());
  EXPECT_EQ(readShipped("kinect_default").color.fx_px, 525.0);
}

TEST(ShippedCameras, AreListed) {
  EXPECT_THAT(listCameraFiles(), AllOf(HasSubstr("kinect_default.yaml, "), HasSubstr("tum_freiburg2.yaml")));
}

}  // namespace
}  // namespace wardslam::sources

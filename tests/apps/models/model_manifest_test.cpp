#include "models/model_manifest.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/temporary_folder.h"
#include "wardslam/core/data_files.h"
#include "wardslam/core/errors.h"

namespace wardslam::apps {
namespace {

using core::InputError;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const std::string kHead =
    "models:\n"
    "  net:\n"
    "    {title: Net, licence: MIT, homepage: h, use: u,\n"
    "    files: [{url: https://a.example/b/c.onnx";

ModelManifest read(const std::string& text) {
  const test::TemporaryFolder folder;
  return ModelManifest::fromFile(folder.write("models.yaml", text));
}

void expectRefused(const std::string& text, const std::string& part, const std::string& other = {}) {
  EXPECT_THAT([&] { (void)read(text); }, ThrowsMessage<InputError>(AllOf(HasSubstr(part), HasSubstr(other)))) << text;
}

TEST(ModelManifest, ReadsWhatIsKnownOfAFile) {
  const std::string hex(64, 'A');
  const auto manifest =
      read(kHead + ", size: 12, sha256: " + hex + "}, {url: \"http://a.example/?id=7\", name: d.pb}]}\n");
  const Model& model = manifest.find("net");
  EXPECT_EQ(model.title, "Net");
  EXPECT_EQ(model.licence, "MIT");
  ASSERT_EQ(model.files.size(), 2U);
  EXPECT_EQ(model.files[0].name, "c.onnx");
  EXPECT_EQ(model.files[0].size_bytes, 12U);
  EXPECT_EQ(model.files[0].checksum->algorithm, "sha256");
  EXPECT_EQ(model.files[0].checksum->hex, std::string(64, 'a'));
  EXPECT_EQ(model.files[1].name, "d.pb");
  EXPECT_FALSE(model.files[1].size_bytes);
  EXPECT_FALSE(model.files[1].checksum);
  EXPECT_EQ(manifest.findFile("d.pb")->url, "http://a.example/?id=7");
  EXPECT_EQ(manifest.findFile("e.pb"), nullptr);
}

TEST(ModelManifest, SuggestsTheNearestName) {
  EXPECT_THAT([] { (void)read(kHead + "}]}\n").find("ned"); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("'ned' is not in"), HasSubstr("did you mean 'net'"))));
}

TEST(ModelManifest, NamesMistakesByFileLineAndKey) {
  expectRefused("models: [a]\n", "models.yaml", "a mapping 'models'");
  expectRefused("model: {}\n", "models.yaml:1: 'model'", "did you mean 'models'");
  expectRefused("models:\n  net: {title: Net}\n", "models.yaml:2: 'models.net'", "'licence' is missing");
  expectRefused("models:\n  net: {title: Net, licence: MIT, homepage: h, use: u, files: []}\n", "at least one file");
  expectRefused(kHead + ", sise: 1}]}\n", "models.yaml:4: 'models.net.files[0].sise'", "did you mean 'size'");
  expectRefused(kHead + ", size: many}]}\n", "'models.net.files[0].size'", "a number of bytes");
  expectRefused(kHead + ", sha256: abc}]}\n", "'models.net.files[0].sha256'", "64 hexadecimal digits");
  expectRefused(kHead + ", sha256: " + std::string(64, 'g') + "}]}\n", "64 hexadecimal digits");
  expectRefused(kHead + ", sha256: " + std::string(64, 'a') + ", sha384: " + std::string(96, 'a') + "}]}\n",
                "one checksum is enough");
  expectRefused(kHead + ", name: ../c.onnx}]}\n", "'../c.onnx' cannot be the name");
  expectRefused(kHead + "/}]}\n", "cannot be the name");
  expectRefused(kHead + "}, {url: ftp://a.example/b}]}\n", "'models.net.files[1].url'", "https://");
}

TEST(ModelManifest, TheShippedOneIsSound) {
  const auto manifest = ModelManifest::fromFile(core::findDataFile("models.yaml"));
  EXPECT_GE(manifest.models().size(), 5U);
  for (const auto& model : manifest.models()) {
    EXPECT_EQ(model.homepage.rfind("https://", 0), 0U) << model.name;
    EXPECT_FALSE(model.licence.empty()) << model.name;
  }
  EXPECT_EQ(manifest.find("mask_rcnn_inception_v2_coco").files.size(), 2U);
}

}  // namespace
}  // namespace wardslam::apps

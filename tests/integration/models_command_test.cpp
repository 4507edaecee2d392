#include <gmock/gmock.h>

#include <algorithm>

#include "cli_test_support.h"
#include "support/test_server.h"

namespace wardslam {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr const char* kSha256OfAbc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

class ModelsCommand : public ::testing::Test {
 protected:
  ModelsCommand() {
    server_.add("net.onnx", "abc");
    server_.add("net.pbtxt", "graph");
    writeManifest(server_.url("net.onnx"));
  }

  void writeManifest(const std::string& url) const {
    (void)folder_.write("models.yaml",
                        "models:\n  net:\n    title: A network\n    licence: MIT\n    homepage: there\n" +
                            std::string("    use: as it is\n    files:\n      - {url: ") + url + ", size: 3, sha256: " +
                            kSha256OfAbc + "}\n      - {url: " + server_.url("net.pbtxt") + "}\n");
  }

  [[nodiscard]] test::CommandResult models(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "models");
    arguments.insert(arguments.end(), {"--manifest", (folder_.path() / "models.yaml").string()});
    return test::runProgram("wardslam", arguments);
  }

  static void expectFailure(const test::CommandResult& result, const std::string& part) {
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_THAT(result.err, AllOf(StartsWith("wardslam: "), HasSubstr(part)));
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  }

  test::TestServer server_;
  test::TemporaryFolder folder_;
  std::string to_ = (folder_.path() / "models").string();
};

TEST_F(ModelsCommand, ListsWhatThereIs) {
  const auto result = models({"list"});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_THAT(result.out, AllOf(HasSubstr("net: A network\n"), HasSubstr("licence  MIT\n"),
                                HasSubstr("net.onnx, 3 B, sha256 known\n"),
                                HasSubstr("net.pbtxt, size not known, no checksum known\n")));
  EXPECT_TRUE(server_.requests().empty()) << "nothing is downloaded unasked";
  const auto shipped = test::runProgram("wardslam", {"models", "list"});
  EXPECT_EQ(shipped.exitCode, 0);
  EXPECT_THAT(shipped.out, AllOf(HasSubstr("mask_rcnn_inception_v2_coco"), HasSubstr("AGPL-3.0")));
}

TEST_F(ModelsCommand, FetchesAndVerifies) {
  const auto fetched = models({"fetch", "net", "--to", to_});
  EXPECT_EQ(fetched.exitCode, 0) << fetched.err;
  EXPECT_THAT(fetched.out, AllOf(HasSubstr("licence MIT"), HasSubstr("net.onnx: fetched, sha256 as expected"),
                                 HasSubstr("net.pbtxt: fetched, not verified"), HasSubstr("To use it: as it is")));
  EXPECT_EQ(test::readText(to_ + "/net.onnx"), "abc");
  EXPECT_EQ(test::readText(to_ + "/net.pbtxt"), "graph");

  const auto verified = models({"verify", to_ + "/net.onnx"});
  EXPECT_EQ(verified.exitCode, 0);
  EXPECT_THAT(verified.out, HasSubstr("net.onnx: sha256 as expected"));
  expectFailure(models({"verify", "net", "--in", to_}), "net.pbtxt: no checksum known; its sha256 is ");
  EXPECT_THAT(models({"fetch", "net", "--to", to_}).out, HasSubstr("net.onnx: was there already, sha256 as expected"));
}

TEST_F(ModelsCommand, TellsThatTheComputerIsOffline) {
  for (const char* url : {"http://127.0.0.1:1/net.onnx", "https://no-such-host.invalid/net.onnx"}) {
    writeManifest(url);
    expectFailure(models({"fetch", "net", "--to", to_}), std::string(url) + ": cannot be reached");
  }
}

TEST_F(ModelsCommand, TellsWhatIsWrong) {
  expectFailure(models({"fetch", "ned", "--to", to_}), "did you mean 'net'");
  expectFailure(models({"verify", "no-such-file.onnx"}), "'no-such-file.onnx' is not in");
  expectFailure(models({"verify", folder_.write("other/net.onnx", "abd").string()}), "its sha256 is ");
  expectFailure(models({"verify", folder_.write("unknown.onnx", "abc").string()}),
                std::string("no checksum known; its sha256 is ") + kSha256OfAbc);
  expectFailure(models({"verify", "net", "--in", to_}), "net.onnx: no such file");
  EXPECT_EQ(test::runProgram("wardslam", {"models"}).exitCode, 2);
}

}  // namespace
}  // namespace wardslam

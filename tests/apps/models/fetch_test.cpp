#include "models/fetch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "support/test_server.h"
#include "wardslam/core/digest.h"
#include "wardslam/core/errors.h"

namespace wardslam::apps {
namespace {

namespace fs = std::filesystem;
using core::InputError;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::ThrowsMessage;

constexpr const char* kContent = "abc";
constexpr const char* kSha256 = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";  // FIPS 180-2

class FetchFile : public ::testing::Test {
 protected:
  FetchFile() {
    server_.add("net.onnx", kContent);
    wanted_ = {"net.onnx", server_.url("net.onnx"), 3, Checksum{"sha256", kSha256}};
  }

  [[nodiscard]] fs::path file() const { return to_ / "net.onnx"; }
  [[nodiscard]] fs::path partial() const { return to_ / "net.onnx.partial"; }

  test::TestServer server_;
  test::TemporaryFolder folder_;
  fs::path to_ = folder_.path() / "made" / "for it";
  ModelFile wanted_;
};

TEST_F(FetchFile, DownloadsVerifiesAndRenames) {
  const Fetched fetched = fetchFile(wanted_, to_);
  EXPECT_EQ(fetched.file, file());
  EXPECT_EQ(fetched.verification, Verification::Matches);
  EXPECT_FALSE(fetched.wasThere);
  EXPECT_EQ(test::readText(file()), kContent);
  EXPECT_FALSE(fs::exists(partial()));
}

TEST_F(FetchFile, LeavesAloneWhatIsThere) {
  (void)fetchFile(wanted_, to_);
  const Fetched again = fetchFile(wanted_, to_);
  EXPECT_TRUE(again.wasThere);
  EXPECT_EQ(again.verification, Verification::Matches);
  EXPECT_EQ(server_.requests().size(), 1U);
}

TEST_F(FetchFile, DoesNotReplaceAnotherFileOfThatName) {
  (void)folder_.write("made/for it/net.onnx", "mine");
  EXPECT_THAT([&] { (void)fetchFile(wanted_, to_); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("has 4 bytes"), HasSubstr("move it away"))));
  EXPECT_EQ(test::readText(file()), "mine");
  EXPECT_THAT(server_.requests(), IsEmpty());
}

TEST_F(FetchFile, ContinuesAnInterruptedDownload) {
  (void)folder_.write("made/for it/net.onnx.partial", "a");
  EXPECT_EQ(fetchFile(wanted_, to_).verification, Verification::Matches);
  EXPECT_THAT(server_.requests(), ElementsAre("bytes=1-"));
}

TEST_F(FetchFile, AsksForNothingWhenOnlyTheRenamingIsLeft) {
  (void)folder_.write("made/for it/net.onnx.partial", kContent);
  EXPECT_EQ(fetchFile(wanted_, to_).verification, Verification::Matches);
  EXPECT_THAT(server_.requests(), IsEmpty());
}

TEST_F(FetchFile, BeginsAnewWhereNothingCouldTellThatThePartsFit) {
  (void)folder_.write("made/for it/net.onnx.partial", "x");
  wanted_.checksum.reset();
  EXPECT_EQ(fetchFile(wanted_, to_).verification, Verification::NoChecksumKnown);
  EXPECT_EQ(test::readText(file()), kContent);
  EXPECT_THAT(server_.requests(), ElementsAre("-"));
}

TEST_F(FetchFile, DeletesWhatIsNotWhatWasPromised) {
  server_.add("net.onnx", "abd");
  EXPECT_THAT([&] { (void)fetchFile(wanted_, to_); },
              ThrowsMessage<InputError>(AllOf(HasSubstr(kSha256), HasSubstr("was deleted"))));
  server_.add("net.onnx", "<html>please log in</html>");
  EXPECT_THAT([&] { (void)fetchFile(wanted_, to_); }, ThrowsMessage<InputError>(HasSubstr("has 26 bytes")));
  EXPECT_FALSE(fs::exists(partial()));
  EXPECT_FALSE(fs::exists(file()));
}

TEST_F(FetchFile, TellsThatTheFolderCannotBeMade) {
  (void)folder_.write("taken", "");
  EXPECT_THAT([&] { (void)fetchFile(wanted_, folder_.path() / "taken" / "models"); },
              ThrowsMessage<InputError>(HasSubstr("cannot be made")));
}

TEST(VerifyFile, ComparesSizeAndChecksum) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.write("net.onnx", kContent);
  const auto expected = [](std::optional<std::uint64_t> size, std::optional<Checksum> checksum) {
    return ModelFile{"net.onnx", "", size, std::move(checksum)};
  };
  EXPECT_EQ(verifyFile(expected(3, Checksum{"sha256", kSha256}), file), Verification::Matches);
  EXPECT_EQ(verifyFile(expected({}, Checksum{"sha512", core::digestOfFile(file, "sha512")}), file),
            Verification::Matches);
  EXPECT_EQ(verifyFile(expected(3, {}), file), Verification::NoChecksumKnown);
  EXPECT_EQ(verifyFile(expected({}, {}), file), Verification::NoChecksumKnown);
  EXPECT_THROW((void)verifyFile(expected(4, {}), file), InputError);
  EXPECT_THROW((void)verifyFile(expected(3, Checksum{"sha256", std::string(64, '0')}), file), InputError);
  EXPECT_THROW((void)verifyFile(expected({}, {}), folder.path()), InputError);
  EXPECT_THROW((void)verifyFile(expected({}, {}), folder.path() / "none"), InputError);
}

TEST(DefaultModelFolder, FollowsTheXdgConvention) {
  setenv("XDG_DATA_HOME", "/data", 1);
  EXPECT_EQ(defaultModelFolder(), "/data/wardslam/models");
  unsetenv("XDG_DATA_HOME");
  setenv("HOME", "/home/nurse", 1);
  EXPECT_EQ(defaultModelFolder(), "/home/nurse/.local/share/wardslam/models");
}

}  // namespace
}  // namespace wardslam::apps

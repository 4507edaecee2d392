#include "models/download.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/test_server.h"
#include "wardslam/core/errors.h"

namespace wardslam::apps {
namespace {

using core::InputError;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::ThrowsMessage;

class Download : public ::testing::Test {
 protected:
  Download() {
    for (int i = 0; i < 100000; ++i) content_ += static_cast<char>('a' + (i * 7919) % 26);
    server_.add("net.onnx", content_);
  }

  void get(const std::string& path, const DownloadObserver& observer = {}) const {
    download(server_.url(path), file_, observer);
  }
  void expectFailure(const std::string& url, const std::string& part) const {
    EXPECT_THAT([&] { download(url, file_, {}); },
                ThrowsMessage<InputError>(AllOf(HasSubstr(url), HasSubstr(part), Not(HasSubstr("\n")))));
  }
  [[nodiscard]] std::string received() const { return test::readText(file_); }

  test::TestServer server_;
  test::TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "net.onnx.partial";
  std::string content_;
};

TEST_F(Download, FetchesTheWhole) {
  DownloadState last;
  get("net.onnx", [&](const DownloadState& state) {
    last = state;
    return true;
  });
  EXPECT_EQ(received(), content_);
  EXPECT_EQ(last.done_bytes, content_.size());
  EXPECT_EQ(last.total_bytes, content_.size());
  EXPECT_EQ(last.resumedFrom_bytes, 0U);
}

TEST_F(Download, AsksForTheRestOnly) {
  (void)folder_.write("net.onnx.partial", content_.substr(0, 60000));
  DownloadState last;
  get("net.onnx", [&](const DownloadState& state) {
    last = state;
    return true;
  });
  EXPECT_EQ(received(), content_);
  EXPECT_THAT(server_.requests(), ElementsAre("bytes=60000-"));
  EXPECT_EQ(last.resumedFrom_bytes, 60000U);
  EXPECT_EQ(last.done_bytes, content_.size());
  EXPECT_EQ(last.total_bytes, content_.size());
}

TEST_F(Download, BeginsAnewWhereTheServerCannotResume) {
  (void)folder_.write("net.onnx.partial", "something else");
  get("norange/net.onnx");
  EXPECT_EQ(received(), content_);
}

TEST_F(Download, BeginsAnewWhenThereIsMoreThanThereShouldBe) {
  (void)folder_.write("net.onnx.partial", content_ + "too much");
  get("net.onnx");
  EXPECT_EQ(received(), content_);
  EXPECT_THAT(server_.requests(), ElementsAre("bytes=100008-", "-"));
}

TEST_F(Download, KeepsWhatArrivedWhenTheLineBreaks) {
  EXPECT_THAT([&] { get("cut/net.onnx"); }, ThrowsMessage<InputError>(HasSubstr("broke off")));
  EXPECT_EQ(received(), content_.substr(0, content_.size() / 2));
  get("net.onnx");
  EXPECT_EQ(received(), content_);
}

TEST_F(Download, StopsWhenToldTo) {
  EXPECT_THAT([&] { get("net.onnx", [](const DownloadState&) { return false; }); },
              ThrowsMessage<InputError>(HasSubstr("interrupted")));
}

TEST_F(Download, TellsWhatWentWrong) {
  expectFailure(server_.url("missing.onnx"), "the server answers 404");
  EXPECT_FALSE(std::filesystem::exists(file_)) << "an error page is no network";
  expectFailure("http://127.0.0.1:1/net.onnx", "is this computer offline?");
  expectFailure("file:///etc/hostname", "broke off");
  EXPECT_THAT([&] { download(server_.url("net.onnx"), "/no/such/folder/net.onnx", {}); },
              ThrowsMessage<InputError>(HasSubstr("/no/such/folder/net.onnx: cannot be opened for writing")));
}

}  // namespace
}  // namespace wardslam::apps

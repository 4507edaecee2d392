#include "models/download.h"

#include <curl/curl.h>

#include <fstream>
#include <memory>

#include "wardslam/core/errors.h"

namespace wardslam::apps {
namespace {

namespace fs = std::filesystem;

constexpr long kOk = 200;
constexpr long kPartialContent = 206;
constexpr long kRangeNotSatisfiable = 416;
constexpr long kConnectTimeout_s = 20;
constexpr long kStallTimeout_s = 60;  // without a single byte

/// libcurl wants to be started once per process.
void startCurl() {
  static const CURLcode kStarted = curl_global_init(CURL_GLOBAL_DEFAULT);
  if (kStarted != CURLE_OK) throw core::InputError("libcurl cannot be started: downloads are not possible");
}

/// One request and what came of it.
class Transfer {
 public:
  Transfer(const std::string& url, const fs::path& file, std::uint64_t offset, const DownloadObserver& observer)
      : out_(file, std::ios::binary | (offset > 0 ? std::ios::app : std::ios::trunc)),
        observer_(observer),
        offset_(offset) {
    if (!out_) throw core::InputError(file.string() + ": cannot be opened for writing");
    const auto set = [this](CURLoption option, auto value) { curl_easy_setopt(curl_.get(), option, value); };
    set(CURLOPT_URL, url.c_str());
    set(CURLOPT_PROTOCOLS_STR, "http,https");
    set(CURLOPT_REDIR_PROTOCOLS_STR, url.rfind("https://", 0) == 0 ? "https" : "http,https");
    set(CURLOPT_FOLLOWLOCATION, 1L);
    set(CURLOPT_USERAGENT, "wardslam");
    set(CURLOPT_NOSIGNAL, 1L);
    set(CURLOPT_CONNECTTIMEOUT, kConnectTimeout_s);
    set(CURLOPT_LOW_SPEED_LIMIT, 1L);
    set(CURLOPT_LOW_SPEED_TIME, kStallTimeout_s);
    set(CURLOPT_RESUME_FROM_LARGE, static_cast<curl_off_t>(offset));
    set(CURLOPT_ERRORBUFFER, static_cast<char*>(detail_));
    set(CURLOPT_WRITEFUNCTION, &Transfer::write);
    set(CURLOPT_WRITEDATA, this);
    set(CURLOPT_NOPROGRESS, 0L);
    set(CURLOPT_XFERINFOFUNCTION, &Transfer::progress);
    set(CURLOPT_XFERINFODATA, this);
  }

  CURLcode run() {
    const CURLcode result = curl_easy_perform(curl_.get());
    out_.flush();
    return out_ ? result : CURLE_WRITE_ERROR;
  }

  [[nodiscard]] long status() const {
    long status = 0;
    curl_easy_getinfo(curl_.get(), CURLINFO_RESPONSE_CODE, &status);
    return status;
  }

  [[nodiscard]] std::string detail(CURLcode result) const {
    return detail_[0] != '\0' ? std::string(detail_) : curl_easy_strerror(result);
  }

 private:
  static std::size_t write(const char* bytes, std::size_t size, std::size_t count, void* self) {
    auto& transfer = *static_cast<Transfer*>(self);
    const std::size_t length = size * count;
    const long status = transfer.status();
    if (status != kOk && status != kPartialContent) return length;  // the text of an error page
    transfer.out_.write(bytes, static_cast<std::streamsize>(length));
    return transfer.out_ ? length : 0;
  }

  static int progress(void* self, curl_off_t total, curl_off_t done, curl_off_t, curl_off_t) {
    const auto& transfer = *static_cast<Transfer*>(self);
    if (!transfer.observer_) return 0;
    DownloadState state{transfer.offset_, transfer.offset_ + static_cast<std::uint64_t>(done), {}};
    if (total > 0) state.total_bytes = transfer.offset_ + static_cast<std::uint64_t>(total);
    return transfer.observer_(state) ? 0 : 1;
  }

  std::unique_ptr<CURL, decltype(&curl_easy_cleanup)> curl_{curl_easy_init(), curl_easy_cleanup};
  std::ofstream out_;
  const DownloadObserver& observer_;
  std::uint64_t offset_;
  char detail_[CURL_ERROR_SIZE] = "";
};

/// One sentence about a transfer that did not end well.
std::string explain(CURLcode result, const Transfer& transfer, const std::string& url, const fs::path& file) {
  switch (result) {
    case CURLE_ABORTED_BY_CALLBACK:
      return url + ": interrupted; the same command goes on from here";
    case CURLE_WRITE_ERROR:
      return file.string() + ": cannot be written; is the disk full?";
    default:
      return url + ": the download broke off (" + transfer.detail(result) + "); try the same command again";
  }
}

bool isUnreachable(CURLcode result) {
  return result == CURLE_COULDNT_RESOLVE_HOST || result == CURLE_COULDNT_RESOLVE_PROXY ||
         result == CURLE_COULDNT_CONNECT;
}

}  // namespace

void download(const std::string& url, const fs::path& file, const DownloadObserver& observer) {
  startCurl();
  const std::uint64_t offset = fs::exists(file) ? fs::file_size(file) : 0;
  Transfer transfer(url, file, offset, observer);
  const CURLcode result = transfer.run();
  const bool cannotResume = result == CURLE_RANGE_ERROR || transfer.status() == kRangeNotSatisfiable;
  if (offset > 0 && cannotResume) {
    fs::remove(file);
    return download(url, file, observer);
  }
  if (fs::file_size(file) == 0) fs::remove(file);
  if (transfer.status() >= 400) {
    throw core::InputError(url + ": the server answers " + std::to_string(transfer.status()) + "; has the file moved?");
  }
  if (isUnreachable(result)) {
    throw Unreachable(url + ": cannot be reached (" + transfer.detail(result) +
                      "); is this computer offline? Another one can fetch the file from there");
  }
  if (result != CURLE_OK) throw core::InputError(explain(result, transfer, url, file));
}

}  // namespace wardslam::apps

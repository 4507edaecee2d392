#include "wardslam/sources/rawlog_writer.h"

#include <mrpt/img/CImage.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/obs/CObservation.h>
#include <mrpt/serialization/CArchive.h>

#include <system_error>
#include <utility>

#include "gzip_file.h"
#include "wardslam/core/errors.h"

namespace wardslam::sources {
namespace {

[[noreturn]] void failOnFullDisk(const std::filesystem::path& file) {
  throw core::InputError(file.string() + ": cannot be written in full; is the disk full?");
}

}  // namespace

class RawlogWriter::Output {
 public:
  explicit Output(const std::filesystem::path& file) {
    if (!stream_.open(file.string())) {
      throw core::InputError(file.string() + ": cannot be created; is the folder there and writable?");
    }
  }
  void write(const mrpt::obs::CObservation& observation) { archive_ << observation; }
  [[nodiscard]] std::uint64_t written_bytes() const { return stream_.getPosition(); }

 private:
  mrpt::io::CFileGZOutputStream stream_;
  mrpt::serialization::CArchiveStreamBase<mrpt::io::CFileGZOutputStream> archive_{stream_};
};

RawlogWriter::RawlogWriter(std::filesystem::path file, ImageCoding images)
    : file_(std::move(file)), partial_(file_.string() + ".partial") {
  if (std::filesystem::exists(file_) && !std::filesystem::is_regular_file(file_)) {
    throw core::InputError(file_.string() + ": is there already and no file that could be replaced");
  }
  mrpt::img::CImage::DISABLE_JPEG_COMPRESSION(images == ImageCoding::Lossless);
  output_ = std::make_unique<Output>(partial_);
}

RawlogWriter::~RawlogWriter() {
  output_.reset();
  if (isCommitted_) return;
  std::error_code ignored;
  std::filesystem::remove(partial_, ignored);
}

void RawlogWriter::write(const mrpt::obs::CObservation& observation) {
  try {
    output_->write(observation);
  } catch (const std::exception&) {
    failOnFullDisk(partial_);
  }
}

void RawlogWriter::commit() {
  const auto written_bytes = static_cast<std::uint32_t>(output_->written_bytes());
  output_.reset();
  if (gzipContentSize(partial_) != written_bytes) failOnFullDisk(partial_);  // closing a stream of MRPT tells nothing
  std::error_code error;
  std::filesystem::rename(partial_, file_, error);
  if (error) throw core::InputError(file_.string() + ": cannot be replaced: " + error.message());
  isCommitted_ = true;
}

}  // namespace wardslam::sources

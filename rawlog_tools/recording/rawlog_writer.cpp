#include "recording/rawlog_writer.h"

#include <mrpt/img/CImage.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/serialization/CArchive.h>

#include <system_error>
#include <utility>

#include "wardslam/core/errors.h"
#include "wardslam/sources/gzip_file.h"

namespace wardslam::recording {
namespace {

[[noreturn]] void failOnFullDisk(const std::filesystem::path& file) {
  throw core::InputError(file.string() + ": cannot be written in full; is the disk full?");
}

}  // namespace

/// One member of the gz file.
class RawlogWriter::Output {
 public:
  explicit Output(const std::filesystem::path& file) {
    if (!stream_.open(file.string(), kFastest, std::nullopt, mrpt::io::OpenMode::APPEND)) {
      throw core::InputError(file.string() + ": cannot be created; is the folder there and writable?");
    }
  }
  void write(const mrpt::serialization::CSerializable& object) { archive_ << object; }
  void write(const std::vector<std::uint8_t>& bytes) { archive_.WriteBuffer(bytes.data(), bytes.size()); }
  [[nodiscard]] std::uint64_t written_bytes() const { return stream_.getPosition(); }

 private:
  static constexpr int kFastest = 1;

  mrpt::io::CFileGZOutputStream stream_;
  mrpt::serialization::CArchiveStreamBase<mrpt::io::CFileGZOutputStream> archive_{stream_};
};

RawlogWriter::RawlogWriter(std::filesystem::path file, ImageCoding images, std::uintmax_t resumeAt)
    : file_(std::move(file)), partial_(file_.string() + ".partial"), isKept_(resumeAt > 0) {
  if (std::filesystem::exists(file_) && !std::filesystem::is_regular_file(file_)) {
    throw core::InputError(file_.string() + ": is there already and no file that could be replaced");
  }
  mrpt::img::CImage::DISABLE_JPEG_COMPRESSION(images == ImageCoding::Lossless);
  if (resumeAt == 0) {
    std::error_code absent;
    std::filesystem::remove(partial_, absent);
  } else if (!std::filesystem::exists(partial_) || std::filesystem::file_size(partial_) < resumeAt) {
    throw core::InputError(partial_.string() + ": is shorter than it was; remove it and begin anew");
  } else {
    std::filesystem::resize_file(partial_, resumeAt);  // what came behind the last checkpoint may be cut off
  }
  output_ = std::make_unique<Output>(partial_);
}

RawlogWriter::~RawlogWriter() {
  output_.reset();
  if (isKept_) return;
  std::error_code ignored;
  std::filesystem::remove(partial_, ignored);
}

template <class Object>
void RawlogWriter::append(const Object& object) {
  if (!output_) output_ = std::make_unique<Output>(partial_);
  try {
    output_->write(object);
  } catch (const std::exception&) {
    failOnFullDisk(partial_);
  }
}

void RawlogWriter::write(const mrpt::serialization::CSerializable& object) { append(object); }
void RawlogWriter::write(const std::vector<std::uint8_t>& object) { append(object); }

std::uintmax_t RawlogWriter::checkpoint() {
  finishMember();
  isKept_ = true;
  return std::filesystem::file_size(partial_);
}

void RawlogWriter::finishMember() {
  if (!output_) return;
  const auto written_bytes = static_cast<std::uint32_t>(output_->written_bytes());
  output_.reset();
  if (sources::gzipContentSize(partial_) != written_bytes)
    failOnFullDisk(partial_);  // closing a stream of MRPT tells nothing
}

void RawlogWriter::commit() {
  finishMember();
  std::error_code error;
  std::filesystem::rename(partial_, file_, error);
  if (error) throw core::InputError(file_.string() + ": cannot be replaced: " + error.message());
  isKept_ = true;
}

}  // namespace wardslam::recording

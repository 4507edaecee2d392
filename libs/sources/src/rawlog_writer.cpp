#include "wardslam/sources/rawlog_writer.h"

#include <mrpt/img/CImage.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/obs/CObservation.h>
#include <mrpt/serialization/CArchive.h>

#include <system_error>
#include <utility>

#include "wardslam/core/errors.h"

namespace wardslam::sources {

class RawlogWriter::Output {
 public:
  explicit Output(const std::filesystem::path& file) {
    if (!stream_.open(file.string())) {
      throw core::InputError(file.string() + ": cannot be created; is the folder there and writable?");
    }
  }
  void write(const mrpt::obs::CObservation& observation) { archive_ << observation; }

 private:
  mrpt::io::CFileGZOutputStream stream_;
  mrpt::serialization::CArchiveStreamBase<mrpt::io::CFileGZOutputStream> archive_{stream_};
};

RawlogWriter::RawlogWriter(std::filesystem::path file) : file_(std::move(file)), partial_(file_.string() + ".partial") {
  mrpt::img::CImage::DISABLE_JPEG_COMPRESSION(true);
  output_ = std::make_unique<Output>(partial_);
}

RawlogWriter::~RawlogWriter() {
  if (!output_) return;
  output_.reset();
  std::error_code ignored;
  std::filesystem::remove(partial_, ignored);
}

void RawlogWriter::write(const mrpt::obs::CObservation& observation) {
  try {
    output_->write(observation);
  } catch (const std::exception&) {
    throw core::InputError(partial_.string() + ": cannot be written further; is the disk full?");
  }
}

void RawlogWriter::commit() {
  output_.reset();
  std::error_code error;
  std::filesystem::rename(partial_, file_, error);
  if (error) throw core::InputError(file_.string() + ": cannot be replaced: " + error.message());
}

}  // namespace wardslam::sources

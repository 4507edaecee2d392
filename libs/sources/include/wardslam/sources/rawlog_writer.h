#pragma once

#include <filesystem>
#include <memory>

namespace mrpt::obs {
class CObservation;
}

namespace wardslam::sources {

/// How colour images are embedded; depth is always kept as it is.
enum class ImageCoding { Lossless, Jpeg };

/// Writes observations as a gz-compressed MRPT rawlog that is complete or absent: the data go to "<file>.partial",
/// which commit() renames and the destructor removes.
///
/// MRPT has one switch for the coding of images in the process (CImage::DISABLE_JPEG_COMPRESSION); the constructor
/// sets it.
class RawlogWriter {
 public:
  /// Replaces a file that is there, once complete. Throws core::InputError when the file cannot be created.
  explicit RawlogWriter(std::filesystem::path file, ImageCoding images = ImageCoding::Lossless);
  ~RawlogWriter();
  RawlogWriter(const RawlogWriter&) = delete;
  RawlogWriter& operator=(const RawlogWriter&) = delete;

  /// Throws core::InputError when the disk does not take it.
  void write(const mrpt::obs::CObservation& observation);
  void commit();

 private:
  class Output;

  std::filesystem::path file_;
  std::filesystem::path partial_;
  std::unique_ptr<Output> output_;
  bool isCommitted_ = false;
};

}  // namespace wardslam::sources

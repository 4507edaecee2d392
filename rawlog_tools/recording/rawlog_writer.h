#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

namespace mrpt::serialization {
class CSerializable;
}

namespace wardslam::recording {

/// How colour images are embedded; depth is always kept as it is.
enum class ImageCoding { Lossless, Jpeg };

/// Writes objects as a gz-compressed MRPT rawlog that is complete or absent: the data go to "<file>.partial", which
/// commit() renames and the destructor removes.
///
/// Work that takes long can be interrupted: from the first checkpoint() on, the partial file stays, and another writer
/// can go on in it.
///
/// MRPT has one switch for the coding of images in the process (CImage::DISABLE_JPEG_COMPRESSION); the constructor
/// sets it.
class RawlogWriter {
 public:
  /// Replaces a file that is there, once complete. `resumeAt`: what checkpoint() of the interrupted writer returned; 0
  /// begins anew. Throws core::InputError when the file cannot be created, or is shorter than `resumeAt`.
  explicit RawlogWriter(std::filesystem::path file, ImageCoding images = ImageCoding::Lossless,
                        std::uintmax_t resumeAt = 0);
  ~RawlogWriter();
  RawlogWriter(const RawlogWriter&) = delete;
  RawlogWriter& operator=(const RawlogWriter&) = delete;

  /// Throws core::InputError when the disk does not take it.
  void write(const mrpt::serialization::CSerializable& object);

  /// An object as it stands in another rawlog.
  void write(const std::vector<std::uint8_t>& object);

  /// Everything until here is in the partial file now, which has this size (bytes).
  std::uintmax_t checkpoint();

  void commit();

  /// Also the destructor removes the file then, whatever checkpoints were made.
  void discard() { isKept_ = false; }

 private:
  class Output;

  template <class Object>
  void append(const Object& object);
  void finishMember();

  std::filesystem::path file_;
  std::filesystem::path partial_;
  std::unique_ptr<Output> output_;  ///< Null between checkpoint() and the next write().
  bool isKept_ = false;
};

}  // namespace wardslam::recording

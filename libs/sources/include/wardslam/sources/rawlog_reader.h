#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

namespace mrpt::obs {
class CObservation;
}
namespace mrpt::serialization {
class CSerializable;
}

namespace wardslam::sources {

/// The objects of an MRPT rawlog (gz-compressed or not), one after the other; it holds no more than one. Knows the
/// classes of mrpt-obs and mrpt-maps, and those of plug-ins that are loaded.
class RawlogReader {
 public:
  /// MRPT resolves external images through one process-wide folder, which this sets to the one beside the file, if
  /// there is one. Throws core::InputError when the file cannot be opened.
  explicit RawlogReader(const std::filesystem::path& file);
  ~RawlogReader();

  /// Null at the end of the file. Throws InputDamage where the next object cannot be read ("sources.rawlog_truncated",
  /// "sources.rawlog_unknown_class"); after that, null.
  [[nodiscard]] std::shared_ptr<mrpt::serialization::CSerializable> read();

  /// The last object as it stands in the file.
  [[nodiscard]] const std::vector<std::uint8_t>& bytes() const;

  [[nodiscard]] std::size_t objects() const { return objects_; }  ///< Read so far.
  [[nodiscard]] double fraction() const;                          ///< Share of the file that is read, 0..1.

 private:
  class Input;

  std::unique_ptr<Input> input_;
  bool ended_ = false;
  std::size_t objects_ = 0;
};

/// The observations in an object of a rawlog: itself, or those of a sensory frame (shared with it); none in others.
[[nodiscard]] std::vector<std::shared_ptr<mrpt::obs::CObservation>> observationsIn(
    const std::shared_ptr<mrpt::serialization::CSerializable>& object);

}  // namespace wardslam::sources

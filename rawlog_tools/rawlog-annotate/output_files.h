#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "recording/rawlog_writer.h"

namespace mrpt::serialization {
class CSerializable;
}

namespace wardslam::rawlog_annotate {

/// The rawlogs that are written: the annotated copy and, beside it, the sidecar "<name>_sem.rawlog" (not where
/// everything goes into one file). They are complete or absent.
///
/// How far the work is stands in "<output>.resume" once a checkpoint was made: after an interruption the same work goes
/// on from there. Of other work, told apart by `job`, nothing is taken over.
class OutputFiles {
 public:
  /// Throws core::InputError when a file cannot be created, or is the input itself.
  OutputFiles(std::filesystem::path output, bool hasSidecar, const std::filesystem::path& input, std::string job);

  /// Objects of the input that an interrupted run has dealt with.
  [[nodiscard]] std::size_t objectsDone() const { return objectsDone_; }

  void write(const mrpt::serialization::CSerializable& object) {
    guarded([&] { main_->write(object); });
  }
  void write(const std::vector<std::uint8_t>& object) {
    guarded([&] { main_->write(object); });
  }
  void writeToSidecar(const mrpt::serialization::CSerializable& object) {
    guarded([&] { sidecar_->write(object); });
  }

  /// What was written until here is kept, whatever happens.
  void checkpoint(std::size_t objectsDone);
  void commit();

  /// Nothing stays of what was written, as the input will not do the next time either. Where the disk did not take it,
  /// it might: then nothing happens.
  void discard();

  [[nodiscard]] const std::filesystem::path& output() const { return output_; }
  [[nodiscard]] std::filesystem::path sidecar() const;

 private:
  void open(bool hasSidecar, std::uintmax_t mainSize_bytes, std::uintmax_t sidecarSize_bytes);
  void linkImages() const;
  template <class Write>
  void guarded(const Write& write) {
    diskFails_ = true;
    write();
    diskFails_ = false;
  }

  std::filesystem::path output_;
  std::filesystem::path resumeFile_;
  std::optional<std::filesystem::path> inputImages_;  ///< Folder of external images.
  std::string job_;
  std::size_t objectsDone_ = 0;
  bool diskFails_ = false;  ///< While something is written, and for good where that threw.
  std::unique_ptr<recording::RawlogWriter> main_;
  std::unique_ptr<recording::RawlogWriter> sidecar_;
};

}  // namespace wardslam::rawlog_annotate

#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

namespace mrpt::obs {
class CObservation3DRangeScan;
}

/// What a sensor process tells through its standard output.
namespace wardslam::sources {

struct SensorMessage {
  enum class Kind : std::uint8_t {
    Observation = 1,  ///< bytes: see packObservation()
    Refusal,          ///< bytes: a sentence; trying again is of no use.
    Failure           ///< bytes: a sentence; another time it may work.
  };
  Kind kind = Kind::Failure;
  std::string bytes;
};

/// Blocks until all is written. False: nobody reads any more (SIGPIPE must be ignored).
[[nodiscard]] bool writeMessage(int descriptor, const SensorMessage& message);

/// Takes messages from a pipe that others fill.
class SensorMessageReader {
 public:
  enum class Status { Message, Nothing, Closed };

  /// `descriptor` must outlive this object.
  explicit SensorMessageReader(int descriptor);

  /// Waits no longer than `patience` for the rest of a message, then says Nothing. Closed: there will be no more.
  [[nodiscard]] Status read(SensorMessage& message, std::chrono::milliseconds patience);

 private:
  [[nodiscard]] bool takeMessage(SensorMessage& message);

  int descriptor_;
  std::string received_;  ///< The beginning of the next message.
};

/// As bytes. Images are lossless only if CImage::DISABLE_JPEG_COMPRESSION is set in the process that calls this.
[[nodiscard]] std::string packObservation(const mrpt::obs::CObservation3DRangeScan& observation);

/// Null where the bytes are something else.
[[nodiscard]] std::shared_ptr<mrpt::obs::CObservation3DRangeScan> unpackObservation(const std::string& bytes);

}  // namespace wardslam::sources

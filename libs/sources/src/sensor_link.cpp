#include "wardslam/sources/sensor_link.h"

#include <mrpt/io/CMemoryStream.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/serialization/CArchive.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <exception>

namespace wardslam::sources {
namespace {

/// Both ends are of one build on one machine, so the bytes go as they lie in memory.
struct Header {
  std::uint8_t kind;
  std::uint32_t size_bytes;
};
constexpr std::size_t kHeader_bytes = sizeof(std::uint8_t) + sizeof(std::uint32_t);

std::array<char, kHeader_bytes> encode(const Header& header) {
  std::array<char, kHeader_bytes> bytes{};
  std::memcpy(bytes.data(), &header.kind, sizeof header.kind);
  std::memcpy(bytes.data() + sizeof header.kind, &header.size_bytes, sizeof header.size_bytes);
  return bytes;
}

Header decode(const char* bytes) {
  Header header{};
  std::memcpy(&header.kind, bytes, sizeof header.kind);
  std::memcpy(&header.size_bytes, bytes + sizeof header.kind, sizeof header.size_bytes);
  return header;
}

bool writeAll(int descriptor, const char* bytes, std::size_t size) {
  while (size > 0) {
    const ssize_t written = write(descriptor, bytes, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes += written;
    size -= static_cast<std::size_t>(written);
  }
  return true;
}

}  // namespace

bool writeMessage(int descriptor, const SensorMessage& message) {
  const auto header =
      encode({static_cast<std::uint8_t>(message.kind), static_cast<std::uint32_t>(message.bytes.size())});
  return writeAll(descriptor, header.data(), header.size()) &&
         writeAll(descriptor, message.bytes.data(), message.bytes.size());
}

SensorMessageReader::SensorMessageReader(int descriptor) : descriptor_(descriptor) {}

SensorMessageReader::Status SensorMessageReader::read(SensorMessage& message, std::chrono::milliseconds patience) {
  using Clock = std::chrono::steady_clock;
  const auto deadline = Clock::now() + patience;
  while (!takeMessage(message)) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
    if (left.count() <= 0) return Status::Nothing;
    pollfd waiting{descriptor_, POLLIN, 0};
    if (poll(&waiting, 1, static_cast<int>(left.count())) <= 0) continue;

    constexpr std::size_t kAtOnce_bytes = 1U << 20U;
    const std::size_t before = received_.size();
    received_.resize(before + kAtOnce_bytes);
    const ssize_t got = ::read(descriptor_, received_.data() + before, kAtOnce_bytes);
    received_.resize(before + (got > 0 ? static_cast<std::size_t>(got) : 0));
    if (got == 0 || (got < 0 && errno != EINTR)) return Status::Closed;
  }
  return Status::Message;
}

bool SensorMessageReader::takeMessage(SensorMessage& message) {
  if (received_.size() < kHeader_bytes) return false;
  const Header header = decode(received_.data());
  const std::size_t total = kHeader_bytes + header.size_bytes;
  if (received_.size() < total) return false;
  message.kind = static_cast<SensorMessage::Kind>(header.kind);
  message.bytes.assign(received_, kHeader_bytes, header.size_bytes);
  received_.erase(0, total);
  return true;
}

std::string packObservation(const mrpt::obs::CObservation3DRangeScan& observation) {
  mrpt::io::CMemoryStream stream;
  auto archive = mrpt::serialization::archiveFrom(stream);
  archive << observation;
  return {static_cast<const char*>(stream.getRawBufferData()), stream.getTotalBytesCount()};
}

std::shared_ptr<mrpt::obs::CObservation3DRangeScan> unpackObservation(const std::string& bytes) {
  mrpt::io::CMemoryStream stream;
  stream.assignMemoryNotOwn(bytes.data(), bytes.size());
  auto archive = mrpt::serialization::archiveFrom(stream);
  try {
    return std::dynamic_pointer_cast<mrpt::obs::CObservation3DRangeScan>(archive.ReadObject());
  } catch (const std::exception&) {
    return nullptr;
  }
}

}  // namespace wardslam::sources

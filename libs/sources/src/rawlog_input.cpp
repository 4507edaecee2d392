#include "rawlog_input.h"

#include <algorithm>
#include <stdexcept>

namespace wardslam::sources {
namespace {

[[noreturn]] void failUnsupported() { throw std::logic_error("RawlogInput only reads on"); }

}  // namespace

RawlogInput::RawlogInput(const std::filesystem::path& file)
    : in_(openBytes(file)), size_bytes_(std::filesystem::file_size(file)) {}

double RawlogInput::fraction() const {
  if (size_bytes_ == 0) return 1.0;
  return std::min(1.0, static_cast<double>(in_->consumed_bytes()) / static_cast<double>(size_bytes_));
}

std::size_t RawlogInput::Read(void* to, std::size_t size) {
  auto* const first = static_cast<std::uint8_t*>(to);
  const std::size_t done = in_->read(first, size);
  position_bytes_ += done;
  remembered_.insert(remembered_.end(), first, first + done);
  return done;
}

std::size_t RawlogInput::Write(const void* /*from*/, std::size_t /*size*/) { failUnsupported(); }
std::uint64_t RawlogInput::Seek(std::int64_t /*offset*/, TSeekOrigin /*origin*/) { failUnsupported(); }
std::uint64_t RawlogInput::getTotalBytesCount() const { failUnsupported(); }

}  // namespace wardslam::sources

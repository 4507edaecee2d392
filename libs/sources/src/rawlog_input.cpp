#include "gzip_input.h"

#include <algorithm>
#include <climits>
#include <stdexcept>

#include "wardslam/core/errors.h"

namespace wardslam::sources {
namespace {

constexpr unsigned kBuffer_bytes = 1U << 17U;

[[noreturn]] void failUnsupported() { throw std::logic_error("GzipInput only reads on"); }

}  // namespace

GzipInput::GzipInput(const std::filesystem::path& file) : in_(nullptr, gzclose_r) {
  if (std::filesystem::is_regular_file(file)) in_.reset(gzopen(file.c_str(), "rb"));
  if (!in_) throw core::InputError(file.string() + ": cannot be opened as a rawlog file");
  gzbuffer(in_.get(), kBuffer_bytes);
  size_bytes_ = std::filesystem::file_size(file);
}

double GzipInput::fraction() const {
  if (size_bytes_ == 0) return 1.0;
  return std::min(1.0, static_cast<double>(gzoffset(in_.get())) / static_cast<double>(size_bytes_));
}

std::size_t GzipInput::Read(void* to, std::size_t size) {
  auto* const first = static_cast<std::uint8_t*>(to);
  std::size_t done = 0;
  while (done < size) {
    const auto step = static_cast<unsigned>(std::min<std::size_t>(size - done, INT_MAX));
    const int read = gzread(in_.get(), first + done, step);
    if (read <= 0) break;
    done += static_cast<std::size_t>(read);
  }
  remembered_.insert(remembered_.end(), first, first + done);
  return done;
}

std::uint64_t GzipInput::getPosition() const { return static_cast<std::uint64_t>(gztell(in_.get())); }

std::size_t GzipInput::Write(const void* /*from*/, std::size_t /*size*/) { failUnsupported(); }
std::uint64_t GzipInput::Seek(std::int64_t /*offset*/, TSeekOrigin /*origin*/) { failUnsupported(); }
std::uint64_t GzipInput::getTotalBytesCount() const { failUnsupported(); }

}  // namespace wardslam::sources

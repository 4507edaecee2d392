#include "work_file.h"

#include <openssl/evp.h>

#include <array>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>

#include "mapper_state_codec.h"
#include "wardslam/core/atomic_file.h"
#include "wardslam/core/blob.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/options.h"

namespace wardslam::merging {
namespace {

constexpr std::uint8_t kVersion = 1;
constexpr int kQuick = 1;  // of zstd's levels: the numbers hardly get smaller

/// SHA-256 of what is added.
class Digest {
 public:
  Digest() {
    if (EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) != 1) fail();
  }

  void add(const void* bytes, std::size_t size) {
    if (EVP_DigestUpdate(context_.get(), bytes, size) != 1) fail();
  }

  /// With its length, so that nothing can be taken for a part of what comes before it.
  void add(const std::string& text) {
    const auto size = static_cast<std::uint64_t>(text.size());
    add(&size, sizeof(size));
    add(text.data(), text.size());
  }

  [[nodiscard]] std::string value() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> bytes{};
    unsigned int length = 0;
    if (EVP_DigestFinal_ex(context_.get(), bytes.data(), &length) != 1) fail();
    return {bytes.begin(), bytes.begin() + length};
  }

 private:
  [[noreturn]] static void fail() { throw std::runtime_error("OpenSSL computes no SHA-256"); }

  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_{EVP_MD_CTX_new(), &EVP_MD_CTX_free};
};

void addFile(Digest& digest, const std::filesystem::path& file) {
  const std::uint64_t size = std::filesystem::file_size(file);
  digest.add(&size, sizeof(size));
  std::ifstream in(file, std::ios::binary);
  std::vector<char> buffer(std::size_t{1} << 20U);
  while (in.read(buffer.data(), static_cast<std::streamsize>(buffer.size())) || in.gcount() > 0)
    digest.add(buffer.data(), static_cast<std::size_t>(in.gcount()));
}

std::string digestOf(const std::vector<Run>& runs, const pipeline::SlamOptions& options) {
  Digest digest;
  digest.add(WARDSLAM_VERSION);
  digest.add(core::writeOptions(options.graph));
  digest.add(core::writeOptions(options.odometry));
  for (const Run& run : runs) addFile(digest, run.file);
  return digest.value();
}

std::optional<core::Bytes> bytesOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return std::nullopt;
  return core::Bytes{std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

WorkFile::WorkFile(const std::filesystem::path& out, const std::vector<Run>& runs, const pipeline::SlamOptions& options)
    : file_(out.string() + ".merging"), inputs_(digestOf(runs, options)) {}

std::optional<WorkDone> WorkFile::read() const {
  const auto bytes = bytesOf(file_);
  if (!bytes) return std::nullopt;
  try {
    const core::Bytes content = core::unpack(core::BlobKind::MergeWork, kVersion, *bytes);
    core::ByteReader in(content);
    std::string inputs(in.getCountOfAtLeast(1), '\0');
    in.getBytes(inputs.data(), inputs.size());
    if (inputs != inputs_) return std::nullopt;
    WorkDone done;
    done.run = in.get<std::uint64_t>();
    done.keyframes = in.get<std::uint64_t>();
    done.state = getMapperState(in);
    return done;
  } catch (const core::BlobError&) {
    return std::nullopt;  // it can be done anew
  }
}

void WorkFile::write(const WorkDone& done) const {
  core::ByteWriter out;
  out.put(static_cast<std::uint32_t>(inputs_.size()));
  out.putBytes(inputs_.data(), inputs_.size());
  out.put(static_cast<std::uint64_t>(done.run));
  out.put(static_cast<std::uint64_t>(done.keyframes));
  put(out, done.state);
  try {
    const core::Bytes packed = core::pack(core::BlobKind::MergeWork, kVersion, out.bytes(), kQuick);
    core::writeFileAtomically(file_, {packed.begin(), packed.end()});
  } catch (const core::BlobError&) {
    remove();  // of millions of points: more than could be read again
  }
}

void WorkFile::remove() const {
  std::error_code ignored;
  std::filesystem::remove(file_, ignored);
}

}  // namespace wardslam::merging

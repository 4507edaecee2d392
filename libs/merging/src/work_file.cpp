#include "work_file.h"

#include <fstream>
#include <iterator>

#include "mapper_state_codec.h"
#include "wardslam/core/atomic_file.h"
#include "wardslam/core/blob.h"
#include "wardslam/core/digest.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/options.h"

namespace wardslam::merging {
namespace {

constexpr std::uint8_t kVersion = 1;
constexpr int kQuick = 1;  // of zstd's levels: the numbers hardly get smaller

/// With its length, so that nothing can be taken for a part of what comes before it.
void addWithLength(core::Digest& digest, const std::string& text) {
  const auto size = static_cast<std::uint64_t>(text.size());
  digest.add(&size, sizeof(size));
  digest.add(text);
}

void addWithLength(core::Digest& digest, const std::filesystem::path& file) {
  const std::uint64_t size = std::filesystem::file_size(file);
  digest.add(&size, sizeof(size));
  digest.addFile(file);
}

std::string digestOf(const std::vector<Run>& runs, const pipeline::SlamOptions& options) {
  core::Digest digest;
  addWithLength(digest, std::string(WARDSLAM_VERSION));
  addWithLength(digest, core::writeOptions(options.graph));
  addWithLength(digest, core::writeOptions(options.odometry));
  for (const Run& run : runs) addWithLength(digest, run.file);
  return digest.result();
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

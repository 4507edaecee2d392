#include "file_chunks.h"

#include <fstream>
#include <set>

#include "digest.h"
#include "wardslam/core/atomic_file.h"
#include "wardslam/core/errors.h"

namespace wardslam::fleet {
namespace {

constexpr std::size_t kChunk_bytes = std::size_t{1} << 20U;

class ChunkReader {
 public:
  explicit ChunkReader(const std::filesystem::path& file) : file_(file), in_(file, std::ios::binary) {
    if (!in_) throw core::InputError(file.string() + ": cannot be read");
  }

  /// False at the end.
  [[nodiscard]] bool next(std::string& chunk) {
    chunk.resize(kChunk_bytes);
    in_.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
    if (in_.bad()) throw core::InputError(file_.string() + ": cannot be read to its end");
    chunk.resize(static_cast<std::size_t>(in_.gcount()));
    return !chunk.empty();
  }

 private:
  std::filesystem::path file_;
  std::ifstream in_;
};

std::vector<std::string> firstColumn(const pqxx::result& rows) {
  std::vector<std::string> values;
  for (const auto& row : rows) values.push_back(row[0].as<std::string>());
  return values;
}

std::vector<std::string> storedDigests(pqxx::transaction_base& transaction, std::int64_t map) {
  return firstColumn(execute(transaction, "SELECT digest FROM file_chunks WHERE map = $1 ORDER BY position", map));
}

/// "{a,b}", a parameter of type text[].
std::string arrayOf(const std::vector<std::string>& digests) {
  std::string text = "{";
  for (const auto& digest : digests) text += (text.size() > 1 ? "," : "") + digest;
  return text + "}";
}

std::set<std::string> digestsThere(pqxx::connection& connection, const std::vector<std::string>& digests) {
  pqxx::work transaction(connection);
  const auto found = firstColumn(
      execute(transaction, "SELECT digest FROM wardslam.chunks WHERE digest = ANY ($1::text[])", arrayOf(digests)));
  return {found.begin(), found.end()};
}

/// Pieces that no file is made of any more: those of before, and what a push sent that never came to its end.
void dropUnused(pqxx::transaction_base& transaction, const std::vector<std::string>& before) {
  execute(transaction,
          "DELETE FROM chunks WHERE digest IN (SELECT digest FROM chunks c "
          "WHERE (digest = ANY ($1::text[]) OR sent_at < now() - interval '7 days') "
          "AND NOT EXISTS (SELECT FROM file_chunks f WHERE f.digest = c.digest) FOR UPDATE SKIP LOCKED)",
          arrayOf(before));
}

}  // namespace

FileDigests digestsOf(const std::filesystem::path& file) {
  ChunkReader reader(file);
  FileDigests digests;
  DigestOfParts whole;
  for (std::string chunk; reader.next(chunk);) {
    digests.chunks.push_back(digestOf(chunk));
    whole.add(digests.chunks.back());
    digests.size_bytes += chunk.size();
  }
  digests.whole = whole.result();
  return digests;
}

void sendChunks(pqxx::connection& connection, const std::filesystem::path& file, const FileDigests& digests,
                const std::function<void(std::uint64_t)>& onSent) {
  auto there = digestsThere(connection, digests.chunks);
  ChunkReader reader(file);
  std::string chunk;
  for (std::size_t i = 0; i < digests.chunks.size() && reader.next(chunk); ++i) {
    if (!there.insert(digests.chunks[i]).second) continue;
    pqxx::work transaction(connection);
    execute(transaction, "INSERT INTO wardslam.chunks (digest, bytes) VALUES ($1, $2) ON CONFLICT DO NOTHING",
            digests.chunks[i], bytesParameter(chunk));
    transaction.commit();
    onSent(chunk.size());
  }
}

void makeFile(pqxx::transaction_base& transaction, std::int64_t map, const FileDigests& digests) {
  const auto before = storedDigests(transaction, map);
  execute(transaction,
          "INSERT INTO file_chunks (map, position, digest) SELECT $1, n.position - 1, n.digest "
          "FROM unnest($2::text[]) WITH ORDINALITY AS n(digest, position) "
          "ON CONFLICT (map, position) DO UPDATE SET digest = EXCLUDED.digest "
          "WHERE file_chunks.digest <> EXCLUDED.digest",
          map, arrayOf(digests.chunks));
  execute(transaction, "DELETE FROM file_chunks WHERE map = $1 AND position >= $2", map, digests.chunks.size());
  dropUnused(transaction, before);
}

void fetchFile(pqxx::transaction_base& transaction, std::int64_t map, const std::string& wholeDigest,
               const std::filesystem::path& file) {
  const std::size_t count = storedDigests(transaction, map).size();
  DigestOfParts whole;
  core::AtomicFile out(file);
  for (std::size_t i = 0; i < count; ++i) {
    const auto rows =
        execute(transaction,
                "SELECT bytes FROM file_chunks JOIN chunks USING (digest) WHERE map = $1 AND position = $2", map, i);
    const std::string chunk = rows.empty() ? std::string() : bytesOf(rows[0][0]);
    whole.add(digestOf(chunk));
    out.stream().write(chunk.data(), static_cast<std::streamsize>(chunk.size()));
  }
  if (whole.result() != wholeDigest) {
    throw core::InputError(file.string() + ": what the database holds is not what was pushed; push the map again");
  }
  out.commit();
}

}  // namespace wardslam::fleet

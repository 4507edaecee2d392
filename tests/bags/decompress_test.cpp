#include "decompress.h"

#include <bzlib.h>
#include <gmock/gmock.h>
#include <lz4frame.h>
#include <zstd.h>

#include "wardslam/bags/bag_damage.h"

namespace wardslam::bags {
namespace {

const Bytes kContent(3'000'000, 42);  // more than what is first made room for

Bytes packed(const std::string& coding) {
  Bytes bytes(kContent.size() + 1000);
  if (coding == "zstd") {
    bytes.resize(ZSTD_compress(bytes.data(), bytes.size(), kContent.data(), kContent.size(), 1));
  } else if (coding == "lz4") {
    bytes.resize(LZ4F_compressFrame(bytes.data(), bytes.size(), kContent.data(), kContent.size(), nullptr));
  } else {
    auto size = static_cast<unsigned>(bytes.size());
    BZ2_bzBuffToBuffCompress(reinterpret_cast<char*>(bytes.data()), &size,
                             const_cast<char*>(reinterpret_cast<const char*>(kContent.data())),
                             static_cast<unsigned>(kContent.size()), 1, 0, 0);
    bytes.resize(size);
  }
  return bytes;
}

class Decompress : public ::testing::TestWithParam<const char*> {};

TEST_P(Decompress, GivesBackWhatWasPacked) {
  EXPECT_EQ(decompress(GetParam(), packed(GetParam()), kContent.size()), kContent);
}

TEST_P(Decompress, RefusesWhatIsCutOff) {
  Bytes half = packed(GetParam());
  half.resize(half.size() / 2);
  EXPECT_THROW(decompress(GetParam(), half, kContent.size()), BagDamage);
  EXPECT_THROW(decompress(GetParam(), Bytes{}, kContent.size()), BagDamage);
}

TEST_P(Decompress, RefusesAnotherSizeThanItSays) {
  EXPECT_THROW(decompress(GetParam(), packed(GetParam()), kContent.size() - 1), BagDamage);
  EXPECT_THROW(decompress(GetParam(), packed(GetParam()), kContent.size() + 1), BagDamage);
  EXPECT_THROW(decompress(GetParam(), packed(GetParam()), UINT64_MAX), BagDamage);
}

TEST_P(Decompress, RefusesWhatIsNotPackedSo) { EXPECT_THROW(decompress(GetParam(), kContent, 100), BagDamage); }

INSTANTIATE_TEST_SUITE_P(Codings, Decompress, ::testing::Values("zstd", "lz4", "bz2"));

TEST(DecompressNothing, TakesThatAsItIs) {
  EXPECT_EQ(decompress("none", Bytes{1, 2}, 2), (Bytes{1, 2}));
  EXPECT_EQ(decompress("", Bytes{1, 2}, 2), (Bytes{1, 2}));
  EXPECT_THROW(decompress("none", Bytes{1, 2}, 3), BagDamage);
  EXPECT_THROW(decompress("snappy", Bytes{1, 2}, 2), BagDamage);
}

}  // namespace
}  // namespace wardslam::bags

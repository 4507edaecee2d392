#include "wardslam/core/blob.h"

#include <gtest/gtest.h>

namespace wardslam::core {
namespace {

TEST(ByteReader, GivesBackWhatWasPut) {
  ByteWriter out;
  out.put(std::uint32_t{7});
  out.put(2.5F);
  out.putBytes("abc", 3);
  ByteReader in(out.bytes());
  EXPECT_EQ(in.get<std::uint32_t>(), 7U);
  EXPECT_EQ(in.get<float>(), 2.5F);
  char text[3];
  in.getBytes(text, 3);
  EXPECT_EQ(std::string(text, 3), "abc");
}

TEST(ByteReader, NeverReadsBeyondTheEnd) {
  const Bytes three(3);
  ByteReader in(three);
  EXPECT_THROW((void)in.get<std::uint32_t>(), BlobError);
  EXPECT_EQ(in.get<std::uint16_t>(), 0);
  EXPECT_THROW((void)in.get<std::uint16_t>(), BlobError);
}

TEST(ByteReader, ACountMustMatchWhatFollows) {
  ByteWriter out;
  out.put(std::uint32_t{3});
  out.putBytes("123456", 6);
  EXPECT_EQ(ByteReader(out.bytes()).getCount(2), 3U);
  EXPECT_THROW((void)ByteReader(out.bytes()).getCount(3), BlobError);
  EXPECT_THROW((void)ByteReader(out.bytes()).getCount(1), BlobError);
}

TEST(Blob, UnpacksWhatWasPacked) {
  const Bytes content(1000, 42);
  const Bytes blob = pack(BlobKind::CloudTile, 1, content);
  EXPECT_LT(blob.size(), 100U);
  EXPECT_EQ(unpack(BlobKind::CloudTile, 1, blob), content);
  EXPECT_EQ(unpack(BlobKind::CloudTile, 1, pack(BlobKind::CloudTile, 1, {})), Bytes());
}

TEST(Blob, HoldsTheLargestFloorPlanThatIsDrawn) {
  constexpr std::size_t kCells = 400'000'000;
  Bytes blob;
  {
    const Bytes content(kCells, 42);
    blob = pack(BlobKind::FloorCells, 1, content);
  }
  blob.shrink_to_fit();
  EXPECT_EQ(unpack(BlobKind::FloorCells, 1, blob).size(), kCells);
}

TEST(Blob, RefusesAnotherKindOrVersion) {
  const Bytes blob = pack(BlobKind::CloudTile, 1, {1, 2, 3});
  EXPECT_THROW((void)unpack(BlobKind::Features, 1, blob), BlobError);
  EXPECT_THROW((void)unpack(BlobKind::CloudTile, 2, blob), BlobError);
}

TEST(Blob, NoticesEveryFlippedBitAndEveryCut) {
  Bytes content;
  for (int i = 0; i < 300; ++i) content.push_back(static_cast<std::uint8_t>(i * i));
  const Bytes blob = pack(BlobKind::Features, 1, content);
  for (std::size_t i = 0; i < blob.size(); ++i) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      Bytes flipped = blob;
      flipped[i] = static_cast<std::uint8_t>(flipped[i] ^ (1U << bit));
      try {
        EXPECT_EQ(unpack(BlobKind::Features, 1, flipped), content) << "byte " << i << " bit " << bit;
      } catch (const BlobError&) {
        continue;  // most of them; a few bits of the frame's head mean nothing
      }
    }
    EXPECT_THROW((void)unpack(BlobKind::Features, 1, Bytes(blob.begin(), blob.begin() + static_cast<long>(i))),
                 BlobError);
  }
}

}  // namespace
}  // namespace wardslam::core

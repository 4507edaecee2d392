#include <gmock/gmock.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/serialization/CArchive.h>

#include "semantic_map_encoding.h"
#include "support/hand_made_map.h"
#include "wardslam/mrpt_plugin/register_all.h"
#include "wardslam/mrpt_plugin/semantic_metric_map.h"

namespace wardslam::mrpt_plugin {
namespace {

using ::testing::HasSubstr;

std::string written(const CSemanticMap& map) {
  mrpt::io::CMemoryStream stream;
  auto archive = mrpt::serialization::archiveFrom(stream);
  archive << map;
  return {static_cast<const char*>(stream.getRawBufferData()), stream.getTotalBytesCount()};
}

mrpt::serialization::CSerializable::Ptr read(const std::string& bytes) {
  mrpt::io::CMemoryStream stream(bytes.data(), bytes.size());
  return mrpt::serialization::archiveFrom(stream).ReadObject();
}

class SemanticMapSerialization : public ::testing::Test {
 protected:
  SemanticMapSerialization() {
    registerAll();
    map.insertionOptions.cloud.voxel_m = 0.04;
    map.likelihoodOptions.sigma_m = 0.2;
    map.renderOptions.names = false;
    map.genericMapParams.enableObservationInsertion = false;
  }
  CSemanticMap map{test::makeWard()};
};

TEST_F(SemanticMapSerialization, GivesAllBack) {
  const auto back = std::dynamic_pointer_cast<CSemanticMap>(read(written(map)));
  ASSERT_TRUE(back);
  EXPECT_EQ(encode(back->map()), encode(map.map()));
  EXPECT_EQ(back->insertionOptions.cloud.voxel_m, 0.04);
  EXPECT_EQ(back->likelihoodOptions.sigma_m, 0.2);
  EXPECT_FALSE(back->renderOptions.names);
  EXPECT_FALSE(back->genericMapParams.enableObservationInsertion);
  ASSERT_TRUE(back->map().keyframes.at(2).ground);
  EXPECT_EQ(back->map().keyframes.at(2).ground->height_m, map.map().keyframes.at(2).ground->height_m);
  EXPECT_EQ(back->map().keyframes.at(2).ground->covariance, map.map().keyframes.at(2).ground->covariance);
  EXPECT_FALSE(back->map().keyframes.at(3).ground);
  EXPECT_EQ(back->objects().at(3).zone, map.objects().at(3).zone);
  EXPECT_EQ(back->map().cloud.at(2).points.at(7).p_cam_m, map.map().cloud.at(2).points.at(7).p_cam_m);
}

TEST_F(SemanticMapSerialization, GivesBackWhatZonesAskOfRobots) {
  mapping::SemanticMap ward = test::makeWard();
  ward.zones[0].type = mapping::ZoneType::OneWay;
  ward.zones[0].direction_rad = -0.75;
  ward.zones[1].type = mapping::ZoneType::Action;
  ward.zones[1].actions = {{"ring", "dim"}, {}, {"hush"}};
  const auto back = decodeSemanticMap(encode(ward));
  EXPECT_EQ(back.zones[0].type, mapping::ZoneType::OneWay);
  EXPECT_EQ(back.zones[0].direction_rad, -0.75);
  EXPECT_EQ(back.zones[1].actions.entry, ward.zones[1].actions.entry);
  EXPECT_TRUE(back.zones[1].actions.inside.empty());
  EXPECT_EQ(back.zones[1].actions.exit, ward.zones[1].actions.exit);
}

/// A zone's rule is 1 + 8 + 8 + 3 x 4 bytes, which the first layout did not have.
TEST_F(SemanticMapSerialization, ReadsTheLayoutInWhichZonesWereNames) {
  mapping::SemanticMap ward = test::makeWard();
  ward.zones.resize(1);
  core::Bytes bytes = encode(ward);
  const std::size_t plan = 3 * sizeof(double) + 2 * sizeof(std::uint32_t) + ward.floorPlan.cells.total();
  const auto end = bytes.end() - static_cast<std::ptrdiff_t>(plan);
  bytes.erase(end - (1 + 8 + 8 + 3 * 4), end);
  bytes[0] = 1;
  const auto back = decodeSemanticMap(bytes);
  ASSERT_EQ(back.zones.size(), 1U);
  EXPECT_EQ(back.zones[0].polygon_m, ward.zones[0].polygon_m);
  EXPECT_EQ(back.zones[0].type, mapping::ZoneType::Place);
  EXPECT_EQ(back.floorPlan.resolution_m, ward.floorPlan.resolution_m);
}

TEST_F(SemanticMapSerialization, RefusesWhatIsCutOffOrNewer) {
  const std::string whole = written(map);
  for (std::size_t size = 30; size < whole.size(); size += 97) {
    EXPECT_THROW(static_cast<void>(read(whole.substr(0, size))), std::exception) << size;
  }
  std::string newer = whole;
  const std::string name = "wardslam::mrpt_plugin::CSemanticMap";
  newer[newer.find(name) + name.size()] = 9;
  try {
    static_cast<void>(read(newer));
    FAIL();
  } catch (const std::exception& error) {
    EXPECT_THAT(error.what(), HasSubstr("newer WardSLAM"));
  }
}

TEST_F(SemanticMapSerialization, DamageIsFoundOrHarmless) {
  const core::Bytes whole = encode(map.map());
  for (std::size_t at = 0; at < whole.size(); at += 13) {
    core::Bytes damaged = whole;
    damaged[at] = static_cast<std::uint8_t>(~damaged[at]);
    try {
      static_cast<void>(CSemanticMap(decodeSemanticMap(damaged)).asString());
    } catch (const core::BlobError&) {
      continue;
    }
  }
}

}  // namespace
}  // namespace wardslam::mrpt_plugin

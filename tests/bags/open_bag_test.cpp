// Recordings of other programs: see make_data/README.md.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>

#include "bag_writing.h"
#include "support/complaint.h"
#include "support/temporary_folder.h"
#include "wardslam/bags/bag_reader.h"
#include "wardslam/bags/image_decoding.h"
#include "wardslam/bags/messages.h"
#include "wardslam/core/errors.h"

namespace wardslam::bags {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr std::int64_t kFirst_ns = 1700000000'000000000;

fs::path data(const std::string& name) { return fs::path(WARDSLAM_BAGS_DATA) / name; }

std::map<std::string, std::size_t> messagesOf(const BagReader& bag) {
  std::map<std::string, std::size_t> counts;
  for (const Topic& topic : bag.topics()) counts[topic.name + " " + topic.type] = topic.messages;
  return counts;
}

/// All images of a kind that can be read.
std::vector<Bytes> messagesOn(BagReader& bag, const std::string& part, Topic& topic) {
  std::vector<Bytes> messages;
  for (std::size_t i = 0; i < bag.entries().size(); ++i) {
    const Topic& candidate = bag.topics()[bag.entries()[i].topic];
    if (candidate.name.find(part) == std::string::npos) continue;
    topic = candidate;
    messages.push_back(bag.read(i));
  }
  return messages;
}

/// As make_data/prepare.py paints them.
void expectScene(BagReader& bag, std::size_t frames) {
  Topic topic;
  const auto colors = messagesOn(bag, "/color/image_raw", topic);
  ASSERT_THAT(colors, SizeIs(frames));
  for (const Bytes& message : colors) {
    const bool isCompressed = topic.type == "sensor_msgs/CompressedImage";
    const cv::Mat image = isCompressed ? decodeColor(readCompressedImage(message, topic.wire))
                                       : decodeColor(readImage(message, topic.wire));
    ASSERT_EQ(image.size(), cv::Size(64, 48));
    EXPECT_EQ(image.at<cv::Vec3b>(9, 0), cv::Vec3b(45, 0, 200));  // y / 8 is odd: red 200, green 4 x, blue 5 y
    EXPECT_EQ(image.at<cv::Vec3b>(0, 0), cv::Vec3b(120, 80, 40));
  }
  const auto depths = messagesOn(bag, "depth", topic);
  ASSERT_THAT(depths, SizeIs(frames));
  for (std::size_t i = 0; i < frames; ++i) {
    const bool isCompressed = topic.type == "sensor_msgs/CompressedImage";
    const DepthImage depth = isCompressed ? decodeDepth(readCompressedImage(depths[i], topic.wire))
                                          : decodeDepth(readImage(depths[i], topic.wire));
    EXPECT_EQ(depth.units.at<std::uint16_t>(5, 1), 0);
    const double z_m = depth.units.at<std::uint16_t>(5, 10) * depth.unit_m;
    EXPECT_NEAR(z_m, 1.1 + 0.1 * static_cast<double>(i), 1e-6) << i;
  }
}

class OpenBag : public ::testing::TestWithParam<const char*> {};

TEST_P(OpenBag, ReadsWhatOthersWrote) {
  ASSERT_TRUE(isBag(data(GetParam())));
  const auto bag = openBag(data(GetParam()));
  EXPECT_THAT(bag->damage(), IsEmpty());
  const auto counts = messagesOf(*bag);
  EXPECT_EQ(counts.at("/camera/color/camera_info sensor_msgs/CameraInfo"), 3U);
  for (std::size_t i = 1; i < bag->entries().size(); ++i) {
    EXPECT_LE(bag->entries()[i - 1].logged_ns, bag->entries()[i].logged_ns);
  }
  EXPECT_EQ(bag->entries().front().logged_ns, kFirst_ns);
  expectScene(*bag, 3);
}

INSTANTIATE_TEST_SUITE_P(Writers, OpenBag,
                         ::testing::Values("none.bag", "bz2.bag", "lz4.bag", "compressed.bag", "none.mcap", "zstd.mcap",
                                           "lz4.mcap", "no_index.mcap", "unchunked.mcap", "float.mcap", "sqlite",
                                           "sqlite_zstd"),
                         [](const auto& about) {
                           std::string name = about.param;
                           for (char& letter : name) letter = letter == '.' ? '_' : letter;
                           return name;
                         });

TEST(OpenBagContent, HasTheMessagesOfTheRobot) {
  for (const char* name : {"none.bag", "none.mcap", "sqlite"}) {
    const auto bag = openBag(data(name));
    const auto counts = messagesOf(*bag);
    EXPECT_EQ(counts.at("/odom nav_msgs/Odometry"), 3U) << name;
    EXPECT_EQ(counts.at("/tf_static tf2_msgs/TFMessage"), 1U) << name;
    Topic topic;
    const auto odometries = messagesOn(*bag, "/odom", topic);
    const Odometry odometry = readOdometry(odometries.back(), topic.wire);
    EXPECT_EQ(odometry.child, "base_link");
    EXPECT_EQ(odometry.T_odom_child.translation(), Eigen::Vector3d(1, 0, 0));
    EXPECT_EQ(odometry.velocity_mps, Eigen::Vector3d(0.25, 0, 0));
    EXPECT_EQ(odometry.angularVelocity_radps, Eigen::Vector3d(0, 0, -0.125));
    const auto imus = messagesOn(*bag, "/imu", topic);
    const Imu imu = readImu(imus.front(), topic.wire);
    EXPECT_FALSE(imu.orientation);
    EXPECT_EQ(imu.acceleration_mps2.value(), Eigen::Vector3d(0, 0, 9.75));
    const auto infos = messagesOn(*bag, "info", topic);
    const CameraInfo info = readCameraInfo(infos.front(), topic.wire);
    EXPECT_EQ(info.width_px, 64U);
    EXPECT_EQ(info.distortionModel, "plumb_bob");
    EXPECT_EQ(info.k[0], 52.5);
    EXPECT_EQ(info.p[6], 23.5);
  }
}

TEST(OpenBagContent, ReadsABagWhoseRecorderWasKilled) {
  const auto bag = openBag(data("unclosed.bag"));
  ASSERT_THAT(bag->damage(), SizeIs(1));
  EXPECT_EQ(bag->damage().front().event(), "sources.bag_truncated");
  expectScene(*bag, 2);  // the last was in a chunk that was not complete
}

TEST(OpenBagContent, AFileAloneIsABagToo) {
  const auto bag = openBag(data("sqlite/sqlite_1.db3"));
  EXPECT_EQ(messagesOf(*bag).at("/odom nav_msgs/Odometry"), 2U);
}

TEST(OpenBagContent, AFolderNeedsNoMetadata) {
  const test::TemporaryFolder folder;
  for (const char* name : {"sqlite_0.db3", "sqlite_1.db3"}) fs::copy(data("sqlite") / name, folder.path() / name);
  ASSERT_TRUE(isBag(folder.path()));
  expectScene(*openBag(folder.path()), 3);
}

TEST(OpenBagContent, NamesAFileThatIsMissing) {
  const test::TemporaryFolder folder;
  for (const char* name : {"sqlite_0.db3", "metadata.yaml"}) fs::copy(data("sqlite") / name, folder.path() / name);
  EXPECT_THAT(test::complaintOf([&] { return openBag(folder.path()); }),
              AllOf(HasSubstr("sqlite_1.db3"), HasSubstr("is missing"), HasSubstr("metadata.yaml")));
}

TEST(OpenBagContent, NamesOtherVersionsAndOtherFiles) {
  const test::TemporaryFolder folder;
  EXPECT_THAT(test::complaintOf([&] { return openBag(folder.write("old.bag", "#ROSBAG V1.2\n")); }),
              HasSubstr("rosbag fix"));
  EXPECT_THAT(test::complaintOf([&] { return openBag(folder.write("a.txt", "hello")); }),
              HasSubstr("no recording of ROS"));
  EXPECT_FALSE(isBag(folder.write("b.txt", "hello")));
  EXPECT_FALSE(isBag(folder.path()));
}

/// The first bytes of a recording, as a crash or a full disk leaves it.
std::string beginning(const std::string& name, std::uintmax_t bytes) {
  std::ifstream in(data(name), std::ios::binary);
  std::string text(bytes, '\0');
  in.read(text.data(), static_cast<std::streamsize>(bytes));
  return text;
}

// Whatever byte a file ends at: no crash, never more than was there, and the fault is told.
TEST(OpenBagContent, ReadsAllCompleteChunksOfAFileThatWasCutOff) {
  const test::TemporaryFolder folder;
  for (const char* name : {"lz4.bag", "lz4.mcap", "zstd.mcap", "unchunked.mcap", "no_index.mcap"}) {
    const std::uintmax_t size = fs::file_size(data(name));
    std::vector<std::uintmax_t> ends = {size - 30};  // in what sums up the file
    for (std::uintmax_t end = size - 499; end > 16; end -= std::min<std::uintmax_t>(end, 1499))
      ends.insert(ends.begin(), end);
    std::size_t before = 0;
    for (const std::uintmax_t end : ends) {
      const auto bag = openBag(folder.write("cut", beginning(name, end)));
      const bool isTold = !bag->damage().empty();
      std::size_t read = 0;
      for (std::size_t i = 0; i < bag->entries().size(); ++i) read += bag->read(i).empty() ? 0 : 1;
      EXPECT_TRUE(isTold || read == 9 || read == 0) << name << " " << end;
      EXPECT_GE(read, before) << name << " " << end;
      before = read;
    }
    EXPECT_EQ(before, 9U) << name;
  }
}

// The pages of a database that was cut off: whichever are there.
TEST(OpenBagContent, ReadsWhatIsLeftOfADatabaseThatWasCutOff) {
  const test::TemporaryFolder folder;
  const std::string name = "sqlite/sqlite_0.db3";
  const std::uintmax_t size = fs::file_size(data(name));
  const std::size_t whole = openBag(data(name))->entries().size();
  std::size_t most = 0;
  bool isSomeRead = false;
  for (std::uintmax_t end = 0; end < size; end += 1024) {
    const auto file = folder.write("cut.db3", beginning(name, end));
    std::size_t read = 0;
    std::string complaint;
    try {
      const auto bag = openBag(file);
      if (!bag->damage().empty()) complaint = bag->damage().front().what();
      for (std::size_t i = 0; i < bag->entries().size(); ++i) {
        try {
          read += bag->read(i).empty() ? 0 : 1;
        } catch (const BagDamage& damage) {
          complaint = damage.what();
        }
      }
    } catch (const core::InputError& error) {
      complaint = error.what();
    }
    EXPECT_NE(complaint, "") << end << " of " << size;
    EXPECT_LE(read, whole);
    isSomeRead = isSomeRead || read > 0;
    most = std::max(most, read);
  }
  EXPECT_TRUE(isSomeRead);
  EXPECT_LT(most, whole);
}

TEST(OpenBagContent, AChunkWithAWrongByteIsLeftOut) {
  const test::TemporaryFolder folder;
  std::string text = beginning("none.mcap", fs::file_size(data("none.mcap")));
  text[text.size() / 2] = static_cast<char>(text[text.size() / 2] ^ 1);
  const auto bag = openBag(folder.write("wrong.mcap", text));
  std::size_t read = 0;
  std::string complaint;
  for (std::size_t i = 0; i < bag->entries().size(); ++i) {
    try {
      read += bag->read(i).empty() ? 0 : 1;
    } catch (const BagDamage& damage) {
      complaint = damage.what();
    }
  }
  EXPECT_THAT(complaint, HasSubstr("CRC-32"));
  EXPECT_GT(read, 0U);
  EXPECT_LT(read, bag->entries().size());
}

// Every byte set to 255 in turn, sizes among them: nothing is allocated for what is not there, and nothing crashes.
TEST(OpenBagContent, BelievesNoSize) {
  const test::TemporaryFolder folder;
  for (const char* name : {"lz4.bag", "zstd.mcap", "unchunked.mcap"}) {
    const std::string sound = beginning(name, fs::file_size(data(name)));
    for (std::size_t at = 13; at < sound.size(); at += at < 2000 ? 13 : 1997) {
      std::string text = sound;
      text[at] = static_cast<char>(0xFF);
      const auto bag = openBag(folder.write("wrong", text));
      for (std::size_t i = 0; i < bag->entries().size(); ++i) {
        try {
          EXPECT_LE(bag->read(i).size(), std::size_t{1} << 20U);
        } catch (const BagDamage&) {
          continue;
        }
      }
    }
  }
}

}  // namespace
}  // namespace wardslam::bags

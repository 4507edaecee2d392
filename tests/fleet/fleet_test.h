#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <exception>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "support/complaint.h"
#include "support/database_server.h"
#include "support/hand_made_map.h"
#include "support/temporary_folder.h"
#include "wardslam/fleet/database.h"
#include "wardslam/fleet/push.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::fleet {

/// `act(1)` to `act(threads)`, each in a thread of its own.
template <class Act>
void atOnce(int threads, const Act& act) {
  std::vector<std::thread> all;
  for (int number = 1; number <= threads; ++number) {
    all.emplace_back([&act, number] {
      try {
        act(number);
      } catch (const std::exception& error) {
        ADD_FAILURE() << error.what();
      }
    });
  }
  for (auto& thread : all) thread.join();
}

/// One server for all tests of this program, a database with the schema for each of them.
class FleetTest : public testing::Test {
 protected:
  static test::DatabaseServer& server() {
    static const auto one = std::make_unique<test::DatabaseServer>();
    return *one;
  }

  void SetUp() override {
    if (const auto why = test::DatabaseServer::whyNot(); !why.empty()) GTEST_SKIP() << why;
    static int number = 0;
    if (number++ == 0) (void)prepareDatabase(server().make("prepared"));
    database_ = "test" + std::to_string(number);
    url_ = server().make(database_, "prepared");
  }

  [[nodiscard]] std::string sql(const std::string& statement) const {
    return server().sql(database_, "SET search_path = wardslam, public; " + statement);
  }
  [[nodiscard]] int count(const std::string& table) const { return std::stoi(sql("SELECT count(*) FROM " + table)); }

  /// Rows of all tables that grow.
  [[nodiscard]] std::string counts() const {
    std::string text;
    for (const char* table : {"robots", "storeys", "maps", "keyframes", "runs", "zones", "objects", "sightings",
                              "changes", "pushes", "labels", "floor_plans", "file_chunks", "chunks"}) {
      text += std::string(table) + " " + std::to_string(count(table)) + "\n";
    }
    return text;
  }

  /// Writes the ward as it is now, and pushes it.
  PushReport pushWard(const MapIdentity& identity = {"robot 1", "ward", "north", "1"}) {
    writeWard();
    return push(url_, identity, file_);
  }
  void writeWard() const { (void)storage::MapFile::create(file_, {ward_.labels, ""}, storage::everythingOf(ward_)); }

  /// A keyframe more, so many seconds later.
  void drive(double seconds) {
    const auto& [id, last] = *ward_.keyframes.rbegin();
    mapping::MappedKeyframe next = last;
    next.stamp_s += seconds;
    next.T_map_cam.translation().x() += 0.25;
    ward_.keyframes[id + 1] = next;
  }

  test::TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "ward.wardmap";
  mapping::SemanticMap ward_ = test::makeWard();
  std::string database_;
  std::string url_;
};

}  // namespace wardslam::fleet

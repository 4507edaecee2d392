#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <opencv2/core.hpp>
#include <vector>

#include "wardslam/odometry/descriptor_words.h"
#include "wardslam/odometry/keyframe.h"

namespace wardslam::graph {

/// Finds binary descriptors that look much alike, by locality-sensitive hashing (Gionis, Indyk, Motwani: "Similarity
/// search in high dimensions via hashing", 1999): two that are near each other agree in all bits of a key, in one of
/// several tables at least. Adding and removing some costs what they are, not what is there.
class DescriptorIndex {
 public:
  DescriptorIndex();

  /// All of a keyframe, once: rows of 32 bytes (CV_8UC1); anything else throws cv::Exception.
  void add(odometry::KeyframeId keyframe, const cv::Mat& descriptors);
  void remove(odometry::KeyframeId keyframe);

  struct Neighbour {
    int distance = 0;  ///< Bits that differ.
    odometry::KeyframeId keyframe = 0;
  };

  /// The `count` nearest that are found among those no farther than that, nearest first; of equals, those that came
  /// first. `descriptor`: 32 bytes.
  [[nodiscard]] std::vector<Neighbour> nearest(const std::uint8_t* descriptor, std::size_t count,
                                               int mostDistance) const;

  [[nodiscard]] std::size_t size() const { return keyframeOf_.size() - gone_; }

 private:
  static constexpr std::size_t kTables = 12;
  static constexpr std::size_t kKeyBits = 15;

  using Words = odometry::DescriptorWords;
  using Row = std::uint32_t;

  struct Table {
    std::array<std::uint8_t, kKeyBits> bits{};  ///< Of a descriptor, those that make a key.
    std::vector<std::vector<Row>> buckets;      ///< By key.
  };

  struct Rows {
    Row first = 0;
    Row count = 0;
  };

  [[nodiscard]] static std::size_t keyOf(const Words& words, const Table& table);
  void enter(odometry::KeyframeId keyframe, const Words& words);
  void dropGone();

  std::array<Table, kTables> tables_;
  std::vector<Words> words_;                      ///< Per row.
  std::vector<odometry::KeyframeId> keyframeOf_;  ///< Per row; 0: gone.
  std::map<odometry::KeyframeId, Rows> rowsOf_;
  std::size_t gone_ = 0;                         ///< Rows that are left out, and dropped when they are many.
  mutable std::vector<std::uint32_t> lookedAt_;  ///< Per row: the last search that did.
  mutable std::uint32_t searches_ = 0;
};

}  // namespace wardslam::graph

#include "descriptor_index.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <utility>

namespace wardslam::graph {
namespace {

constexpr std::size_t kDescriptorBits = 256;

}  // namespace

/// Which bits make a key does not matter, as long as they are the same in every run.
DescriptorIndex::DescriptorIndex() {
  std::mt19937 random(1);  // NOLINT(cert-msc51-cpp)
  std::array<std::uint8_t, kDescriptorBits> bits{};
  std::iota(bits.begin(), bits.end(), std::uint8_t{0});
  for (Table& table : tables_) {
    for (std::size_t i = 0; i < kKeyBits; ++i) std::swap(bits[i], bits[i + random() % (kDescriptorBits - i)]);
    std::copy_n(bits.begin(), kKeyBits, table.bits.begin());
    table.buckets.resize(std::size_t{1} << kKeyBits);
  }
}

std::size_t DescriptorIndex::keyOf(const Words& words, const Table& table) {
  std::size_t key = 0;
  for (const std::uint8_t bit : table.bits) key = key << 1U | (words[bit / 64U] >> bit % 64U & 1U);
  return key;
}

void DescriptorIndex::enter(odometry::KeyframeId keyframe, const Words& words) {
  const auto row = static_cast<Row>(words_.size());
  words_.push_back(words);
  keyframeOf_.push_back(keyframe);
  lookedAt_.push_back(0);
  ++rowsOf_.try_emplace(keyframe, Rows{row, 0}).first->second.count;
  for (Table& table : tables_) table.buckets[keyOf(words, table)].push_back(row);
}

void DescriptorIndex::add(odometry::KeyframeId keyframe, const cv::Mat& descriptors) {
  CV_Assert(descriptors.empty() || (descriptors.type() == CV_8UC1 && descriptors.cols == sizeof(Words)));
  for (int i = 0; i < descriptors.rows; ++i) {
    enter(keyframe, odometry::wordsOf(descriptors.ptr(i)));
  }
}

void DescriptorIndex::remove(odometry::KeyframeId keyframe) {
  const auto rows = rowsOf_.extract(keyframe);
  if (rows.empty()) return;
  const auto [first, count] = rows.mapped();
  std::fill_n(keyframeOf_.begin() + first, count, odometry::KeyframeId{0});
  gone_ += count;
  if (2 * gone_ > keyframeOf_.size()) dropGone();
}

void DescriptorIndex::dropGone() {
  const auto words = std::exchange(words_, {});
  const auto keyframeOf = std::exchange(keyframeOf_, {});
  lookedAt_.clear();
  rowsOf_.clear();
  gone_ = 0;
  for (Table& table : tables_) {
    for (auto& bucket : table.buckets) bucket.clear();
  }
  for (std::size_t row = 0; row < words.size(); ++row) {
    if (keyframeOf[row] != 0) enter(keyframeOf[row], words[row]);
  }
}

std::vector<DescriptorIndex::Neighbour> DescriptorIndex::nearest(const std::uint8_t* descriptor, std::size_t count,
                                                                 int mostDistance) const {
  const Words words = odometry::wordsOf(descriptor);
  const std::uint32_t search = ++searches_;
  std::vector<std::pair<int, Row>> best;  // nearest first
  for (const Table& table : tables_) {
    for (const Row row : table.buckets[keyOf(words, table)]) {
      if (std::exchange(lookedAt_[row], search) == search || keyframeOf_[row] == 0) continue;
      const std::pair found(odometry::differingBits(words, words_[row]), row);
      if (found.first > mostDistance || (best.size() == count && !(found < best.back()))) continue;
      if (best.size() == count) best.pop_back();
      best.insert(std::upper_bound(best.begin(), best.end(), found), found);
    }
  }
  std::vector<Neighbour> neighbours;
  for (const auto& [distance, row] : best) neighbours.push_back({distance, keyframeOf_[row]});
  return neighbours;
}

}  // namespace wardslam::graph

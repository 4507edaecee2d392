#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>

namespace mrpt::serialization {
class CSerializable;
}

namespace wardslam::rawlog_cut {

/// What is in a rawlog.
struct Tally {
  std::size_t objects = 0;
  std::map<std::string, std::size_t> observations;  ///< By label of the sensor; comments are not counted.

  void add(const std::shared_ptr<mrpt::serialization::CSerializable>& object);
};

[[nodiscard]] bool operator==(const Tally& a, const Tally& b);

}  // namespace wardslam::rawlog_cut

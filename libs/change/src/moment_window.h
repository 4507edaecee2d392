#pragma once

#include <algorithm>
#include <array>
#include <deque>
#include <utility>
#include <vector>

namespace wardslam::change {

/// Moments of the last while, in order of time, to compare the present with. A Moment has a `stamp_s`.
template <class Moment>
class MomentWindow {
 public:
  /// Nothing younger than `shortest_s` is worth comparing with.
  explicit MomentWindow(double length_s, double shortest_s = 0.0) : length_s_(length_s), shortest_s_(shortest_s) {}

  /// Time is `stamp_s` now: drops what is older than the window; all of it after a step back in time.
  void advanceTo(double stamp_s) {
    if (!empty() && stamp_s <= newest().stamp_s) clear();
    while (!empty() && stamp_s - oldest().stamp_s > length_s_) moments_.pop_front();
  }

  /// A moment later than all that are here.
  void add(Moment moment) { moments_.push_back(std::move(moment)); }
  void clear() { moments_.clear(); }

  [[nodiscard]] bool empty() const { return moments_.empty(); }
  [[nodiscard]] const Moment& oldest() const { return moments_.front(); }
  [[nodiscard]] const Moment& newest() const { return moments_.back(); }

  /// Age of a moment as a share of the window.
  [[nodiscard]] double baseline(const Moment& past, double stamp_s) const {
    return (stamp_s - past.stamp_s) / length_s_;
  }

  /// The moments to compare `stamp_s` with, the oldest first, each once: what is slow needs long, what has just begun
  /// to move a short time.
  [[nodiscard]] std::vector<const Moment*> references(double stamp_s) const {
    constexpr std::array<double, 3> kShares = {1.0, 0.4, 0.2};  // of the window
    std::vector<const Moment*> chosen;
    for (const double share : kShares) {
      const auto found = std::find_if(moments_.begin(), moments_.end(), [&](const Moment& moment) {
        return stamp_s - moment.stamp_s <= share * length_s_;
      });
      if (found == moments_.end() || stamp_s - found->stamp_s < shortest_s_) continue;
      if (chosen.empty() || chosen.back() != &*found) chosen.push_back(&*found);
    }
    return chosen;
  }

 private:
  double length_s_;
  double shortest_s_;
  std::deque<Moment> moments_;
};

}  // namespace wardslam::change

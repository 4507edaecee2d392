#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>

namespace mrpt::obs {
class CObservation;
}
namespace mrpt::serialization {
class CSerializable;
}

namespace wardslam::rawlog_cut {

/// A time as it is given on the command line: "1305031102.5" (UNIX seconds), or "+12.5" since the first observation.
struct Moment {
  double value_s = 0.0;
  bool isSinceBegin = false;

  /// Throws core::InputError where the text is neither.
  [[nodiscard]] static Moment parse(const std::string& text);
};

/// What of a rawlog is wanted. What comes from no sensor always is: comments, and objects that are no observations;
/// robot actions are judged by their time alone. What has no time is wanted at all times.
struct Selection {
  std::optional<Moment> from;    ///< This moment included.
  std::optional<Moment> to;      ///< This moment included.
  std::set<std::string> keep;    ///< Labels of sensors; all unless given.
  std::set<std::string> remove;  ///< Labels of sensors.
};

enum class Verdict { Whole, Part, Nothing };

/// Judges the objects of one rawlog, in their order.
class Judge {
 public:
  explicit Judge(Selection selection) : selection_(std::move(selection)) {}

  /// Part: of a sensory frame, from which what is not wanted is taken out.
  [[nodiscard]] Verdict judge(mrpt::serialization::CSerializable& object);

 private:
  [[nodiscard]] bool wants(const mrpt::obs::CObservation& observation);
  [[nodiscard]] bool isAtWantedTime(double stamp_s);

  Selection selection_;
  std::optional<double> begin_s_;
};

}  // namespace wardslam::rawlog_cut

#include "selection.h"

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"

namespace wardslam::rawlog_cut {
namespace {

using mrpt::obs::CActionCollection;
using mrpt::obs::CObservation;
using mrpt::obs::CSensoryFrame;

}  // namespace

Moment Moment::parse(const std::string& text) {
  Moment moment;
  moment.isSinceBegin = !text.empty() && text.front() == '+';
  const std::string_view number = std::string_view(text).substr(moment.isSinceBegin ? 1 : 0);
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), moment.value_s);
  if (error != std::errc() || end != number.data() + number.size() || !std::isfinite(moment.value_s)) {
    throw core::InputError("'" + text + "' is no time; give UNIX seconds (1305031102.5), or seconds since the first " +
                           "observation with a plus sign (+12.5)");
  }
  return moment;
}

bool Judge::isAtWantedTime(double stamp_s) {
  if (!begin_s_) begin_s_ = stamp_s;
  const auto inUnixTime = [&](const Moment& moment) {
    return moment.value_s + (moment.isSinceBegin ? *begin_s_ : 0.0);
  };
  constexpr double kHalfMicrosecond_s = 0.5e-6;  // times are told with six digits
  if (selection_.from && stamp_s < inUnixTime(*selection_.from) - kHalfMicrosecond_s) return false;
  return !selection_.to || stamp_s <= inUnixTime(*selection_.to) + kHalfMicrosecond_s;
}

bool Judge::wants(const CObservation& observation) {
  if (dynamic_cast<const mrpt::obs::CObservationComment*>(&observation) != nullptr) return true;
  const std::string& label = observation.sensorLabel;
  // First, so that the first of all observations is where the time begins.
  const bool isInTime =
      observation.timestamp == INVALID_TIMESTAMP || isAtWantedTime(core::fromMrptTime(observation.timestamp));
  return isInTime && selection_.remove.count(label) == 0 &&
         (selection_.keep.empty() || selection_.keep.count(label) > 0);
}

Verdict Judge::judge(mrpt::serialization::CSerializable& object) {
  if (const auto* observation = dynamic_cast<const CObservation*>(&object)) {
    return wants(*observation) ? Verdict::Whole : Verdict::Nothing;
  }
  if (auto* frame = dynamic_cast<CSensoryFrame*>(&object)) {
    const std::size_t before = frame->size();
    for (auto it = frame->begin(); it != frame->end();) it = wants(**it) ? std::next(it) : frame->erase(it);
    if (frame->size() == before) return Verdict::Whole;
    return frame->size() == 0 ? Verdict::Nothing : Verdict::Part;
  }
  if (const auto* actions = dynamic_cast<const CActionCollection*>(&object)) {
    const bool isWanted =
        actions->begin() == actions->end() || std::any_of(actions->begin(), actions->end(), [&](const auto& action) {
          return action->timestamp == INVALID_TIMESTAMP || isAtWantedTime(core::fromMrptTime(action->timestamp));
        });
    return isWanted ? Verdict::Whole : Verdict::Nothing;
  }
  return Verdict::Whole;
}

}  // namespace wardslam::rawlog_cut

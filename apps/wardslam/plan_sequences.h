#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "support/interruption.h"
#include "wardslam/reproduction/plan.h"

namespace wardslam::apps {

/// Makes those sequences of a plan that are absent and can be rendered, in the folder `data`, one after the other; says
/// so on standard error. An interrupted one is begun anew next time. Throws core::InputError when rawlog-synth fails.
void renderAbsent(const reproduction::Plan& plan, const std::filesystem::path& data,
                  const InterruptionGuard& interruption);

/// Fetches and unpacks those that are absent and published somewhere. What was downloaded of an archive is kept and
/// gone on with; size and checksum are compared where the plan tells them. Returns one sentence for each that could not
/// be had; where the computer is offline, one is all.
[[nodiscard]] std::vector<std::string> fetchAbsent(const reproduction::Plan& plan, const std::filesystem::path& data,
                                                   const InterruptionGuard& interruption);

}  // namespace wardslam::apps

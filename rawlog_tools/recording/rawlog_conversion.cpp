#include "recording/rawlog_conversion.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <iostream>

#include "recording/rawlog_writer.h"
#include "support/interruption.h"
#include "support/program.h"
#include "support/progress.h"
#include "wardslam/core/errors.h"

namespace wardslam::recording {
namespace {

struct Copied {
  std::size_t observations = 0;
  std::size_t scans = 0;
};

Copied copyAll(const RawlogConversion& conversion, RawlogWriter& rawlog) {
  const apps::InterruptionGuard interruption;
  apps::Progress progress(std::cerr, apps::standardErrorIsTerminal(), "observation", conversion.size);
  Copied copied;
  while (const auto observation = conversion.next()) {
    if (interruption.requested()) throw core::InputError("interrupted; no rawlog was written");
    rawlog.write(*observation);
    copied.scans += std::dynamic_pointer_cast<mrpt::obs::CObservation3DRangeScan>(observation) ? 1 : 0;
    progress.update(++copied.observations);
  }
  return copied;
}

}  // namespace

int convertToRawlog(const RawlogConversion& conversion) {
  RawlogWriter rawlog(conversion.output);
  conversion.begin(rawlog);
  const Copied copied = copyAll(conversion, rawlog);
  if (copied.scans == 0) throw core::InputError(conversion.input.string() + ": no pair of images could be read");
  rawlog.commit();

  std::cout << conversion.output.string() << ": " << copied.observations << " observations";
  if (conversion.mayHoldOthers) std::cout << ", " << copied.scans << " of them RGB-D scans";
  std::cout << "\n";
  if (!conversion.isDamaged()) return apps::kSuccess;
  std::cerr << conversion.program << ": parts of the input could not be read; the rawlog holds the rest\n";
  return apps::kFailure;
}

}  // namespace wardslam::recording

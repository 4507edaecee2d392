#include "support/interruption.h"

#include <csignal>

namespace wardslam::apps {
namespace {

volatile std::sig_atomic_t interruptionRequested = 0;

void onSignal(int signal) {
  interruptionRequested = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

InterruptionGuard::InterruptionGuard() {
  interruptionRequested = 0;
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
}

InterruptionGuard::~InterruptionGuard() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

bool InterruptionGuard::requested() const { return interruptionRequested != 0; }

}  // namespace wardslam::apps

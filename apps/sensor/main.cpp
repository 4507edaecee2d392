/// wardslam-sensor FILE.ini SECTION [PLUGIN.so ...]: grabs from a camera and writes the observations to standard output
/// (wardslam/sources/sensor_link.h). Ends when its standard input is closed, even when the driver hangs. Started by
/// LiveSensorSource, not by people.

#include <mrpt/img/CImage.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <iostream>
#include <string>
#include <thread>

#include "sensor_session.h"
#include "support/program.h"

namespace wardslam::apps {
namespace {

using namespace std::chrono_literals;

constexpr auto kGrace = 900ms;  ///< For the driver to come back and close the camera.

/// Sets `stop` when whoever started us is gone or wants us to end; a driver that does not come back ends with us.
void watchStandardInput(std::atomic<bool>& stop) {
  char byte = 0;
  ssize_t got = 0;
  do {
    got = read(STDIN_FILENO, &byte, 1);
  } while (got > 0 || (got < 0 && errno == EINTR));
  stop = true;
  std::this_thread::sleep_for(kGrace);
  _exit(kSuccess);
}

/// What drivers print must not get among the messages.
int takeStandardOutput() {
  const int messages = dup(STDOUT_FILENO);
  dup2(STDERR_FILENO, STDOUT_FILENO);
  return messages;
}

}  // namespace
}  // namespace wardslam::apps

int main(int argc, char** argv) {
  using namespace wardslam;
  if (argc < 3) {
    const bool asksForHelp = argc == 2 && std::string(argv[1]) == "--help";
    (asksForHelp ? std::cout : std::cerr)
        << "usage: wardslam-sensor FILE.ini SECTION [PLUGIN.so ...]; `wardslam run FILE.ini` starts it\n";
    return asksForHelp ? apps::kSuccess : apps::kWrongUsage;
  }
  std::signal(SIGPIPE, SIG_IGN);
  mrpt::img::CImage::DISABLE_JPEG_COMPRESSION(true);
  const int messages = apps::takeStandardOutput();
  static std::atomic<bool> stop{false};  // outlives main, as the thread that sets it does
  std::thread([] { apps::watchStandardInput(stop); }).detach();
  const auto send = [messages](const sources::SensorMessage& message) {
    return sources::writeMessage(messages, message);
  };
  apps::grab({argv[1], argv[2], {argv + 3, argv + argc}}, send, stop);
  std::cout.flush();
  _exit(apps::kSuccess);  // drivers leave threads behind that static destructors would pull the ground from under
}

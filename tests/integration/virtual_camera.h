#pragma once

#ifdef WARDSLAM_VIRTUAL_OPENNI2

#include <cstdlib>
#include <filesystem>
#include <string>

#include "room_recording.h"

namespace wardslam::test {

/// While it lives, programs that are started see an OpenNI2 camera that shows a walk through a room
/// (tests/support/virtual_openni2).
class VirtualCamera {
 public:
  VirtualCamera() {
    const char* before = std::getenv("LD_LIBRARY_PATH");
    if (before != nullptr) libraryPath_ = before;
    setenv("LD_LIBRARY_PATH", (WARDSLAM_VIRTUAL_OPENNI2 ":" + libraryPath_).c_str(), 1);
    setenv("WARDSLAM_VIRTUAL_CAMERA", (folder_.path() / "camera.txt").c_str(), 1);
    set("plugged");
  }
  ~VirtualCamera() {
    unsetenv("WARDSLAM_VIRTUAL_CAMERA");
    setenv("LD_LIBRARY_PATH", libraryPath_.c_str(), 1);
  }
  VirtualCamera(const VirtualCamera&) = delete;
  VirtualCamera& operator=(const VirtualCamera&) = delete;

  /// "plugged", "unplugged" or "silent", and further lines of camera_settings.h.
  void set(const std::string& state, const std::string& more = "") const {
    folder_.write("camera.new", "folder = " + room().path().string() + "\nstate = " + state + "\n" + more);
    std::filesystem::rename(folder_.path() / "camera.new", folder_.path() / "camera.txt");  // never seen half written
  }

 private:
  static const RoomRecording& room() {
    static const RoomRecording recording;
    return recording;
  }

  TemporaryFolder folder_;
  std::string libraryPath_;
};

}  // namespace wardslam::test

#endif

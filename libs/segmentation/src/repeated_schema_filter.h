#pragma once

#include <atomic>
#include <streambuf>
#include <string>
#include <thread>

namespace wardslam::segmentation {

/// Passes on what is written to it, except for ONNX's complaints that an operator is registered twice ("Schema error:
/// Trying to register schema with name Abs … but it is already registered …").
///
/// Where ONNX Runtime is linked to ONNX as a library of its own, as Debian does, both register all operators when the
/// first session of a process is opened: some 570 complaints that mean nothing, on std::cerr, which no setting of
/// ONNX Runtime reaches.
class RepeatedSchemaFilter : public std::streambuf {
 public:
  explicit RepeatedSchemaFilter(std::streambuf& to) : to_(to) {}

  /// Filters what the calling thread writes from now on; what others write passes as it comes.
  void follow() { thread_ = std::this_thread::get_id(); }

  /// Passes on a line that has no end yet.
  void finish();

 protected:
  int_type overflow(int_type letter) override;
  std::streamsize xsputn(const char* text, std::streamsize size) override;
  int sync() override;

 private:
  void add(char letter);

  std::streambuf& to_;
  std::atomic<std::thread::id> thread_ = std::this_thread::get_id();
  std::string line_;
  bool heldBack_ = false;  ///< The line before.
};

/// While it lives, std::cerr writes into the filter, which follows the calling thread and has to outlive whatever other
/// threads write.
class FilterGuard {
 public:
  explicit FilterGuard(RepeatedSchemaFilter& filter);
  ~FilterGuard();
  FilterGuard(const FilterGuard&) = delete;
  FilterGuard& operator=(const FilterGuard&) = delete;

 private:
  RepeatedSchemaFilter& filter_;
  std::streambuf* before_;
};

}  // namespace wardslam::segmentation

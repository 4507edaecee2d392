#pragma once

#include <exception>

namespace wardslam::core {

/// For steps that must all be tried, whatever becomes of the others: keeps the first exception until the end.
class FirstFailure {
 public:
  template <class Step>
  void attempt(const Step& step) {
    try {
      step();
    } catch (...) {
      if (!failure_) failure_ = std::current_exception();
    }
  }

  [[nodiscard]] bool hasFailed() const { return failure_ != nullptr; }

  /// Throws the first exception, if there was one.
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::exception_ptr failure_;
};

}  // namespace wardslam::core

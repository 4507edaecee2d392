#include "repeated_schema_filter.h"

#include <iostream>
#include <string_view>

namespace wardslam::segmentation {
namespace {

constexpr std::string_view kBegin = "Schema error: Trying to register schema with name ";
constexpr std::string_view kReason = "but it is already registered";

bool tellsOfARepetition(std::string_view line) {
  return line.substr(0, kBegin.size()) == kBegin && line.find(kReason) != std::string_view::npos;
}

}  // namespace

void RepeatedSchemaFilter::finish() {
  to_.sputn(line_.data(), static_cast<std::streamsize>(line_.size()));
  line_.clear();
}

void RepeatedSchemaFilter::add(char letter) {
  line_ += letter;
  if (letter != '\n') return;
  const bool isRestOfOne = heldBack_ && line_ == "\n";  // they end in an empty line
  heldBack_ = tellsOfARepetition(line_);
  if (heldBack_ || isRestOfOne) line_.clear();
  finish();
}

std::streambuf::int_type RepeatedSchemaFilter::overflow(int_type letter) {
  if (traits_type::eq_int_type(letter, traits_type::eof())) return traits_type::not_eof(letter);
  if (std::this_thread::get_id() != thread_) return to_.sputc(traits_type::to_char_type(letter));
  add(traits_type::to_char_type(letter));
  return letter;
}

std::streamsize RepeatedSchemaFilter::xsputn(const char* text, std::streamsize size) {
  if (std::this_thread::get_id() != thread_) return to_.sputn(text, size);
  for (const char letter : std::string_view(text, static_cast<std::size_t>(size))) add(letter);
  return size;
}

int RepeatedSchemaFilter::sync() { return to_.pubsync(); }

FilterGuard::FilterGuard(RepeatedSchemaFilter& filter) : filter_(filter), before_(std::cerr.rdbuf(&filter)) {
  filter.follow();
}

FilterGuard::~FilterGuard() {
  std::cerr.rdbuf(before_);
  filter_.finish();
}

}  // namespace wardslam::segmentation

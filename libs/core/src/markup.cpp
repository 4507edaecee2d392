#include "wardslam/core/markup.h"

namespace wardslam::core {
namespace {

const char* entityOf(char letter) {
  switch (letter) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return nullptr;
  }
}

}  // namespace

std::string escapedForMarkup(const std::string& text) {
  std::string escaped;
  for (const char letter : text) {
    const char* entity = entityOf(letter);
    entity != nullptr ? escaped += entity : escaped += letter;
  }
  return escaped;
}

}  // namespace wardslam::core

#include "lesson/heading_id.h"

#include <re2/re2.h>

#include <cctype>

namespace mjcourse {

std::string id_of_heading(std::string text) {
  static const RE2 between(R"([\p{Z}\p{Pd}\t]+)"),
      punctuation(R"([^\p{L}\p{M}\p{N}\p{S}-]|[$+<=>^`|~])");
  RE2::GlobalReplace(&text, between, "-");
  RE2::GlobalReplace(&text, punctuation, "");
  std::string id;
  for (const char c : text) {
    if (c == '-' && (id.empty() || id.back() == '-')) continue;
    const auto byte = static_cast<unsigned char>(c);
    id += static_cast<char>(byte < 0x80 ? std::tolower(byte) : byte);
  }
  while (id.ends_with('-')) id.pop_back();
  return id.empty() ? "section" : id;
}

}  // namespace mjcourse

#include "lesson/syntax/heading_id.h"

#include <re2/re2.h>

#include "base/utf8.h"

namespace mjcourse {

std::string id_of_heading(std::string text) {
  static const RE2 between(R"([\p{Z}\p{Pd}\t]+)"),
      punctuation(R"([^\p{L}\p{M}\p{N}\p{S}-]|[$+<=>^`|~])");
  RE2::GlobalReplace(&text, between, "-");
  RE2::GlobalReplace(&text, punctuation, "");
  std::string id;
  for (const char c : lower_case_utf8(text)) {
    if (c == '-' && (id.empty() || id.back() == '-')) continue;
    id += c;
  }
  while (id.ends_with('-')) id.pop_back();
  return id.empty() ? "section" : id;
}

}  // namespace mjcourse

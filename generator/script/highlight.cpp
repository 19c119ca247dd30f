#include "script/highlight.h"

#include <stdexcept>
#include <utility>

namespace mjcourse {

Highlighter::Highlighter(const std::string& bundle) {
  engine_.load(bundle, "highlight.js");
}

std::string Highlighter::highlight(const std::string& code, const std::string& language) {
  auto html = engine_.call("highlight", {code, language});
  if (!html) throw std::runtime_error("highlight.js: " + html.error().message);
  return std::move(*html);
}

}  // namespace mjcourse

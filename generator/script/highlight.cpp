#include "script/highlight.h"

#include <stdexcept>
#include <utility>

namespace mjcourse {

Highlighter::Highlighter(const std::string& bundle, std::size_t memory) : known_(memory) {
  engine_.load(bundle, "highlight.js");
}

std::string Highlighter::highlight(const std::string& code, const std::string& language) {
  const std::string key = language + "\n" + code;
  if (const std::string* known = known_.find(key)) return *known;
  auto html = engine_.call("highlight", {code, language});
  if (!html) throw std::runtime_error("highlight.js: " + html.error().message);
  known_.keep(key, *html);
  return std::move(*html);
}

}  // namespace mjcourse

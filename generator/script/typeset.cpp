#include "script/typeset.h"

#include <nlohmann/json.hpp>

#include "script/js_value.h"

namespace mjcourse {

Typesetter::Typesetter(const std::string& bundle, const std::map<std::string, std::string>& macros)
    : macros_(nlohmann::json(macros).dump()) {
  engine_.load(bundle, "typeset.js");
}

tl::expected<std::string, MathError> Typesetter::typeset(const std::string& tex, bool display) {
  const auto answer = engine_.call("typeset", {tex, display ? "true" : "false", macros_});
  if (!answer) return tl::unexpected(MathError{answer.error().message, 0, 0, ""});
  const auto result = json_of(*answer);
  if (const auto html = result.find("html"); html != result.end()) return html->get<std::string>();
  return tl::unexpected(
      MathError{result.at("message"), result.at("offset"), result.at("length"), result.at("cure")});
}

}  // namespace mjcourse

#include "script/templates.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

namespace mjcourse {

Templates::Templates(const std::string& bundle, const std::map<std::string, std::string>& sources) {
  engine_.load(bundle, "templates.js");
  for (const auto& [name, source] : sources) {
    const auto added = engine_.call("addTemplate", {name, source});
    if (!added) throw std::runtime_error("template " + name + ": " + added.error().message);
  }
}

tl::expected<std::string, TemplateError> Templates::render(const std::string& name,
                                                           const nlohmann::json& data) {
  const auto answer = engine_.call("render", {name, data.dump()});
  if (!answer) return tl::unexpected(TemplateError{name, answer.error().message, 0});
  const auto result = nlohmann::json::parse(*answer);
  if (const auto html = result.find("html"); html != result.end()) return html->get<std::string>();
  return tl::unexpected(TemplateError{result.at("name"), result.at("message"), result.at("line")});
}

}  // namespace mjcourse

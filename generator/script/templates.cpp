#include "script/templates.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "script/js_value.h"

namespace mjcourse {

Templates::Templates(const std::string& bundle, const std::map<std::string, std::string>& sources,
                     std::size_t memory)
    : known_(memory) {
  engine_.load(bundle, "templates.js");
  for (const auto& [name, source] : sources) {
    const auto added = engine_.call("addTemplate", {name, source});
    if (!added) throw std::runtime_error("template " + name + ": " + added.error().message);
  }
}

tl::expected<std::string, TemplateError> Templates::render(const std::string& name,
                                                           const nlohmann::json& data) {
  const std::string text = data.dump();
  const std::string key = name + "\n" + text;
  if (const std::string* known = known_.find(key)) return *known;
  auto answer = engine_.call("render", {name, text});
  if (!answer) {
    return tl::unexpected(TemplateError{name, answer.error().message, 0, answer.error().cure});
  }
  if (answer->starts_with('=')) {
    answer->erase(0, 1);
    known_.keep(key, *answer);
    return *std::move(answer);
  }
  const auto result = json_of(*answer);
  return tl::unexpected(
      TemplateError{result.at("name"), result.at("message"), result.at("line"), result.at("cure")});
}

}  // namespace mjcourse

#include "script/templates.h"

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "script/js_value.h"

namespace mjcourse {

TemplateEngine::TemplateEngine(const std::string& bundle,
                               const std::map<std::string, std::string>& sources) {
  engine_.load(bundle, "templates.js");
  for (const auto& [name, source] : sources) {
    const auto added = engine_.call("addTemplate", {name, source});
    if (!added) throw std::runtime_error("template " + name + ": " + added.error().message);
  }
}

tl::expected<std::string, TemplateError> TemplateEngine::render(const std::string& name,
                                                                const std::string& data) {
  auto answer = engine_.call("render", {name, data});
  if (!answer) {
    return tl::unexpected(TemplateError{name, answer.error().message, 0, answer.error().cure});
  }
  if (answer->starts_with('=')) return answer->substr(1);
  const auto result = json_of(*answer);
  return tl::unexpected(
      TemplateError{result.at("name"), result.at("message"), result.at("line"), result.at("cure")});
}

Templates::Templates(std::unique_ptr<TemplateRenderer> renderer, std::size_t memory)
    : renderer_(std::move(renderer)), known_(memory) {}

Templates::Templates(const std::string& bundle, const std::map<std::string, std::string>& sources,
                     std::size_t memory)
    : Templates(std::make_unique<TemplateEngine>(bundle, sources), memory) {}

tl::expected<std::string, TemplateError> Templates::render(const std::string& name,
                                                           const nlohmann::json& data) {
  const std::string text = data.dump();
  const std::string key = name + "\n" + text;
  if (const std::string* known = known_.find(key)) return *known;
  auto html = renderer_->render(name, text);
  if (html) known_.keep(key, *html);
  return html;
}

}  // namespace mjcourse

#include "lsp/completion.h"

#include "lesson/json/json_fences.h"
#include "lsp/json_suggestions.h"
#include "lsp/prose_suggestions.h"

namespace mjcourse {
namespace {

using nlohmann::json;

Suggestions suggestions_at(const Asked& asked) {
  const std::vector<LessonFence> fences = fences_of(*asked.text);
  const LessonFence* fence = fence_at(fences, asked.offset);
  const bool in_body = fence != nullptr && asked.offset >= fence->body.begin;
  if (in_body && vocabulary_of(fence->kind()) != nullptr) return json_suggestions(asked, *fence);
  if (in_body && fence->kind() == "cpp") {
    return script_suggestions(asked, std::string(asked.line_before()), "");
  }
  const bool is_code = in_body && fence->kind() != "demo" && fence->kind() != "io";
  if (const auto place = prose_place(asked.line_before(), is_code)) {
    return prose_suggestions(asked, *place);
  }
  return {};
}

}  // namespace

json completion_at(const Asked& asked) {
  const Suggestions found = suggestions_at(asked);
  const json range = json_of(range_of(*asked.text, {found.begin, asked.offset}, asked.units));
  json items = json::array();
  for (const Suggestion& one : found.all) {
    const std::string& text = one.text.empty() ? one.name : one.text;
    json item{{"label", one.name},
              {"kind", static_cast<int>(one.kind)},
              {"filterText", text},
              {"textEdit", {{"range", range}, {"newText", text}}}};
    if (!one.detail.empty()) item["detail"] = one.detail;
    if (!one.meaning.empty()) {
      item["documentation"] = {{"kind", "markdown"}, {"value", one.meaning}};
    }
    items.push_back(std::move(item));
  }
  return {{"isIncomplete", false}, {"items", std::move(items)}};
}

}  // namespace mjcourse

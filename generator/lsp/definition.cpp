#include "lsp/definition.h"

#include <algorithm>

#include "course/link_target.h"
#include "lsp/named_things.h"

namespace mjcourse {
namespace {

using nlohmann::json;

json line_of_file(const Asked& asked, const std::string& file, int line) {
  const TextPoint point{std::max(line - 1, 0), 0};
  return {{"uri", asked.documents.uri_of(file)}, {"range", json_of(TextRange{point, point})}};
}

json heading_of(const Asked& asked, const Lesson& lesson, const std::string& id) {
  const auto heading =
      std::ranges::find_if(lesson.headings, [&](const Heading& one) { return one.id == id; });
  const int line = heading == lesson.headings.end() ? 1 : heading->line;
  return line_of_file(asked, lesson.source->path(), line);
}

json model_of(const Asked& asked, const std::string& name) {
  const std::vector<std::string>& known = asked.course().models;
  if (std::ranges::find(known, name) == known.end()) return nullptr;
  return line_of_file(asked, "models/" + name + ".xml", 1);
}

// Where its fence is, in whichever lesson; the asked one as it is now.
json program_of(const Asked& asked, const Lesson& own, const std::string& name) {
  const auto in = [&](const Lesson& lesson) -> json {
    for (const std::size_t index : blocks_of<Example>(lesson)) {
      const auto& example = std::get<Example>(lesson.blocks[index]);
      if (example.name() != name || example.region) continue;
      const int line = lesson.source->position(example.span.begin).line;
      return line_of_file(asked, lesson.source->path(), line);
    }
    return nullptr;
  };
  json found = in(own);
  for (const Lesson& lesson : asked.course().lessons) {
    if (!found.is_null()) break;
    if (lesson.source->path() != own.source->path()) found = in(lesson);
  }
  return found;
}

// The program's file; of a region, its first line.
json file_of(const Asked& asked, const std::string& file, const std::string& region) {
  const auto text = asked.documents.text_or_saved(file);
  if (!text) return nullptr;
  const std::size_t at =
      region.empty() ? text->text().npos : text->text().find("#region " + region);
  return line_of_file(asked, file, at == text->text().npos ? 1 : text->position(at).line);
}

json link_of(const Asked& asked, const Lesson& own, const std::string& target) {
  constexpr std::string_view model = "model:";
  if (target.starts_with(model)) return model_of(asked, target.substr(model.size()));
  const auto resolved = resolve_link(asked.course(), own, target);
  if (!resolved || resolved->lesson == nullptr) return nullptr;
  return heading_of(asked, *resolved->lesson, resolved->anchor);
}

json term_of(const Asked& asked, const std::string& key) {
  const auto& glossary = asked.course().glossary;
  const Glossary::Term* term = glossary ? glossary->find(key) : nullptr;
  return term == nullptr ? json(nullptr) : heading_of(asked, glossary->page, term->id);
}

json definition_of(const NamedThing& thing, const Asked& asked, const Lesson& own) {
  switch (thing.kind) {
    case NamedThing::Kind::model:
      return model_of(asked, thing.name.text);
    case NamedThing::Kind::program:
      return program_of(asked, own, thing.name.text);
    case NamedThing::Kind::file:
      return file_of(asked, thing.name.text, thing.what);
    case NamedThing::Kind::term:
      return term_of(asked, thing.what);
    case NamedThing::Kind::link:
      break;
  }
  return link_of(asked, own, thing.name.text);
}

}  // namespace

json definition_at(const Asked& asked) {
  const std::optional<Lesson> own = asked.lesson();
  if (!own) return nullptr;
  for (const NamedThing& thing : named_things(*own)) {
    if (!asked.is_in(thing.name.span())) continue;
    json found = definition_of(thing, asked, *own);
    if (!found.is_null()) return found;
  }
  return nullptr;
}

}  // namespace mjcourse

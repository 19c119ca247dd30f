#include "lsp/prose_suggestions.h"

#include <algorithm>
#include <map>
#include <set>

#include "lesson/blocks/callout.h"
#include "lsp/fence_suggestions.h"
#include "lsp/json_suggestions.h"
#include "physics/mujoco_api.h"

namespace mjcourse {
namespace {

using Kind = Suggestion::Kind;

// By name, each with the results that it reported.
std::map<std::string, std::set<std::string>> results_of(const Asked& asked) {
  std::map<std::string, std::set<std::string>> all;
  for (const Lesson* page : asked.course().pages()) {
    const LessonResults& results = asked.snapshot->evaluation->results_of(*page);
    for (const auto& [index, result] : results.of_block) {
      const auto* example = std::get_if<Example>(&page->blocks[index]);
      const auto* run = std::get_if<ExampleResult>(&result);
      if (example == nullptr || run == nullptr) continue;
      for (const auto& [name, value] : run->records.results) all[example->name()].insert(name);
    }
  }
  return all;
}

void add_headings(Suggestions& found, const Asked& asked, const std::string& number) {
  const std::optional<Lesson> own = number.empty() ? asked.lesson() : std::nullopt;
  const Lesson* lesson =
      number.empty() ? (own ? &*own : nullptr) : asked.course().find_lesson(number);
  if (lesson == nullptr) return;
  for (const Heading& heading : lesson->headings) {
    std::string title;
    for (const TitlePart& part : heading.title) title += part.text;
    found.all.push_back({heading.id, Kind::reference, title});
  }
}

void add_links(Suggestions& found, const Asked& asked) {
  for (const Lesson& lesson : asked.course().lessons) {
    found.all.push_back({lesson.number, Kind::reference, lesson.front.title.text});
  }
  found.all.push_back({"model:", Kind::keyword, "the page of a model"});
  found.all.push_back({"api:", Kind::keyword, "what MuJoCo's headers say of a name"});
}

void add_api(Suggestions& found) {
  const auto& api = installed_mujoco_api();
  if (!api) return;
  for (const auto& [name, entry] : *api) {
    found.all.push_back({name, Kind::reference, entry.declaration, entry.comment});
  }
}

void add_sources(Suggestions& found, const Asked& asked) {
  found.add(asked.course().models, Kind::value, "model of the course");
  for (const auto& [program, results] : results_of(asked)) {
    if (!results.empty()) found.all.push_back({program, Kind::value, "program that reports"});
  }
}

// Over a model, an expression; of a program, a result.
Suggestions value_suggestions(const Asked& asked, const ProsePlace& place) {
  if (!known_model(asked, place.of).empty()) {
    return script_suggestions(asked, place.part, place.of);
  }
  Suggestions found{asked.offset - place.part.size()};
  const auto results = results_of(asked);
  const auto known = results.find(place.of);
  if (known == results.end()) return found;
  for (const std::string& name : known->second) {
    found.all.push_back({name, Kind::value, "reported by " + place.of});
  }
  return found;
}

void add_files(Suggestions& found, const Asked& asked) {
  for (const std::string& name : asked.documents.list("examples")) {
    if (name.ends_with(".cpp")) found.all.push_back({"examples/" + name, Kind::file});
  }
}

}  // namespace

Suggestions prose_suggestions(const Asked& asked, const ProsePlace& place) {
  Suggestions found{asked.offset - place.part.size()};
  switch (place.kind) {
    case ProsePlace::Kind::fence:
      add_fences(found);
      break;
    case ProsePlace::Kind::option:
      add_options(found, place.of);
      break;
    case ProsePlace::Kind::choice:
      add_choices(found, place.of);
      break;
    case ProsePlace::Kind::model:
      found.add(asked.course().models, Kind::value, "model of the course");
      break;
    case ProsePlace::Kind::program:
      if (const auto lesson = asked.lesson()) {
        for (const std::size_t index : blocks_of<Example>(*lesson)) {
          found.all.push_back({std::get<Example>(lesson->blocks[index]).name(), Kind::value});
        }
      }
      break;
    case ProsePlace::Kind::file:
      add_files(found, asked);
      break;
    case ProsePlace::Kind::link:
      add_links(found, asked);
      break;
    case ProsePlace::Kind::heading:
      add_headings(found, asked, place.of);
      break;
    case ProsePlace::Kind::api:
      add_api(found);
      break;
    case ProsePlace::Kind::term:
      if (asked.course().glossary) {
        found.add(asked.course().glossary->names(), Kind::reference, "term of the glossary");
      }
      break;
    case ProsePlace::Kind::source:
      add_sources(found, asked);
      break;
    case ProsePlace::Kind::value:
      return value_suggestions(asked, place);
    case ProsePlace::Kind::callout:
      found.add(callout_kinds(), Kind::keyword, "callout");
      break;
  }
  return found;
}

}  // namespace mjcourse

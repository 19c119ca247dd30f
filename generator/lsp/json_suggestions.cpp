#include "lsp/json_suggestions.h"

#include <algorithm>

#include "lsp/json_writing.h"
#include "lsp/place_words.h"
#include "lsp/plot_words.h"
#include "lsp/script_cursor.h"
#include "physics/mujoco_api.h"
#include "physics/overlays.h"

namespace mjcourse {
namespace {

using Kind = Suggestion::Kind;

bool is_script(KeyKind kind) {
  return kind == KeyKind::script || kind == KeyKind::expression || kind == KeyKind::expressions;
}

std::vector<std::string> words_of(const Vocabulary& vocabulary) {
  std::vector<std::string> words;
  for (const Variant& one : vocabulary.variants) words.emplace_back(one.word);
  return words;
}

// The programs of all lessons, by name.
std::vector<std::string> programs_of(const Course& course) {
  std::vector<std::string> names;
  for (const Lesson& lesson : course.lessons) {
    for (const Block& block : lesson.blocks) {
      if (const auto* example = std::get_if<Example>(&block)) names.push_back(example->name());
    }
  }
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

void add_all(JsonWriting& writing, const std::vector<std::string>& values,
             const std::string& detail) {
  for (const std::string& value : values) writing.add_text(value, detail);
}

void add_values(JsonWriting& writing, const Course& course, const PlaceWords& words) {
  const Key& key = *words.key;
  const std::string about(key.meaning);
  if (key.kind == KeyKind::word) {
    add_all(writing, words_of(*words.object), about);
  } else if (key.kind == KeyKind::model || key.name == "model") {
    add_all(writing, course.models, "model of the course");
  } else if (key.name == "example") {
    add_all(writing, programs_of(course), "program of the course");
  } else if (key.name == "toggles") {
    add_all(writing, overlay_names(), "overlay");
  } else if (key.kind == KeyKind::boolean || key.kind == KeyKind::true_or_object) {
    writing.add_booleans(about);
  }
}

}  // namespace

std::string known_model(const Asked& asked, const std::string& model) {
  const std::vector<std::string>& known = asked.course().models;
  const bool is_known = std::ranges::find(known, model) != known.end();
  return is_known || model.starts_with('<') ? model : "";
}

Suggestions script_suggestions(const Asked& asked, const std::string& before,
                               const std::string& model) {
  const auto cursor = script_cursor(before);
  if (!cursor) return {asked.offset};
  Suggestions found{asked.offset - std::min(asked.offset, cursor->part.size())};
  if (cursor->kind == ScriptCursor::Kind::object) {
    found.add(asked.models.objects(known_model(asked, model), cursor->of), Kind::reference,
              cursor->of + " of the model");
    return found;
  }
  const auto& api = installed_mujoco_api();
  for (const std::string& field : asked.models.fields(cursor->of)) {
    const std::string path = cursor->of + "." + field;
    const auto named = field_at(path, path.size());
    const auto known = api && named ? api->find(named->name) : MujocoApi::const_iterator();
    const bool told = api && named && known != api->end();
    found.all.push_back({field, Kind::field, told ? known->second.declaration : "",
                         told ? known->second.comment : ""});
  }
  return found;
}

Suggestions json_suggestions(const Asked& asked, const LessonFence& fence) {
  const std::string before = unquoted(*asked.text, {fence.body.begin, asked.offset});
  const JsonPlace place = json_place(before);
  Suggestions found{asked.offset - std::min(asked.offset, place.part.size())};
  if (place.objects.empty()) return found;
  const bool closed = asked.text->text().substr(asked.offset, 1) == "\"";
  JsonWriting writing(place, closed, found);
  const PlaceWords words = words_at(fence.kind(), place);
  if (words.object == nullptr) {
    // Overlays are no keys of a vocabulary.
    JsonPlace around = place;
    around.objects.pop_back();
    const PlaceWords outer = words_at(fence.kind(), around);
    if (place.at_key() && outer.key != nullptr && outer.key->kind == KeyKind::overlays) {
      add_all(writing, overlay_names(), "overlay");
    }
  } else if (place.at_key()) {
    for (const Key& key : words.object->keys) {
      writing.add_key(std::string(key.name), std::string(words.object->name),
                      std::string(key.meaning));
    }
  } else if (words.key != nullptr && place.in_string && is_script(words.key->kind)) {
    return script_suggestions(asked, place.part, place.text("model"));
  } else if (words.key != nullptr) {
    add_values(writing, asked.course(), words);
  }
  if (fence.kind() == "plot") add_plot_words(writing, asked, place);
  return found;
}

}  // namespace mjcourse

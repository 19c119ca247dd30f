#include "lsp/plot_words.h"

#include <map>
#include <string>

namespace mjcourse {
namespace {

using PlotState = PlotGrammar::State;

// Behind the object's key, `lists` lists deep.
const PlotState* behind(const PlotGrammar& grammar, const PlotState* object, const std::string& key,
                        int lists) {
  const PlotState* state = object != nullptr ? grammar.behind(*object, key) : nullptr;
  for (; state != nullptr && lists > 0; --lists) state = grammar.item(*state);
  return state;
}

// Those that are known, by their names in plots. They live as long as `asked`.
std::map<std::string, const Table*> tables_of(const Asked& asked) {
  std::map<std::string, const Table*> tables;
  for (const Lesson& lesson : asked.course().lessons) {
    const LessonResults& results = asked.snapshot->evaluation->results_of(lesson);
    for (const auto& [index, result] : results.of_block) {
      const auto* example = std::get_if<Example>(&lesson.blocks[index]);
      if (example == nullptr) continue;
      for (const auto& [name, table] : std::get<ExampleResult>(result).records.tables) {
        tables[example->name() + "/" + name] = &table;
      }
    }
  }
  return tables;
}

void add_values(JsonWriting& writing, const PlotState& value) {
  for (const std::string& word : value.words.value_or(std::vector<std::string>())) {
    writing.add_text(word, "Vega-Lite");
  }
  if (value.kinds.find('b') != value.kinds.npos) writing.add_booleans("Vega-Lite");
}

void add_tables(JsonWriting& writing, const Asked& asked) {
  for (const auto& [name, table] : tables_of(asked)) {
    std::string columns = "columns:";
    for (const Column& column : *table) columns += " " + column.name;
    writing.add_text(name, columns);
  }
}

void add_columns(JsonWriting& writing, const Asked& asked, const std::string& plotted) {
  const auto tables = tables_of(asked);
  const auto table = tables.find(plotted);
  if (table == tables.end()) return;
  for (const Column& column : *table->second) writing.add_text(column.name, "column of " + plotted);
}

}  // namespace

const PlotState* plot_object_at(const PlotGrammar& grammar, const JsonPlace& place) {
  if (grammar.states.empty() || place.objects.empty()) return nullptr;
  const PlotState* state = &grammar.states.front();
  for (std::size_t i = 1; i < place.objects.size(); ++i) {
    state = behind(grammar, state, place.objects[i - 1].key, place.objects[i].lists);
  }
  return state;
}

void add_plot_words(JsonWriting& writing, const Asked& asked, const JsonPlace& place) {
  const PlotState* object = plot_object_at(asked.plots, place);
  const std::string& key = place.objects.back().key;
  if (place.at_key()) {
    if (object == nullptr) return;
    for (const auto& [name, meaning, value] : object->keys) {
      writing.add_key(name, "Vega-Lite", meaning);
    }
  } else if (key == "field") {
    add_columns(writing, asked, place.text_within("data", "name"));
  } else if (const PlotState* value = behind(asked.plots, object, key, place.lists)) {
    add_values(writing, *value);
  } else if (place.objects.size() == 2 && place.objects.front().key == "data") {
    add_tables(writing, asked);
  }
}

}  // namespace mjcourse

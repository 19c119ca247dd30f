#include "page/plot_schema.h"

#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace mjcourse {
namespace {

using nlohmann::ordered_json;

ordered_json reference(std::size_t state) {
  return {{"$ref", "#/definitions/" + std::to_string(state)}};
}

ordered_json types_of(const std::string& kinds) {
  static const std::map<char, const char*> names{{'s', "string"}, {'n', "number"}, {'b', "boolean"},
                                                 {'a', "array"},  {'o', "object"}, {'z', "null"}};
  ordered_json types = ordered_json::array();
  for (const char kind : kinds) types.push_back(names.at(kind));
  return types;
}

// Draft 7 passes over what stands beside a reference, so that is a part of its own.
ordered_json properties_of(const PlotGrammar::State& state) {
  ordered_json properties = ordered_json::object();
  for (const PlotGrammar::Key& key : state.keys) {
    ordered_json& property = properties[key.name];
    if (!key.meaning.empty()) property["description"] = key.meaning;
    property["allOf"] = ordered_json::array({reference(key.value)});
  }
  return properties;
}

ordered_json state_schema(const PlotGrammar& grammar, const PlotGrammar::State& state) {
  ordered_json schema = ordered_json::object();
  if (state.words) {
    std::string others = state.kinds;
    std::erase(others, 's');
    schema["anyOf"] = {{{"enum", *state.words}}, {{"type", types_of(others)}}};
    if (others.empty()) schema = {{"enum", *state.words}};
  } else {
    schema["type"] = types_of(state.kinds);
  }
  if (state.kinds.find('o') != state.kinds.npos) {
    schema["properties"] = properties_of(state);
    schema["additionalProperties"] = state.rest ? reference(*state.rest) : ordered_json(false);
    if (state.rest) schema["propertyNames"]["not"]["enum"] = grammar.elsewhere;
  }
  if (state.items) schema["items"] = reference(*state.items);
  return schema;
}

}  // namespace

void add_plot_schema(const PlotGrammar& grammar, ordered_json& schema) {
  if (grammar.states.empty()) return;
  for (std::size_t i = 0; i < grammar.states.size(); ++i) {
    schema["definitions"][std::to_string(i)] = state_schema(grammar, grammar.states[i]);
  }
  schema["properties"].update(properties_of(grammar.states.front()));
  schema["additionalProperties"] = false;
}

}  // namespace mjcourse

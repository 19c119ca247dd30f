#include "lesson/json/plot_grammar.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace mjcourse {
namespace {

using nlohmann::json;

std::optional<std::size_t> number_in(const json& state, const char* name) {
  const auto found = state.find(name);
  return found != state.end() ? std::optional(found->get<std::size_t>()) : std::nullopt;
}

PlotGrammar::State read_state(const json& from) {
  PlotGrammar::State state{
      from.at("kinds"), {}, {}, number_in(from, "rest"), number_in(from, "items")};
  if (from.contains("words")) state.words = from.at("words");
  const json keys = from.value("keys", json::object());
  const json meanings = from.value("meanings", json::object());
  for (const auto& [name, value] : keys.items()) {
    state.keys.push_back({name, meanings.value(name, ""), value});
  }
  return state;
}

}  // namespace

const PlotGrammar::Key* PlotGrammar::State::find(std::string_view key) const {
  const auto found = std::ranges::find(keys, key, &Key::name);
  return found != keys.end() ? &*found : nullptr;
}

const PlotGrammar::State* PlotGrammar::behind(const State& state, std::string_view key) const {
  if (const Key* known = state.find(key)) return &states.at(known->value);
  const bool other = state.rest && std::ranges::find(elsewhere, key) == elsewhere.end();
  return other ? &states.at(*state.rest) : nullptr;
}

const PlotGrammar::State* PlotGrammar::item(const State& state) const {
  return state.items ? &states.at(*state.items) : nullptr;
}

PlotGrammar read_plot_grammar(const Files& assets) {
  PlotGrammar grammar;
  const auto text = assets.read("plot-vocabulary.json");
  if (!text) return grammar;
  const json read = json::parse(*text);
  for (const json& state : read.at("states")) grammar.states.push_back(read_state(state));
  for (const auto& [key, reason] : read.at("elsewhere").items()) grammar.elsewhere.push_back(key);
  return grammar;
}

}  // namespace mjcourse

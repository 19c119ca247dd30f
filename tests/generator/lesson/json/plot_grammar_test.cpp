#include "lesson/json/plot_grammar.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

using Bytes = std::map<std::string, std::string>;

PlotGrammar grammar() {
  const std::string text = R"({
    "elsewhere": {"href": "a plot is no link"},
    "states": [
      {"kinds": "o", "keys": {"mark": 1, "layer": 2}, "meanings": {"mark": "What is drawn."}},
      {"kinds": "os", "words": ["bar", "line"], "keys": {}, "rest": 3},
      {"kinds": "a", "items": 0},
      {"kinds": "n"}]})";
  return read_plot_grammar(MemoryFiles(Bytes{{"plot-vocabulary.json", text}}));
}

TEST(PlotGrammar, KnowsWhatStandsBehindAKey) {
  const PlotGrammar plots = grammar();
  const PlotGrammar::State* mark = plots.behind(plots.states.front(), "mark");
  ASSERT_NE(mark, nullptr);
  EXPECT_EQ(mark->words, (std::vector<std::string>{"bar", "line"}));
  EXPECT_EQ(plots.states.front().find("mark")->meaning, "What is drawn.");
  EXPECT_EQ(plots.behind(plots.states.front(), "marc"), nullptr);
}

TEST(PlotGrammar, LeadsFromAListToItsItems) {
  const PlotGrammar plots = grammar();
  const PlotGrammar::State* layers = plots.behind(plots.states.front(), "layer");
  EXPECT_EQ(plots.item(*layers), &plots.states.front());
  EXPECT_EQ(plots.item(plots.states.front()), nullptr);
}

TEST(PlotGrammar, AllowsOtherKeysWhereThereIsARest) {
  const PlotGrammar plots = grammar();
  const PlotGrammar::State& mark = plots.states[1];
  EXPECT_EQ(plots.behind(mark, "anything"), &plots.states[3]);
  EXPECT_EQ(plots.behind(mark, "href"), nullptr);
}

TEST(PlotGrammar, IsEmptyWhereNothingWasBundled) {
  EXPECT_TRUE(read_plot_grammar(MemoryFiles(Bytes())).states.empty());
}

}  // namespace
}  // namespace mjcourse

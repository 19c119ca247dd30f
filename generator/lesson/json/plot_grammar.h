// PlotGrammar: what Vega-Lite knows of a plot's spec: which keys an object has, and what may stand
// behind each.
//
// It is what the drawing holds a spec against (site/press/script/plot/vocabulary.ts), boiled down
// from Vega-Lite's own schema when the site was bundled (site/bundle/plot-vocabulary.mjs). The
// schema for editors is made of it, and so is what an editor is told while one writes.
//
// Enter at read_plot_grammar(); states[0] is the spec.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"

namespace mjcourse {

struct PlotGrammar {
  struct Key {
    std::string name, meaning;  // Markdown; empty where Vega-Lite's authors say nothing
    std::size_t value;          // the state of what stands behind it
  };
  // All that may stand at a place. Numbers are those of states.
  struct State {
    std::string kinds;  // some of "snbaoz": string, number, boolean, array, object, null
    std::optional<std::vector<std::string>> words = {};  // the only strings, where not all may be
    std::vector<Key> keys = {};                          // by name
    std::optional<std::size_t> rest = {};                // of other keys' values
    std::optional<std::size_t> items = {};

    const Key* find(std::string_view key) const;
  };

  std::vector<State> states;
  std::vector<std::string> elsewhere;  // Vega-Lite's keys that plots have nowhere

  // Behind `key` of an object that `state` stands for, or of an item of its lists; null where
  // nothing is known.
  const State* behind(const State& state, std::string_view key) const;
  const State* item(const State& state) const;
};

// `assets`: what the site's bundling made. Without it, a grammar with no states.
PlotGrammar read_plot_grammar(const Files& assets);

}  // namespace mjcourse

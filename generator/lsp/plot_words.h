// What Vega-Lite has for a place in a plot's JSON, and what the plot's table has.
#pragma once

#include "lesson/json/plot_grammar.h"
#include "lsp/asked.h"
#include "lsp/json_place.h"
#include "lsp/json_writing.h"

namespace mjcourse {

// Of the innermost object around the place; null where it is none of Vega-Lite's.
const PlotGrammar::State* plot_object_at(const PlotGrammar& grammar, const JsonPlace& place);

// Adds the keys or the values that could stand at the place.
void add_plot_words(JsonWriting& writing, const Asked& asked, const JsonPlace& place);

}  // namespace mjcourse

// What Vega-Lite knows of a plot's spec, as a JSON Schema.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "lesson/json/plot_grammar.h"

namespace mjcourse {

// Adds the spec's keys to `schema`, which is of an object that has them beside its own; afterwards
// it has no others. A grammar with no states adds nothing.
void add_plot_schema(const PlotGrammar& grammar, nlohmann::ordered_json& schema);

}  // namespace mjcourse

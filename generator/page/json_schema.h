// The JSON that fences hold, as JSON Schemas, which editors read.
//
// They are made of the vocabularies that the generator reads by (lesson/json/vocabulary.h), and
// that of plots of Vega-Lite's, too (lesson/json/plot_grammar.h). A schema knows what one value may
// be, and not what several say together, such as a slider's `min` below its `max`. So what a schema
// refuses the generator refuses too, and the generator looks at more.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lesson/json/json_fences.h"
#include "lesson/json/plot_grammar.h"

namespace mjcourse {

// Draft 7, the last one that all editors know. What the vocabulary leaves open, `grammar` says.
nlohmann::ordered_json json_schema(const JsonFence& fence, const PlotGrammar& grammar);

// Where the site has it: "schemas/lab.schema.json".
std::string schema_path(const JsonFence& fence);

}  // namespace mjcourse

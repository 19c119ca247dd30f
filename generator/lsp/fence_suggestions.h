// What could be written in the line that begins a fence.
#pragma once

#include <string>

#include "lsp/suggestions.h"

namespace mjcourse {

// The kinds, each with what it cannot do without: "cpp file=".
void add_fences(Suggestions& found);

// The words and options that may follow `info`, a fence's line so far: "cpp file=examples/a.cpp ".
void add_options(Suggestions& found, const std::string& info);

// The values of the option at the end of `info`: "xml mjcf expect".
void add_choices(Suggestions& found, const std::string& info);

}  // namespace mjcourse

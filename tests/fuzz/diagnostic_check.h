// What must hold of every diagnostic, whatever it says.
#pragma once

#include <map>
#include <string>

#include "base/source_text.h"
#include "report/diagnostic.h"

namespace mjcourse {

// The files that were read, by their paths.
using Sources = std::map<std::string, SourceText>;

// Each has an id, says something in one line of UTF-8, and stands in its file: on a line that is
// there, at a character of it or just behind it, with that line as its excerpt.
void check_diagnostics(const Diagnostics& diagnostics, const Sources& sources);

// All that they say, for comparing.
std::string text_of(const Diagnostics& diagnostics);

}  // namespace mjcourse

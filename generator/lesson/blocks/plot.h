// ```plot: a plot of what an example reported, as Vega-Lite describes it.
#pragma once

#include <string>

#include "lesson/json/json_value.h"
#include "lesson/syntax/located_text.h"
#include "lesson/syntax/markdown.h"

namespace mjcourse {

struct Plot {
  LocatedText example, table;  // whose table it shows; empty when the lesson does not say it well
  std::string json;            // all of it, as it is written
  JsonValue tree;              // the same with its places
  Document caption;
  std::string alt;  // what it shows, in words
  Span span;        // the opening fence
};

}  // namespace mjcourse

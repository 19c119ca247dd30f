// How keys and values are written where one is in JSON: with the quotes that are not there yet.
#pragma once

#include <string>

#include "lsp/json_place.h"
#include "lsp/suggestions.h"

namespace mjcourse {

// Adds what can be written at `place`; `closed`: a quote stands behind it already.
class JsonWriting {
 public:
  JsonWriting(const JsonPlace& place, bool closed, Suggestions& found)
      : place_(place), closed_(closed), found_(found) {}

  // Unless the object has it.
  void add_key(const std::string& name, const std::string& detail, const std::string& meaning);
  void add_text(const std::string& value, const std::string& detail);
  // Those that are no strings, where none is begun.
  void add_booleans(const std::string& detail);

 private:
  const JsonPlace& place_;
  bool closed_;
  Suggestions& found_;
};

}  // namespace mjcourse

// JSON whose every value knows where it stands in the lesson.
//
// The parser is nlohmann's; this keeps the place of each value, so that a wrong key or a bad
// script inside a string is shown at its own line and column of the Markdown file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lesson/syntax/located_text.h"
#include "lesson/syntax/reading.h"

namespace mjcourse {

struct JsonMember;

struct JsonValue {
  enum class Kind { null, boolean, number, string, array, object };

  Kind kind = Kind::null;
  Span span;  // in the lesson, quotes and brackets included
  bool boolean = false;
  double number = 0;
  LocatedText string;
  std::vector<JsonValue> items;
  std::vector<JsonMember> members;  // in the author's order
};

struct JsonMember {
  LocatedText key;
  JsonValue value;
};

// "a number", "a list" …: how messages name a kind.
std::string kind_name(JsonValue::Kind kind);

// Parse `text`; on a mistake, report E-json-syntax (or E-json-duplicate) at its place and return
// nothing.
std::optional<JsonValue> parse_json(const LocatedText& text, Reading& reading);

}  // namespace mjcourse

// JsonObject: read an object key by key, and complain about what was not asked for.
//
//   JsonObject object(value, "lab", reading);
//   lab.title = object.required_string("title");
//   lab.height = object.number("height", 300);
//   object.finish();  // any other key is an error with "did you mean"
//
// What is asked for is what is known: no list of keys is kept beside the reader.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lesson/json_value.h"

namespace mjcourse {

// Which numbers a key takes, and what a message says of it: "is a number of pixels: from 1 to 9".
struct NumberRule {
  double least, most;
  std::string text;
  bool whole = false;
};

class JsonObject {
 public:
  // `what` names the object in messages ("lab", "question"). A value that is no object is an error
  // here and then reads as an empty one.
  JsonObject(const JsonValue& value, std::string what, Reading& reading);

  // The value at `key`, of any kind; null when it is not there.
  const JsonValue* find(const std::string& key);
  bool has(const std::string& key) { return find(key) != nullptr; }

  // Values of one kind. A wrong kind is an error; a missing one gives the default, and for
  // `required_…` is an error too.
  LocatedText string(const std::string& key);
  LocatedText required_string(const std::string& key);
  double number(const std::string& key, double otherwise);
  double number(const std::string& key, double otherwise, const NumberRule& rule);
  double required_number(const std::string& key);
  double required_number(const std::string& key, double otherwise, const NumberRule& rule);
  // How many digits a number is shown with after its point.
  int digits(int otherwise);
  std::optional<double> optional_number(const std::string& key);
  bool boolean(const std::string& key, bool otherwise);
  const std::vector<JsonValue>& list(const std::string& key);
  const std::vector<JsonValue>& required_list(const std::string& key);
  // The same, where an empty list is an error too: `cure` says what to put in.
  const std::vector<JsonValue>& filled_list(const std::string& key, const std::string& cure);
  // A script: a string, or a list of strings that are its lines.
  LocatedText script(const std::string& key);
  LocatedText required_script(const std::string& key);

  // Report the keys that nothing asked for.
  void finish();

  bool is_object() const { return is_object_; }
  Span span() const { return value_.span; }

 private:
  const JsonValue* require(const std::string& key, const JsonValue* value);
  const JsonValue* of_kind(const std::string& key, JsonValue::Kind kind);

  const JsonValue& value_;
  std::string what_;
  Reading& reading_;
  std::vector<std::string> asked_;
  bool is_object_;
};

// Report that `value`, the value of `key`, is not what was expected.
void report_kind(const std::string& key, const JsonValue& value, const std::string& expected,
                 Reading& reading);

}  // namespace mjcourse

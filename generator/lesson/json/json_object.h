// JsonObject: read an object key by key, as its vocabulary says, and complain about what is not so.
//
//   JsonObject object(value, words::kLab, reading);
//   lab.title = object.string("title").text;  // reported where it must be there and is
//   not lab.height = object.number("height", 300);     // and where it is out of its limits
//   object.finish();  // any other key is an error with "did you mean"
//
// A reader that asks for a key that the vocabulary does not have, or as another kind, or that does
// not ask for all keys, is at fault, and not the author: that is a std::logic_error.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "lesson/json/json_value.h"
#include "lesson/json/vocabulary.h"

namespace mjcourse {

class JsonObject {
 public:
  // A value that is no object is an error here and then reads as an empty one.
  JsonObject(const JsonValue& value, const Vocabulary& vocabulary, Reading& reading);

  // The value at `key`, of any kind; null when it is not there.
  const JsonValue* find(const std::string& key);
  bool has(const std::string& key) { return find(key) != nullptr; }
  // The same, where it is an error that it is not there; `message` and `cure` say more of it.
  const JsonValue* require(const std::string& key, const std::string& message = "",
                           const std::string& cure = "");

  // Values of one kind. A wrong kind is an error, as is a missing one where the vocabulary says
  // that it must be there; else it gives the default.
  LocatedText string(const std::string& key);
  double number(const std::string& key, double otherwise);
  double number(const std::string& key, double otherwise, const Limits& limits);
  int whole(const std::string& key, int otherwise);
  std::optional<double> optional_number(const std::string& key);
  bool boolean(const std::string& key, bool otherwise);
  // `cure` says what to put into one that must not be empty.
  const std::vector<JsonValue>& list(const std::string& key, const std::string& cure = "");
  // A string, or a list of strings that are its lines.
  LocatedText script(const std::string& key);

  // Where other keys make `key` necessary, or where it is there: it must be, and not be empty.
  LocatedText required_string(const std::string& key);

  // A key that the vocabulary has not, and for which its reader has a better message; else null.
  const JsonValue* misplaced(const std::string& key);

  // Report the keys that the vocabulary has not.
  void finish();

  bool is_object() const { return is_object_; }

 private:
  const Key& key_of(const std::string& key) const;
  const Key& key_of(const std::string& key, std::initializer_list<KeyKind> kinds) const;
  const JsonValue* member(const std::string& key) const;
  const JsonValue* of_kind(const std::string& key, JsonValue::Kind kind);
  LocatedText text_at(const std::string& key);
  void report_empty(const std::string& key, const std::string& cure = "");

  const JsonValue& value_;
  const Vocabulary& vocabulary_;
  std::string what_;  // as messages call it
  Reading& reading_;
  std::vector<std::string> asked_, misplaced_;
  bool is_object_;
};

// Report that `value`, the value of `key`, is not what was expected.
void report_kind(const std::string& key, const JsonValue& value, const std::string& expected,
                 Reading& reading);

}  // namespace mjcourse

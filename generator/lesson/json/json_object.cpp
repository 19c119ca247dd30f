#include "lesson/json/json_object.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "base/nearest.h"

namespace mjcourse {
namespace {

const std::vector<JsonValue> kNoItems;

}  // namespace

void report_kind(const std::string& key, const JsonValue& value, const std::string& expected,
                 Reading& reading) {
  reading.error("E-json-kind", value.span,
                "\"" + key + "\" is " + kind_name(value.kind) + "; expected " + expected);
}

JsonObject::JsonObject(const JsonValue& value, const Vocabulary& vocabulary, Reading& reading)
    : value_(value),
      vocabulary_(vocabulary),
      what_(vocabulary.name),
      reading_(reading),
      is_object_(value.kind == JsonValue::Kind::object) {
  if (!is_object_) report_kind(what_, value, "an object", reading_);
}

const Key& JsonObject::key_of(const std::string& key) const {
  const Key* known = vocabulary_.find(key);
  if (known == nullptr) throw std::logic_error(what_ + ": its words lack " + key);
  return *known;
}

const Key& JsonObject::key_of(const std::string& key, std::initializer_list<KeyKind> kinds) const {
  const Key& known = key_of(key);
  if (std::find(kinds.begin(), kinds.end(), known.kind) == kinds.end()) {
    throw std::logic_error(what_ + ": " + key + " is of another kind than its reader takes");
  }
  return known;
}

const JsonValue* JsonObject::member(const std::string& key) const {
  for (const JsonMember& member : value_.members) {
    if (member.key.text == key) return &member.value;
  }
  return nullptr;
}

const JsonValue* JsonObject::find(const std::string& key) {
  key_of(key);
  if (std::find(asked_.begin(), asked_.end(), key) == asked_.end()) asked_.push_back(key);
  return member(key);
}

const JsonValue* JsonObject::require(const std::string& key, const std::string& message,
                                     const std::string& cure) {
  const JsonValue* value = find(key);
  if (value == nullptr && is_object_) {
    reading_.error("E-json-missing", {value_.span.begin, value_.span.begin + 1},
                   message.empty() ? "this " + what_ + " has no \"" + key + "\"" : message,
                   cure.empty() ? "add \"" + key + "\": …" : cure);
  }
  return value;
}

const JsonValue* JsonObject::of_kind(const std::string& key, JsonValue::Kind kind) {
  const JsonValue* value = key_of(key).need == Need::none ? find(key) : require(key);
  if (value == nullptr || value->kind == kind) return value;
  report_kind(key, *value, kind_name(kind), reading_);
  return nullptr;
}

void JsonObject::report_empty(const std::string& key, const std::string& cure) {
  reading_.error("E-json-missing", member(key)->span, "\"" + key + "\" is empty", cure);
}

LocatedText JsonObject::text_at(const std::string& key) {
  const JsonValue* value = of_kind(key, JsonValue::Kind::string);
  if (value == nullptr) return {};
  if (key_of(key).need == Need::filled && value->string.text.empty()) report_empty(key);
  return value->string;
}

LocatedText JsonObject::string(const std::string& key) {
  key_of(key,
         {KeyKind::text, KeyKind::markdown, KeyKind::model, KeyKind::expression, KeyKind::word});
  return text_at(key);
}

LocatedText JsonObject::required_string(const std::string& key) {
  LocatedText text = string(key);
  if (!has(key)) {
    require(key);
  } else if (member(key)->kind == JsonValue::Kind::string && text.text.empty()) {
    report_empty(key);
  }
  return text;
}

double JsonObject::number(const std::string& key, double otherwise) {
  return number(key, otherwise, key_of(key).limits);
}

double JsonObject::number(const std::string& key, double otherwise, const Limits& limits) {
  const std::optional<double> value = optional_number(key);
  if (!value) return otherwise;
  const bool fits = *value >= limits.least && *value <= limits.most;
  const bool whole = key_of(key).kind == KeyKind::whole;
  if (fits && (!whole || *value == std::floor(*value))) return *value;
  reading_.error("E-json-range", member(key)->span, "\"" + key + "\" " + std::string(limits.text));
  return otherwise;
}

int JsonObject::whole(const std::string& key, int otherwise) {
  key_of(key, {KeyKind::whole});
  return static_cast<int>(number(key, otherwise));
}

std::optional<double> JsonObject::optional_number(const std::string& key) {
  key_of(key, {KeyKind::number, KeyKind::whole});
  const JsonValue* value = of_kind(key, JsonValue::Kind::number);
  return value != nullptr ? std::optional<double>(value->number) : std::nullopt;
}

bool JsonObject::boolean(const std::string& key, bool otherwise) {
  key_of(key, {KeyKind::boolean});
  const JsonValue* value = of_kind(key, JsonValue::Kind::boolean);
  return value != nullptr ? value->boolean : otherwise;
}

const std::vector<JsonValue>& JsonObject::list(const std::string& key, const std::string& cure) {
  const Key& known = key_of(key, {KeyKind::objects, KeyKind::texts, KeyKind::expressions,
                                  KeyKind::texts_or_objects, KeyKind::point, KeyKind::size});
  const JsonValue* value = of_kind(key, JsonValue::Kind::array);
  if (value == nullptr) return kNoItems;
  if (known.need == Need::filled && value->items.empty()) report_empty(key, cure);
  return value->items;
}

LocatedText JsonObject::script(const std::string& key) {
  const Key& known = key_of(key, {KeyKind::script, KeyKind::mjcf});
  const JsonValue* value = known.need == Need::none ? find(key) : require(key);
  if (value == nullptr) return {};
  if (value->kind != JsonValue::Kind::array) return text_at(key);
  LocatedText lines;
  for (const JsonValue& line : value->items) {
    if (line.kind == JsonValue::Kind::string) {
      lines.append_line(line.string);
    } else {
      report_kind(key, line, "a string (one line of the script)", reading_);
    }
  }
  if (known.need == Need::filled && lines.text.empty()) report_empty(key);
  return lines;
}

const JsonValue* JsonObject::misplaced(const std::string& key) {
  if (vocabulary_.find(key) != nullptr) {
    throw std::logic_error(what_ + ": " + key + " is one of its words, and not misplaced");
  }
  const JsonValue* value = member(key);
  if (value != nullptr) misplaced_.push_back(key);
  return value;
}

void JsonObject::finish() {
  const auto is_in = [](const std::vector<std::string>& list, std::string_view key) {
    return std::find(list.begin(), list.end(), key) != list.end();
  };
  std::vector<std::string> known;
  for (const Key& key : vocabulary_.keys) {
    known.emplace_back(key.name);
    if (!is_in(asked_, key.name)) throw std::logic_error(what_ + ": nobody reads " + known.back());
  }
  for (const JsonMember& member : value_.members) {
    const std::string& key = member.key.text;
    if (vocabulary_.open || is_in(known, key) || is_in(misplaced_, key)) continue;
    const std::string article =
        std::string("aeiou").find(what_[0]) != std::string::npos ? "an " : "a ";
    reading_.error("E-json-key", member.key.span(), article + what_ + " has no key \"" + key + "\"",
                   suggest(key, known));
  }
}

}  // namespace mjcourse

#include "lesson/json_object.h"

#include <algorithm>
#include <cmath>
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

JsonObject::JsonObject(const JsonValue& value, std::string what, Reading& reading)
    : value_(value),
      what_(std::move(what)),
      reading_(reading),
      is_object_(value.kind == JsonValue::Kind::object) {
  if (!is_object_) report_kind(what_, value, "an object", reading_);
}

const JsonValue* JsonObject::find(const std::string& key) {
  if (std::find(asked_.begin(), asked_.end(), key) == asked_.end()) asked_.push_back(key);
  for (const JsonMember& member : value_.members) {
    if (member.key.text == key) return &member.value;
  }
  return nullptr;
}

const JsonValue* JsonObject::of_kind(const std::string& key, JsonValue::Kind kind) {
  const JsonValue* value = find(key);
  if (value == nullptr || value->kind == kind) return value;
  report_kind(key, *value, kind_name(kind), reading_);
  return nullptr;
}

const JsonValue* JsonObject::require(const std::string& key, const JsonValue* value) {
  if (value == nullptr && is_object_ && !has(key)) {
    reading_.error("E-json-missing", {value_.span.begin, value_.span.begin + 1},
                   "this " + what_ + " has no \"" + key + "\"", "add \"" + key + "\": …");
  }
  return value;
}

LocatedText JsonObject::string(const std::string& key) {
  const JsonValue* value = of_kind(key, JsonValue::Kind::string);
  return value != nullptr ? value->string : LocatedText{};
}

LocatedText JsonObject::required_string(const std::string& key) {
  const JsonValue* value = require(key, of_kind(key, JsonValue::Kind::string));
  if (value != nullptr && value->string.text.empty()) {
    reading_.error("E-json-missing", value->span, "\"" + key + "\" is empty");
  }
  return value != nullptr ? value->string : LocatedText{};
}

double JsonObject::number(const std::string& key, double otherwise) {
  return optional_number(key).value_or(otherwise);
}

double JsonObject::number(const std::string& key, double otherwise, const NumberRule& rule) {
  const std::optional<double> value = optional_number(key);
  if (!value) return otherwise;
  const bool fits = *value >= rule.least && *value <= rule.most;
  if (fits && (!rule.whole || *value == std::floor(*value))) return *value;
  reading_.error("E-json-range", find(key)->span, "\"" + key + "\" " + rule.text);
  return otherwise;
}

double JsonObject::required_number(const std::string& key) {
  const JsonValue* value = require(key, of_kind(key, JsonValue::Kind::number));
  return value != nullptr ? value->number : 0;
}

double JsonObject::required_number(const std::string& key, double otherwise,
                                   const NumberRule& rule) {
  require(key, find(key));
  return number(key, otherwise, rule);
}

int JsonObject::digits(int otherwise) {
  const NumberRule rule{0, 15, "counts the digits after the point: a whole number from 0 to 15",
                        true};
  return static_cast<int>(number("digits", otherwise, rule));
}

std::optional<double> JsonObject::optional_number(const std::string& key) {
  const JsonValue* value = of_kind(key, JsonValue::Kind::number);
  return value != nullptr ? std::optional<double>(value->number) : std::nullopt;
}

bool JsonObject::boolean(const std::string& key, bool otherwise) {
  const JsonValue* value = of_kind(key, JsonValue::Kind::boolean);
  return value != nullptr ? value->boolean : otherwise;
}

const std::vector<JsonValue>& JsonObject::list(const std::string& key) {
  const JsonValue* value = of_kind(key, JsonValue::Kind::array);
  return value != nullptr ? value->items : kNoItems;
}

const std::vector<JsonValue>& JsonObject::required_list(const std::string& key) {
  const JsonValue* value = require(key, of_kind(key, JsonValue::Kind::array));
  return value != nullptr ? value->items : kNoItems;
}

const std::vector<JsonValue>& JsonObject::filled_list(const std::string& key,
                                                      const std::string& cure) {
  const std::vector<JsonValue>& items = required_list(key);
  const JsonValue* value = find(key);
  if (value != nullptr && value->kind == JsonValue::Kind::array && items.empty()) {
    reading_.error("E-json-missing", value->span, "\"" + key + "\" is empty", cure);
  }
  return items;
}

LocatedText JsonObject::script(const std::string& key) {
  const JsonValue* value = find(key);
  if (value == nullptr) return {};
  if (value->kind != JsonValue::Kind::array) return string(key);
  LocatedText lines;
  for (const JsonValue& line : value->items) {
    if (line.kind == JsonValue::Kind::string) {
      lines.append_line(line.string);
    } else {
      report_kind(key, line, "a string (one line of the script)", reading_);
    }
  }
  return lines;
}

LocatedText JsonObject::required_script(const std::string& key) {
  LocatedText text = script(key);
  if (!is_object_ || !text.text.empty()) return text;
  if (!has(key)) {
    require(key, nullptr);
  } else if (const auto kind = find(key)->kind;
             kind == JsonValue::Kind::string || kind == JsonValue::Kind::array) {
    reading_.error("E-json-missing", find(key)->span, "\"" + key + "\" is empty");
  }
  return text;
}

void JsonObject::finish() {
  for (const JsonMember& member : value_.members) {
    const std::string& key = member.key.text;
    if (std::find(asked_.begin(), asked_.end(), key) != asked_.end()) continue;
    const std::string article =
        std::string("aeiou").find(what_[0]) != std::string::npos ? "an " : "a ";
    reading_.error("E-json-key", member.key.span(), article + what_ + " has no key \"" + key + "\"",
                   suggest(key, asked_));
  }
}

}  // namespace mjcourse

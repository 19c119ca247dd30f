#include "page/json_schema.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "lesson/json/json_fences.h"
#include "page/plot_schema.h"

namespace mjcourse {
namespace {

using nlohmann::ordered_json;

ordered_json object_schema(const Vocabulary& vocabulary);

ordered_json of_type(const char* type) {
  return {{"type", type}};
}

ordered_json list_of(ordered_json items) {
  return {{"type", "array"}, {"items", std::move(items)}};
}

ordered_json list_of(ordered_json items, const Limits& count) {
  ordered_json list = list_of(std::move(items));
  if (!count.text.empty()) {
    list["minItems"] = static_cast<int>(count.least);
    list["maxItems"] = static_cast<int>(count.most);
  }
  return list;
}

ordered_json lines() {
  return {{"type", {"string", "array"}}, {"items", of_type("string")}};
}

ordered_json one_of(ordered_json first, ordered_json second) {
  return {{"anyOf", {std::move(first), std::move(second)}}};
}

ordered_json number(const char* type, const Limits& limits) {
  ordered_json schema = of_type(type);
  const Limits none;
  if (limits.least == kAboveZero) {
    schema["exclusiveMinimum"] = 0;
  } else if (limits.least > none.least) {
    schema["minimum"] = limits.least;
  }
  if (limits.most < none.most) schema["maximum"] = limits.most;
  return schema;
}

ordered_json words_of(const Vocabulary& vocabulary) {
  ordered_json words = ordered_json::array();
  for (const Variant& one : vocabulary.variants) words.push_back(one.word);
  return {{"type", "string"}, {"enum", std::move(words)}};
}

// What may stand behind `key` of `owner`.
ordered_json value_schema(const Key& key, const Vocabulary& owner) {
  switch (key.kind) {
    case KeyKind::text:
    case KeyKind::markdown:
    case KeyKind::model:
    case KeyKind::expression:
      return of_type("string");
    case KeyKind::script:
    case KeyKind::mjcf:
      return lines();
    case KeyKind::word:
      return words_of(owner);
    case KeyKind::number:
      return number("number", key.limits);
    case KeyKind::whole:
      return number("integer", key.limits);
    case KeyKind::boolean:
      return of_type("boolean");
    case KeyKind::tolerance:
      return one_of({{"type", "number"}, {"minimum", 0}},
                    {{"type", "string"}, {"pattern", "^[0-9.]+([eE][+-]?[0-9]+)? *%$"}});
    case KeyKind::point:
      return list_of(of_type("number"), {3, 3, "is a point"});
    case KeyKind::size:
      return list_of(number("integer", key.limits), {2, 2, "is a width and a height"});
    case KeyKind::indices:
      return list_of({{"type", "integer"}, {"minimum", 0}}, key.limits);
    case KeyKind::texts:
    case KeyKind::expressions:
      return list_of(of_type("string"), key.limits);
    case KeyKind::overlays:
      return {{"type", "object"}, {"additionalProperties", of_type("boolean")}};
    case KeyKind::object:
      return object_schema(*key.of);
    case KeyKind::objects:
      return list_of(object_schema(*key.of), key.limits);
    case KeyKind::texts_or_objects:
      return list_of(one_of(of_type("string"), object_schema(*key.of)), key.limits);
    case KeyKind::true_or_object:
      return one_of(of_type("boolean"), object_schema(*key.of));
  }
  return ordered_json::object();
}

ordered_json key_schema(const Key& key, const Vocabulary& owner) {
  ordered_json schema = value_schema(key, owner);
  schema["description"] = key.meaning;
  if (key.need == Need::filled && key.kind != KeyKind::word) {
    const bool text = schema["type"] == "string" || schema["type"].is_array();
    if (text) schema["minLength"] = 1;
    if (schema.contains("items") && !schema.contains("minItems")) schema["minItems"] = 1;
  }
  return schema;
}

// `word`: what the first key must say, where it decides.
ordered_json plain_object_schema(const Vocabulary& vocabulary, std::string_view word) {
  ordered_json properties = ordered_json::object(), required = ordered_json::array();
  for (const Key& key : vocabulary.keys) {
    const std::string name(key.name);
    properties[name] = key_schema(key, vocabulary);
    if (key.kind == KeyKind::word) {
      properties[name] = {{"const", word}, {"description", key.meaning}};
    }
    if (key.need != Need::none) required.push_back(name);
  }
  ordered_json schema{{"type", "object"}, {"properties", std::move(properties)}};
  if (!required.empty()) schema["required"] = std::move(required);
  schema["additionalProperties"] = vocabulary.open;
  return schema;
}

ordered_json object_schema(const Vocabulary& vocabulary) {
  if (vocabulary.variants.empty()) return plain_object_schema(vocabulary, "");
  // What all have comes first, so that a misspelt word is what an editor complains of.
  ordered_json schema = plain_object_schema(vocabulary, "");
  const Key& chooser = vocabulary.keys.front();
  schema["properties"][std::string(chooser.name)] = key_schema(chooser, vocabulary);
  schema["additionalProperties"] = true;
  for (const Variant& variant : vocabulary.variants) {
    schema["oneOf"].push_back(plain_object_schema(*variant.vocabulary, variant.word));
  }
  return schema;
}

}  // namespace

ordered_json json_schema(const JsonFence& fence, const PlotGrammar& grammar) {
  ordered_json schema{{"$schema", "http://json-schema.org/draft-07/schema#"},
                      {"title", "mjcourse: a fence `" + std::string(fence.opened) + "`"}};
  schema.update(object_schema(*fence.vocabulary));
  if (fence.vocabulary->open) add_plot_schema(grammar, schema);
  return schema;
}

std::string schema_path(const JsonFence& fence) {
  return "schemas/" + std::string(fence.name) + ".schema.json";
}

}  // namespace mjcourse

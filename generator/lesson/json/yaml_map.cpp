#include "lesson/json/yaml_map.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include "base/nearest.h"

namespace mjcourse {
namespace {

// Of a mapping of texts: each formula of a course looks at all of its macros.
constexpr std::size_t kMostTexts = 20'000;  // bytes

// A YAML mark counts lines and columns from 0, and bytes from the text's start.
Span span_of(const YAML::Mark& mark, std::size_t length, const LocatedText& text) {
  const auto begin = mark.is_null() ? 0 : static_cast<std::size_t>(mark.pos);
  return text.span(begin, begin + std::max<std::size_t>(1, length));
}

// Where a tab indents a line of `text` up to the one after `last`, which YAML does not take; npos
// for nowhere.
std::size_t indenting_tab(std::string_view text, int last) {
  std::size_t begin = 0;
  for (int line = 0; line <= last + 1 && begin < text.size(); ++line) {
    const std::size_t word = text.find_first_not_of(" -\t", begin);
    const std::size_t tab = text.substr(0, word).find('\t', begin);
    if (tab != text.npos) return tab;
    begin = std::min(text.find('\n', begin), text.size() - 1) + 1;
  }
  return text.npos;
}

}  // namespace

std::optional<YAML::Node> parse_yaml(const LocatedText& text, const std::string& what,
                                     const std::string& id, Reading& reading) {
  try {
    return YAML::Load(text.text);
  } catch (const YAML::Exception& error) {
    const std::size_t tab = indenting_tab(text.text, error.mark.line);
    if (tab != std::string::npos) {
      reading.error(id, text.span(tab, tab + 1),
                    "the " + what + " is indented with a tab here, which YAML does not take",
                    "indent with spaces");
      return std::nullopt;
    }
    reading.error(id, span_of(error.mark, 1, text), "the " + what + " is not YAML: " + error.msg,
                  "quote a value that holds `: ` or starts with a special character");
    return std::nullopt;
  }
}

YamlMap::YamlMap(const YAML::Node& node, std::string what, std::string id, const LocatedText& text,
                 Reading& reading)
    : map_(node), what_(std::move(what)), id_(std::move(id)), text_(text), reading_(reading) {
  is_map_ = map_.IsMap();
  if (!is_map_) {
    error(map_, "the " + what_ + " must be a mapping: `key: value` lines");
    map_ = YAML::Node(YAML::NodeType::Map);
  }
}

YAML::Node YamlMap::find(const std::string& key) {
  asked_.push_back(key);
  const YAML::Node& map = map_;  // reading through a const node does not create the key
  return map[key] ? map[key] : YAML::Node(YAML::NodeType::Undefined);
}

LocatedText YamlMap::scalar(const YAML::Node& node) const {
  LocatedText result{node.Scalar(), {}};
  // A folded value, or one with escapes, does not stand byte for byte in the file: its start must
  // do. A quoted one stands behind its quote.
  const auto stands_at = [&](std::size_t at) {
    return at < text_.text.size() && text_.text.compare(at, result.text.size(), result.text) == 0;
  };
  const auto mark = static_cast<std::size_t>(node.Mark().pos);
  const bool quoted =
      mark < text_.text.size() && (text_.text[mark] == '"' || text_.text[mark] == '\'');
  const std::size_t start = quoted ? mark + 1 : mark;
  const std::size_t size = result.text.size();
  if (stands_at(start)) return text_.part(start, start + size);
  result.offsets.append_still(size + 1, span_of(node.Mark(), 1, text_).begin);
  return result;
}

void YamlMap::error(const YAML::Node& node, const std::string& message, const std::string& cure) {
  // A value that is not there stands, to the library, at whatever comes next.
  if (node.IsNull() && map_.IsMap()) {
    for (const auto& entry : map_) {
      if (entry.second.is(node)) return error(entry.first, message, "write it after the colon");
    }
  }
  const std::size_t length = node.IsScalar() ? node.Scalar().size() : 1;
  reading_.error(id_, span_of(node.Mark(), length, text_), message, cure);
}

LocatedText YamlMap::text_of(const YAML::Node& value, const std::string& key) {
  if (!value.IsDefined()) return {};
  if (value.IsScalar()) return scalar(value);
  error(value, "`" + key + "` must be a text");
  return {};
}

LocatedText YamlMap::string(const std::string& key) {
  return text_of(find(key), key);
}

LocatedText YamlMap::required_string(const std::string& key) {
  const YAML::Node value = find(key);
  LocatedText text = text_of(value, key);
  const bool is_told = value.IsDefined() && !value.IsScalar();
  if (text.text.empty() && is_map_ && !is_told) {
    error(map_, "the " + what_ + " has no `" + key + "`", "add a line `" + key + ": …`");
  }
  return text;
}

std::optional<int> YamlMap::count(const std::string& key) {
  const YAML::Node value = find(key);
  if (!value.IsDefined()) return std::nullopt;
  double number = 0;
  if (!value.IsScalar() || !YAML::convert<double>::decode(value, number)) {
    error(value, "`" + key + "` must be a number");
  } else if (number >= 0 && number <= 1e6 && number == std::floor(number)) {
    return static_cast<int>(number);
  } else {
    error(value, "`" + key + "` must be a whole number, not less than 0");
  }
  return std::nullopt;
}

bool YamlMap::boolean(const std::string& key, bool otherwise) {
  const YAML::Node value = find(key);
  if (!value.IsDefined()) return otherwise;
  bool result = otherwise;
  if (value.IsScalar() && YAML::convert<bool>::decode(value, result)) return result;
  error(value, "`" + key + "` must be true or false");
  return otherwise;
}

std::vector<LocatedText> YamlMap::strings(const std::string& key) {
  const YAML::Node value = find(key);
  std::vector<LocatedText> items;
  if (!value.IsDefined()) return items;
  if (!value.IsSequence()) {
    error(value, "`" + key + "` must be a list: [a, b]");
    return items;
  }
  for (const YAML::Node& item : value) {
    if (item.IsScalar()) {
      items.push_back(scalar(item));
    } else {
      error(item, "each of `" + key + "` must be a plain value");
    }
  }
  return items;
}

std::map<std::string, std::string> YamlMap::texts(const std::string& key) {
  const YAML::Node value = find(key);
  std::map<std::string, std::string> texts;
  if (!value.IsDefined()) return texts;
  if (!value.IsMap()) {
    error(value, "`" + key + "` must be a mapping: `name: text` lines");
    return texts;
  }
  std::size_t bytes = 0;
  for (const auto& member : value) {
    if (member.first.IsScalar() && member.second.IsScalar()) {
      bytes += member.first.Scalar().size() + member.second.Scalar().size();
      texts[member.first.Scalar()] = member.second.Scalar();
    } else {
      error(member.first, "each of `" + key + "` must be a plain value");
    }
  }
  if (bytes > kMostTexts) {
    error(value, "`" + key + "` may have " + std::to_string(kMostTexts) + " bytes in all");
    texts.clear();
  }
  return texts;
}

std::vector<YAML::Node> YamlMap::required_items(const std::string& key) {
  const YAML::Node value = find(key);
  if (value.IsDefined() && value.IsSequence() && value.size() > 0) {
    return {value.begin(), value.end()};
  }
  if (value.IsDefined()) {
    error(value, "`" + key + "` must be a list with at least one item");
  } else if (is_map_) {
    error(map_, "the " + what_ + " has no `" + key + "`", "add a line `" + key + ":` and a list");
  }
  return {};
}

void YamlMap::finish() {
  std::set<std::string> seen;
  for (const auto& member : map_) {
    const std::string key = member.first.IsScalar() ? member.first.Scalar() : "";
    if (!seen.insert(key).second) error(member.first, "the key `" + key + "` stands twice");
    if (std::find(asked_.begin(), asked_.end(), key) != asked_.end()) continue;
    error(member.first, "the " + what_ + " has no key `" + key + "`", suggest(key, asked_));
  }
}

}  // namespace mjcourse

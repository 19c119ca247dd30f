#include "lesson/json/json_value.h"

#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>
#include <utility>

#include "base/utf8.h"
#include "lesson/json/json_depth.h"

namespace mjcourse {
namespace {

using nlohmann::json;

constexpr double kFirstInexact = 0x1p53;  // no double is one more

// Counts what the lexer has read, so that each event knows where it is.
class CountingIterator {
 public:
  using difference_type = std::ptrdiff_t;
  using value_type = char;
  using pointer = const char*;
  using reference = const char&;
  using iterator_category = std::input_iterator_tag;

  CountingIterator(const char* at, std::size_t* count) : at_(at), count_(count) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    ++at_;
    ++*count_;
    return *this;
  }
  bool operator==(const CountingIterator& other) const { return at_ == other.at_; }
  bool operator!=(const CountingIterator& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  std::size_t* count_;
};

// Where the string whose closing quote stands before `end` opens: the nearest quote before it that
// no backslash escapes; the quote itself where there is none.
std::size_t opening_quote(std::string_view text, std::size_t end) {
  for (std::size_t at = end - 1; at > 0;) {
    at = text.rfind('"', at - 1);
    if (at == text.npos) break;
    std::size_t backslashes = 0;
    while (backslashes < at && text[at - 1 - backslashes] == '\\') ++backslashes;
    if (backslashes % 2 == 0) return at;
  }
  return end - 1;
}

class TreeBuilder {
 public:
  using string_t = json::string_t;
  using binary_t = json::binary_t;

  TreeBuilder(const LocatedText& text, const std::size_t& read, Reading& reading)
      : text_(text), read_(read), reading_(reading) {}

  bool null() { return add(scalar(JsonValue::Kind::null)); }
  bool boolean(bool value) {
    JsonValue result = scalar(JsonValue::Kind::boolean);
    result.boolean = value;
    return add(std::move(result));
  }
  bool number_integer(json::number_integer_t value) {
    return add_whole_number(static_cast<double>(value));
  }
  bool number_unsigned(json::number_unsigned_t value) {
    return add_whole_number(static_cast<double>(value));
  }
  bool number_float(double value, const string_t& text) {
    // A whole number that is too large for 64 bits comes as one of these.
    const bool whole = text.find_first_of(".eE") == text.npos;
    return whole ? add_whole_number(value) : add_number(value);
  }
  bool string(string_t& value) {
    JsonValue result;
    result.kind = JsonValue::Kind::string;
    result.string = decoded(value);
    result.span = text_.span(opening_quote(text_.text, read_), read_);
    return add(std::move(result));
  }
  bool binary(binary_t&) { return false; }
  bool start_object(std::size_t) { return open(JsonValue::Kind::object); }
  bool start_array(std::size_t) { return open(JsonValue::Kind::array); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool key(string_t& value) {
    const LocatedText name = decoded(value);
    if (!keys_of_open_.back().insert(name.text).second) {
      reading_.error("E-json-duplicate", name.span(), "the key \"" + name.text + "\" stands twice",
                     "keep one of the two");
      return false;
    }
    keys_.back() = name;
    return true;
  }
  bool parse_error(std::size_t position, const std::string&, const json::exception& error);

  std::optional<JsonValue> take() { return std::move(result_); }

 private:
  JsonValue scalar(JsonValue::Kind kind) const {
    JsonValue result;
    result.kind = kind;
    // Literals end where reading stands; a number's end is seen one character late.
    const std::string_view text(text_.text);
    std::size_t end = read_;
    while (end > 0 && std::string_view(" \t\r\n,]}").find(text[end - 1]) != text.npos) --end;
    std::size_t begin = end;
    while (begin > 0 && std::string_view(" \t\r\n,[{:").find(text[begin - 1]) == text.npos) --begin;
    result.span = text_.span(begin, end);
    return result;
  }
  bool add_whole_number(double value) {
    if (std::abs(value) < kFirstInexact) return add_number(value);
    reading_.error("E-json-range", scalar(JsonValue::Kind::number).span,
                   "whole numbers are exact below 2^53, and this one is not below",
                   "if its last digits do not matter, write it with an exponent, such as 1.2e16");
    return false;
  }
  bool add_number(double value) {
    JsonValue result = scalar(JsonValue::Kind::number);
    result.number = value;
    return add(std::move(result));
  }
  LocatedText decoded(const std::string& value) const;
  bool add(JsonValue value) {
    if (open_.empty()) {
      result_ = std::move(value);
    } else if (open_.back().kind == JsonValue::Kind::array) {
      open_.back().items.push_back(std::move(value));
    } else {
      open_.back().members.push_back({keys_.back(), std::move(value)});
    }
    return true;
  }
  bool open(JsonValue::Kind kind) {
    if (open_.size() == kDeepestJson) {
      reading_.error(
          "E-json-depth", text_.span(read_ - 1, read_),
          "lists and objects are nested here more than " + std::to_string(kDeepestJson) + " deep",
          "is a bracket closed too late?");
      return false;
    }
    JsonValue value;
    value.kind = kind;
    value.span = text_.span(read_ - 1, read_);
    open_.push_back(std::move(value));
    keys_.emplace_back();
    keys_of_open_.emplace_back();
    return true;
  }
  bool close() {
    JsonValue value = std::move(open_.back());
    value.span.end = text_.span(read_, read_).begin;
    open_.pop_back();
    keys_.pop_back();
    keys_of_open_.pop_back();
    return add(std::move(value));
  }

  const LocatedText& text_;
  const std::size_t& read_;
  Reading& reading_;
  std::vector<JsonValue> open_;
  std::vector<LocatedText> keys_;  // the pending key of each open object
  std::vector<std::set<std::string>> keys_of_open_;
  std::optional<JsonValue> result_;
};

// Walk the raw string beside its decoded bytes; every escape but \u is two bytes for one.
LocatedText TreeBuilder::decoded(const std::string& value) const {
  LocatedText result{value, {}};
  std::size_t raw = opening_quote(text_.text, read_) + 1;
  for (std::size_t i = 0; i < value.size();) {
    const bool escape = text_.text[raw] == '\\';
    const std::size_t bytes = escape ? character_end(value, i) - i : 1;
    for (std::size_t b = 0; b < bytes; ++b) result.offsets.push_back(text_.span(raw, raw).begin);
    // A character outside the basic plane takes two \uXXXX.
    raw += !escape ? 1 : text_.text[raw + 1] != 'u' ? 2 : bytes == 4 ? 12 : 6;
    i += bytes;
  }
  result.offsets.push_back(text_.span(raw, raw).begin);
  return result;
}

// Of a number or a literal, as JSON has them.
bool is_word(char c) {
  return is_letter_or_digit(c) || c == '.' || c == '+' || c == '-';
}

// Where the word that ends before `end` begins: a string, a number, a literal, one other character.
std::size_t word_begin(std::string_view text, std::size_t end) {
  if (text[end - 1] == '"' && end > 1) return opening_quote(text, end);
  std::size_t begin = end - 1;
  while (begin > 0 && is_word(text[end - 1]) && is_word(text[begin - 1])) --begin;
  return begin;
}

// What nlohmann says in its way: "… syntax error while parsing object key - invalid literal; last
// read: '…'; expected string literal".
std::string explain(std::string_view what) {
  const auto between = [&](std::string_view start, std::string_view end) {
    const std::size_t from = what.find(start);
    if (from == what.npos) return std::string();
    const std::string_view rest = what.substr(from + start.size());
    return std::string(rest.substr(0, rest.find(end)));
  };
  if (what.find("control character") != what.npos) {
    return "a JSON string cannot hold a raw line break or tab";
  }
  if (what.find("number overflow") != what.npos) return "this number is too large";
  const std::string wanted = between("; expected ", "\n");
  // Where a list or an object could end, it could also go on.
  const bool goes_on = wanted == "'}'" || wanted == "']'";
  if (!wanted.empty()) {
    return "this is not JSON: expected " + std::string(goes_on ? "',' or " : "") + wanted;
  }
  return "this is not JSON: " + between(" - ", "; last read");
}

bool TreeBuilder::parse_error(std::size_t position, const std::string&,
                              const json::exception& error) {
  const std::string_view what(error.what()), text(text_.text);
  const auto speaks_of = [&](std::string_view words) { return what.find(words) != what.npos; };
  std::string cure = "look for a missing comma, quote or bracket just before this";
  if (speaks_of("control character")) cure = "write \\n, or give the script as a list of lines";
  if (speaks_of("after backslash")) cure = "in JSON a backslash is written twice: \\\\alpha";
  if (speaks_of("number overflow")) cure = "";
  if (position > text.size()) {
    reading_.error("E-json-syntax", text_.span(text.size(), text.size()),
                   explain(what) + ", but the text ends here", cure);
    return false;
  }
  // A literal is given up one character behind it.
  const bool behind = speaks_of("invalid literal") && position > 1 &&
                      !is_word(text[position - 1]) && is_word(text[position - 2]);
  const std::size_t end = behind ? position - 1 : position;
  const bool in_string = speaks_of("invalid string");
  reading_.error("E-json-syntax", text_.span(in_string ? end - 1 : word_begin(text, end), end),
                 explain(what), cure);
  return false;
}

}  // namespace

std::string kind_name(JsonValue::Kind kind) {
  switch (kind) {
    case JsonValue::Kind::null:
      return "null";
    case JsonValue::Kind::boolean:
      return "true or false";
    case JsonValue::Kind::number:
      return "a number";
    case JsonValue::Kind::string:
      return "a string";
    case JsonValue::Kind::array:
      return "a list";
    case JsonValue::Kind::object:
      return "an object";
  }
  return "";
}

std::optional<JsonValue> parse_json(const LocatedText& text, Reading& reading) {
  std::size_t read = 0;
  TreeBuilder builder(text, read, reading);
  const char* begin = text.text.data();
  const bool good = json::sax_parse(CountingIterator(begin, &read),
                                    CountingIterator(begin + text.text.size(), &read), &builder);
  return good ? builder.take() : std::nullopt;
}

}  // namespace mjcourse

#include "lesson/blocks/fence.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "base/nearest.h"

namespace mjcourse {
namespace {

// What stands before the fence on its line: indentation and the marks of quotes and lists.
std::size_t find_fence(std::string_view line, char mark) {
  return std::min(line.find(std::string(3, mark)), line.size());
}

bool closes(std::string_view line, int length, char mark) {
  const std::size_t last = line.find_last_not_of(" \t\r");
  if (last == line.npos || line[last] != mark) return false;
  std::size_t first = last;
  while (first > 0 && line[first - 1] == mark) --first;
  const bool only_prefix = line.substr(0, first).find_first_not_of(" \t>") == line.npos;
  return only_prefix && static_cast<int>(last - first) + 1 >= length;
}

// Does a fence with an info string open on this line? Inside another of its length it can only mean
// that the other was never closed.
bool opens(std::string_view line, int length, char mark) {
  const std::size_t first = line.find_first_not_of(" \t>");
  if (first == line.npos || line[first] != mark) return false;
  const std::size_t word = line.find_first_not_of(mark, first);
  return word != line.npos && static_cast<int>(word - first) >= length && line[word] >= 'a' &&
         line[word] <= 'z';
}

}  // namespace

Fence::Fence(cmark_node* node, const SourceText& source) {
  const int first = cmark_node_get_start_line(node);
  const int last = cmark_node_get_end_line(node);
  const std::size_t start = source.line_start(first);
  const std::string_view line = source.line(first);
  int length = 0, offset = 0;
  char mark = '`';
  indented_ = cmark_node_get_fenced(node, &length, &offset, &mark) == 0;
  const std::size_t fence = indented_ ? 0 : find_fence(line, mark);
  span_ = {start + fence, start + line.size()};
  if (indented_) return;
  closed_ = last > first && closes(source.line(last), length, mark);
  for (int inside = first + 1; inside < last; ++inside) {
    if (opens(source.line(inside), length, mark)) closed_ = false;
  }
  const std::size_t info = std::min(line.find_first_not_of(mark, fence), line.size());
  read_info(source, start + info, start + line.size());
  read_body(node, source);
}

void Fence::read_info(const SourceText& source, std::size_t begin, std::size_t end) {
  const std::string_view text = source.text();
  while (begin < end) {
    if (text[begin] == ' ' || text[begin] == '\t') {
      ++begin;
      continue;
    }
    std::size_t stop = begin;
    std::size_t equals = 0;
    for (bool quoted = false; stop < end && (quoted || text[stop] != ' '); ++stop) {
      if (text[stop] == '"') quoted = !quoted;
      if (text[stop] == '=' && equals == 0) equals = stop;
    }
    if (equals == 0) {
      words_.push_back(located(source, {begin, stop}));
    } else {
      const bool quoted = stop - equals >= 3 && text[equals + 1] == '"' && text[stop - 1] == '"';
      const Span value{equals + (quoted ? 2 : 1), stop - (quoted ? 1 : 0)};
      options_.push_back({located(source, {begin, equals}), located(source, value)});
    }
    begin = stop;
  }
}

void Fence::read_body(cmark_node* node, const SourceText& source) {
  const std::string_view literal(cmark_node_get_literal(node));
  int number = cmark_node_get_start_line(node) + 1;
  for (std::size_t at = 0; at < literal.size(); ++number) {
    const std::size_t end = std::min(literal.find('\n', at), literal.size() - 1);
    const std::string_view line = literal.substr(at, end - at);
    const std::string_view raw = source.line(number);
    // Indentation and quote marks are gone from the front; the rest stands as it stood.
    const std::size_t prefix = raw.size() - std::min(raw.size(), line.size());
    const std::size_t begin = source.line_start(number) + prefix;
    body_.offsets.append(Offsets::side_by_side(begin, begin + line.size()), 0, line.size() + 1);
    at = end + 1;
  }
  body_.text = literal;
  body_.offsets.push_back(source.line_start(number));
}

std::optional<LocatedText> Fence::option(const std::string& name) const {
  for (const Option& option : options_) {
    if (option.name.text == name) return option.value;
  }
  return std::nullopt;
}

std::optional<double> Fence::number(const std::string& name, Reading& reading, double most) const {
  const std::optional<LocatedText> text = option(name);
  if (!text) return std::nullopt;
  double value = 0;
  const char* end = text->text.data() + text->text.size();
  const auto [stop, failure] = std::from_chars(text->text.data(), end, value);
  if (failure == std::errc() && stop == end && value >= 0 && value <= most) return value;
  const bool bounded = most < std::numeric_limits<double>::max();
  reading.error("E-fence-option", text->span(),
                "`" + name + "` must be a number, not less than 0" +
                    (bounded ? " and not more than " + std::to_string(std::lround(most)) : ""));
  return std::nullopt;
}

bool Fence::flag(const std::string& name) const {
  return std::any_of(words_.begin(), words_.end(),
                     [&](const LocatedText& word) { return word.text == name; });
}

bool Fence::refuse_second_word(const std::vector<std::string>& known, Reading& reading) const {
  if (words_.size() < 2) return false;
  const LocatedText& second = words_[1];
  reading.error("E-fence-kind", second.span(),
                "there is no fence `" + words_[0].text + " " + second.text + "`",
                suggest(second.text, known));
  return true;
}

void Fence::finish(const std::string& kind, std::span<const FenceOption> options,
                   Reading& reading) const {
  const auto check = [&](const LocatedText& name, bool has_value) {
    const auto known = std::find_if(options.begin(), options.end(),
                                    [&](const FenceOption& one) { return one.name == name.text; });
    if (known == options.end()) {
      std::vector<std::string> names;
      for (const FenceOption& option : options) names.emplace_back(option.name);
      reading.error("E-fence-option", name.span(),
                    "a `" + kind + "` fence has no option `" + name.text + "`",
                    names.empty() ? "" : suggest(name.text, names));
    } else if (known->has_value && !has_value) {
      reading.error("E-fence-option", name.span(), "`" + name.text + "` needs a value",
                    "write `" + name.text + "=…`");
    } else if (!known->has_value && has_value) {
      reading.error("E-fence-option", name.span(), "`" + name.text + "` takes no value",
                    "write `" + name.text + "` alone");
    }
  };
  const auto of_kind = 1 + std::count(kind.begin(), kind.end(), ' ');
  for (auto word = words_.begin() + of_kind; word < words_.end(); ++word) check(*word, false);
  for (const Option& option : options_) check(option.name, true);
}

}  // namespace mjcourse

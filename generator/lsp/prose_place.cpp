#include "lsp/prose_place.h"

#include <algorithm>

namespace mjcourse {
namespace {

using PlaceKind = ProsePlace::Kind;

// Behind the last `mark`; nothing where there is none.
std::optional<std::string_view> behind(std::string_view text, std::string_view mark) {
  const std::size_t at = text.rfind(mark);
  if (at == text.npos) return std::nullopt;
  return text.substr(at + mark.size());
}

bool has(std::string_view text, std::string_view any_of) {
  return text.find_first_of(any_of) != text.npos;
}

// "```cpp file=exam": the line of a fence's beginning.
std::optional<ProsePlace> opening_place(std::string_view before) {
  const std::size_t begin = before.find_first_not_of(" \t>");
  if (begin == before.npos || (before[begin] != '`' && before[begin] != '~')) return std::nullopt;
  const std::size_t info = before.find_first_not_of(before[begin], begin);
  const std::size_t marks = std::min(info, before.size()) - begin;
  if (marks < 3) return std::nullopt;
  if (info == before.npos) return ProsePlace{PlaceKind::fence};
  const std::string_view rest = before.substr(info);
  if (has(rest, "`")) return std::nullopt;
  if (!has(rest, " \t")) return ProsePlace{PlaceKind::fence, "", std::string(rest)};
  const std::size_t last = rest.find_last_of(" \t") + 1;
  if (std::ranges::count(rest.substr(0, last), '"') % 2 == 1) return std::nullopt;
  const std::string_view word = rest.substr(last);
  const std::size_t equals = word.find('=');
  if (equals == word.npos) {
    return ProsePlace{PlaceKind::option, std::string(rest.substr(0, last)), std::string(word)};
  }
  const std::string part(word.substr(equals + 1));
  const std::string_view option = word.substr(0, equals);
  if (option == "model") return ProsePlace{PlaceKind::model, "", part};
  if (option == "file") return ProsePlace{PlaceKind::file, "", part};
  if (option == "output") return ProsePlace{PlaceKind::program, "", part};
  return ProsePlace{PlaceKind::choice, std::string(rest.substr(0, last + equals)), part};
}

std::optional<ProsePlace> link_place(std::string_view target) {
  if (has(target, ") \t")) return std::nullopt;
  if (target.starts_with("model:"))
    return ProsePlace{PlaceKind::model, "", std::string(target.substr(6))};
  if (target.starts_with("api:"))
    return ProsePlace{PlaceKind::api, "", std::string(target.substr(4))};
  if (const std::size_t hash = target.find('#'); hash != target.npos) {
    return ProsePlace{PlaceKind::heading, std::string(target.substr(0, hash)),
                      std::string(target.substr(hash + 1))};
  }
  return ProsePlace{PlaceKind::link, "", std::string(target)};
}

// `span` is what stands in a code span so far.
std::optional<ProsePlace> value_place(std::string_view span) {
  if (!span.starts_with('{')) return std::nullopt;
  const std::size_t end = span.find('}');
  if (end == span.npos) return ProsePlace{PlaceKind::source, "", std::string(span.substr(1))};
  const std::string_view rest = span.substr(end + 1);
  const std::size_t name = rest.find_first_not_of(' ');
  return ProsePlace{PlaceKind::value, std::string(span.substr(1, end - 1)),
                    name == rest.npos ? "" : std::string(rest.substr(name))};
}

}  // namespace

std::optional<ProsePlace> prose_place(std::string_view before, bool in_fence) {
  if (in_fence) return std::nullopt;
  if (auto opening = opening_place(before)) return opening;
  if (std::ranges::count(before, '`') % 2 == 1) return value_place(*behind(before, "`"));
  const auto quote = behind(before, "> [!");
  if (quote && !has(*quote, "] ")) return ProsePlace{PlaceKind::callout, "", std::string(*quote)};
  const auto link = behind(before, "](");
  if (link) {
    if (auto place = link_place(*link)) return place;
  }
  const auto term = behind(before, "[[");
  if (term && !has(*term, "]|")) return ProsePlace{PlaceKind::term, "", std::string(*term)};
  return std::nullopt;
}

}  // namespace mjcourse

#include "lsp/script_cursor.h"

#include <algorithm>

#include "base/utf8.h"

namespace mjcourse {
namespace {

// Where the name begins that ends at `end`.
std::size_t name_begin(std::string_view text, std::size_t end) {
  while (end > 0 && is_word_character(text[end - 1])) --end;
  return end;
}

// The length of the `.` or `->` that ends at `end`; 0 where there is none.
std::size_t arrow(std::string_view text, std::size_t end) {
  const std::string_view before = text.substr(0, end);
  return before.ends_with("->") ? 2 : before.ends_with(".") ? 1 : 0;
}

// "model.opt" of `model.opt` or `model->opt`, which ends at `end`; "" where it is no such path.
std::string path_before(std::string_view text, std::size_t end) {
  std::size_t root = end;
  for (std::size_t name_end = end;;) {
    root = name_begin(text, name_end);
    if (root == name_end) return "";
    const std::size_t joined = arrow(text, root);
    if (joined == 0) break;
    name_end = root - joined;
  }
  std::string path;
  for (const char c : text.substr(root, end - root)) {
    if (c != '-') path += c == '>' ? '.' : c;
  }
  const std::string_view first = std::string_view(path).substr(0, path.find('.'));
  return first == "data" || first == "model" ? path : "";
}

// `qpos('hin`: the quote that is open, behind a bracket and a function's name.
std::optional<ScriptCursor> object_before(std::string_view before) {
  const std::size_t line = before.rfind('\n') == before.npos ? 0 : before.rfind('\n') + 1;
  char quote = 0;
  std::size_t begin = 0;
  for (std::size_t i = line; i < before.size(); ++i) {
    const char c = before[i];
    if (quote == 0 && (c == '\'' || c == '"')) {
      quote = c;
      begin = i;
    } else if (c == quote) {
      quote = 0;
    }
  }
  if (quote == 0 || begin == 0 || before[begin - 1] != '(') return std::nullopt;
  const std::size_t name = name_begin(before, begin - 1);
  if (name == begin - 1) return std::nullopt;
  return ScriptCursor{ScriptCursor::Kind::object,
                      std::string(before.substr(name, begin - 1 - name)),
                      std::string(before.substr(begin + 1))};
}

// What the headers call the structure behind a path of scripts.
std::string structure_of(const std::string& path) {
  if (path == "data") return "mjData";
  if (path == "model") return "mjModel";
  if (path == "model.opt") return "mjOption";
  if (path == "model.stat") return "mjStatistic";
  constexpr std::string_view visual = "model.vis.";
  return path.starts_with(visual) ? "mjVisual." + path.substr(visual.size()) : "";
}

}  // namespace

std::optional<ScriptCursor> script_cursor(std::string_view before) {
  if (auto object = object_before(before)) return object;
  const std::size_t part = name_begin(before, before.size());
  const std::size_t joined = arrow(before, part);
  if (joined == 0) return std::nullopt;
  const std::string path = path_before(before, part - joined);
  if (path.empty()) return std::nullopt;
  return ScriptCursor{ScriptCursor::Kind::field, path, std::string(before.substr(part))};
}

std::optional<NamedField> field_at(std::string_view text, std::size_t offset) {
  std::size_t end = std::min(offset, text.size());
  while (end < text.size() && is_word_character(text[end])) ++end;
  const std::size_t begin = name_begin(text, end);
  const auto place = script_cursor(text.substr(0, end));
  if (begin == end || !place || place->kind != ScriptCursor::Kind::field) return std::nullopt;
  const std::string structure = structure_of(place->of);
  if (structure.empty()) return std::nullopt;
  return NamedField{structure + "." + place->part, begin, end};
}

}  // namespace mjcourse

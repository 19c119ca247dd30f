#include "lsp/outline.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lesson/front_matter.h"
#include "lsp/lesson_fences.h"

namespace mjcourse {
namespace {

using nlohmann::json;

// As the protocol numbers them.
enum class Symbol { function = 12, text = 15, object = 19 };

struct Entry {
  int level;  // of a heading; 0 for a block
  std::string name, detail;
  Symbol symbol;
  Span span, named;
};

// "Pendulum" of `"title": "Pendulum"`; "" where the JSON is not whole yet.
std::string text_in(const json& object, std::initializer_list<const char*> keys) {
  for (const char* key : keys) {
    if (object.is_object() && object.contains(key) && object[key].is_string()) return object[key];
  }
  return "";
}

// "examples/x.cpp" of `cpp file=examples/x.cpp optimize`.
std::string option(const std::string& info, const std::string& name) {
  const std::size_t at = info.find(" " + name + "=");
  if (at == info.npos) return "";
  const std::size_t begin = at + name.size() + 2;
  return info.substr(begin, info.find(' ', begin) - begin);
}

std::optional<Entry> entry_of(const SourceText& text, const LessonFence& fence) {
  const std::string kind = fence.kind();
  const Span whole{fence.opening.begin, fence.end};
  if (kind == "cpp") {
    const std::string file = option(fence.info, "file");
    if (file.empty()) return std::nullopt;
    return Entry{0, file, "program", Symbol::function, whole, fence.opening};
  }
  if (kind != "lab" && kind != "figure" && kind != "plot" && kind != "quiz") return std::nullopt;
  const json body = json::parse(unquoted(text, fence.body), nullptr, false);
  const std::string name = text_in(body, {"title", "alt", "id"});
  return Entry{0, name.empty() ? kind : name, kind, Symbol::object, whole, fence.opening};
}

// The `#` that begin a heading; 0 where the line is none.
int heading_level(std::string_view line) {
  const std::size_t level = std::min(line.find_first_not_of('#'), line.size());
  const bool is_heading = level > 0 && level <= 6 && level < line.size() && line[level] == ' ';
  return is_heading ? static_cast<int>(level) : 0;
}

// Where the lesson's text begins: a comment of the front matter is no heading.
int first_line(const SourceText& text) {
  Diagnostics published_elsewhere;
  Reading reading(text, published_elsewhere);
  const std::optional<Span> front = find_front_matter(reading);
  return front ? text.position(front->end).line + 1 : 1;
}

std::vector<Entry> entries_of(const SourceText& text) {
  std::vector<Entry> entries;
  const std::vector<LessonFence> fences = fences_of(text);
  for (const LessonFence& fence : fences) {
    if (auto entry = entry_of(text, fence)) entries.push_back(*std::move(entry));
  }
  for (int number = first_line(text); number <= text.line_count(); ++number) {
    const std::string_view line = text.line(number);
    const Span span{text.line_start(number), text.line_start(number) + line.size()};
    const int level = heading_level(line);
    if (level == 0 || fence_at(fences, span.begin) != nullptr) continue;
    entries.push_back({level, std::string(line.substr(static_cast<std::size_t>(level) + 1)), "",
                       Symbol::text, span, span});
  }
  std::ranges::stable_sort(entries, {}, [](const Entry& one) { return one.span.begin; });
  return entries;
}

class Tree {
 public:
  Tree(const SourceText& text, std::vector<Entry> entries, Units units)
      : text_(text), entries_(std::move(entries)), units_(units) {}

  // Those below a heading of `level`, up to the next that is no deeper.
  json below(int level) {
    json all = json::array();
    while (next_ < entries_.size()) {
      Entry& entry = entries_[next_];
      if (entry.level != 0 && entry.level <= level) break;
      ++next_;
      json children = entry.level == 0 ? json::array() : below(entry.level);
      if (entry.level != 0) {
        entry.span.end = next_ < entries_.size() ? entries_[next_].span.begin : text_.text().size();
      }
      all.push_back(symbol(entry, std::move(children)));
    }
    return all;
  }

 private:
  json symbol(const Entry& entry, json children) const {
    return {{"name", entry.name.empty() ? "…" : entry.name},  // it may not be empty
            {"detail", entry.detail},
            {"kind", static_cast<int>(entry.symbol)},
            {"range", json_of(range_of(text_, entry.span, units_))},
            {"selectionRange", json_of(range_of(text_, entry.named, units_))},
            {"children", std::move(children)}};
  }

  const SourceText& text_;
  std::vector<Entry> entries_;
  Units units_;
  std::size_t next_ = 0;
};

}  // namespace

json outline_of(const SourceText& text, Units units) {
  return Tree(text, entries_of(text), units).below(0);
}

}  // namespace mjcourse

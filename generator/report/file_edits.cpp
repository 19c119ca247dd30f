#include "report/file_edits.h"

#include <algorithm>
#include <string_view>
#include <tuple>
#include <utility>

namespace mjcourse {
namespace {

using Wanted = std::vector<const Diagnostic*>;

Span span_of(const Edit& edit, std::size_t size) {
  return edit.span.value_or(Span{0, size});
}

// From the first to the last; the same edit, wanted twice, is one.
std::vector<const Edit*> in_order(const Wanted& wanted, std::size_t size) {
  std::vector<const Edit*> edits;
  for (const Diagnostic* diagnostic : wanted) edits.push_back(&*diagnostic->edit);
  const auto key = [&](const Edit* edit) {
    const Span span = span_of(*edit, size);
    return std::tuple(span.begin, span.end, std::string_view(edit->text));
  };
  std::stable_sort(edits.begin(), edits.end(),
                   [&](const Edit* a, const Edit* b) { return key(a) < key(b); });
  edits.erase(std::unique(edits.begin(), edits.end(),
                          [&](const Edit* a, const Edit* b) { return key(a) == key(b); }),
              edits.end());
  return edits;
}

// Nothing where two edits want the same bytes.
std::optional<std::string> edited(const std::vector<const Edit*>& edits, std::string text) {
  const std::size_t size = text.size();
  for (std::size_t i = edits.size(); i-- > 0;) {
    const Span span = span_of(*edits[i], size);
    const bool fits = span.begin <= span.end && span.end <= size;
    const bool overlaps = i > 0 && (span_of(*edits[i - 1], size).end > span.begin ||
                                    span_of(*edits[i - 1], size).begin == span.begin);
    if (!fits || overlaps) return std::nullopt;
    text.replace(span.begin, span.end - span.begin, edits[i]->text);
  }
  return text;
}

}  // namespace

std::string changed_meanwhile(const std::string& file) {
  return file + " was changed while the course was evaluated: accept again";
}

FileEdits gather_edits(const Wanted& wanted, const Files& files) {
  std::vector<std::pair<std::string, Wanted>> by_file;
  for (const Diagnostic* diagnostic : wanted) {
    const std::string& file = diagnostic->edit->file;
    auto found = std::find_if(by_file.begin(), by_file.end(),
                              [&](const auto& known) { return known.first == file; });
    if (found == by_file.end()) found = by_file.insert(found, {file, {}});
    found->second.push_back(diagnostic);
  }
  FileEdits gathered;
  for (const auto& entry : by_file) {  // named here, since lambdas below use them
    const std::string& file = entry.first;
    const Wanted& cures = entry.second;
    const auto now = files.read(file);
    const std::optional<std::string> before = now ? std::optional(*now) : std::nullopt;
    const auto refuse = [&](const std::string& why) {
      for (const Diagnostic* cure : cures) gathered.refused.push_back({cure, why});
    };
    const bool stale = std::any_of(cures.begin(), cures.end(), [&](const Diagnostic* cure) {
      return cure->edit->before && cure->edit->before != before;
    });
    if (stale) {
      refuse(changed_meanwhile(file));
      continue;
    }
    const std::string text = before.value_or("");
    if (auto after = edited(in_order(cures, text.size()), text)) {
      gathered.files.push_back({file, before, *std::move(after), cures});
    } else {
      refuse("several fences want different text in " + file + ": make them say the same first");
    }
  }
  return gathered;
}

}  // namespace mjcourse

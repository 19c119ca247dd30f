#include "lsp/lesson_fences.h"

#include <algorithm>
#include <string_view>

namespace mjcourse {
namespace {

constexpr std::size_t kFewestMarks = 3;

// A line that may begin or end a fence.
struct Marks {
  std::size_t begin = 0;  // in the line
  char mark = '`';
  std::size_t count = 0;
  std::string_view info;
};

Marks marks_of(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(" \t>");
  if (begin == line.npos || (line[begin] != '`' && line[begin] != '~')) return {};
  const std::size_t end = std::min(line.find_first_not_of(line[begin], begin), line.size());
  std::string_view info = line.substr(end);
  info.remove_prefix(std::min(info.find_first_not_of(" \t"), info.size()));
  // Three backticks in one line may be code.
  if (line[begin] == '`' && info.find('`') != info.npos) return {};
  return {begin, line[begin], end - begin, info};
}

struct Open {
  std::size_t fence;
  char mark;
  std::size_t count;
};

}  // namespace

std::string LessonFence::kind() const {
  return info.substr(0, info.find_first_of(" \t"));
}

std::vector<LessonFence> fences_of(const SourceText& text) {
  std::vector<LessonFence> fences;
  std::vector<Open> open;
  for (int number = 1; number <= text.line_count(); ++number) {
    const std::string_view line = text.line(number);
    const Marks marks = marks_of(line);
    if (marks.count < kFewestMarks) continue;
    const std::size_t start = text.line_start(number), end = start + line.size();
    const bool closes = !open.empty() && marks.mark == open.back().mark &&
                        marks.count >= open.back().count && marks.info.empty();
    if (closes) {
      LessonFence& fence = fences[open.back().fence];
      fence.body.end = start;
      fence.end = end;
      open.pop_back();
    } else if (open.empty() || fences[open.back().fence].kind() == "demo") {
      open.push_back({fences.size(), marks.mark, marks.count});
      fences.push_back({{start + marks.begin, end},
                        std::string(marks.info),
                        {text.line_start(number + 1), text.text().size()},
                        text.text().size()});
    }
  }
  return fences;
}

const LessonFence* fence_at(const std::vector<LessonFence>& fences, std::size_t offset) {
  const auto found = std::find_if(fences.rbegin(), fences.rend(),
                                  [&](const LessonFence& one) { return one.has(offset); });
  return found == fences.rend() ? nullptr : &*found;
}

std::string unquoted(const SourceText& text, Span span) {
  std::string plain;
  const std::string_view all = text.text().substr(span.begin, span.end - span.begin);
  for (std::size_t begin = 0; begin < all.size();) {
    const std::size_t end = std::min(all.find('\n', begin), all.size() - 1) + 1;
    std::string_view line = all.substr(begin, end - begin);
    const std::size_t marks = std::min(line.find_first_not_of(" \t>"), line.size());
    if (line.substr(0, marks).find('>') != line.npos) line.remove_prefix(marks);
    plain += line;
    begin = end;
  }
  return plain;
}

}  // namespace mjcourse

#include "cli/where.h"

#include <algorithm>
#include <charconv>
#include <memory>
#include <vector>

#include "base/nearest.h"
#include "base/text_lines.h"
#include "lesson/unloaded_lesson.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

bool names(const Lesson& lesson, const fs::path& root, const std::string& name) {
  const std::string& path = lesson.source->path();
  return name == lesson.number || name == lesson.slug ||
         fs::path(name).lexically_normal() == path ||
         fs::absolute(name).lexically_normal() == (root / path).lexically_normal();
}

std::string no_lesson_named(const Course& course, const std::string& name) {
  std::vector<std::string> known;
  for (const Lesson& lesson : course.lessons) {
    const bool by_path = name.find('/') != name.npos;
    const bool by_slug = name.find('-') != name.npos;
    known.push_back(by_path ? lesson.source->path() : by_slug ? lesson.slug : lesson.number);
  }
  return "there is no lesson " + name + "; " + suggest(name, known);
}

// The fence of `lesson`, reloaded as a whole, that has a part in line `where.line`.
void find_fence(const Lesson& lesson, Where& where) {
  const std::unique_ptr<cmark_iter, decltype(&cmark_iter_free)> walk(
      cmark_iter_new(lesson.document.get()), cmark_iter_free);
  where.first = where.last = where.line;
  while (cmark_iter_next(walk.get()) != CMARK_EVENT_DONE) {
    cmark_node* node = cmark_iter_get_node(walk.get());
    const int first = cmark_node_get_start_line(node), last = cmark_node_get_end_line(node);
    if (cmark_node_get_type(node) != CMARK_NODE_CODE_BLOCK) continue;
    if (where.line < first || where.line > last) continue;
    where.first = first;
    where.last = last;
  }
}

}  // namespace

bool Where::has(const Place& place) const {
  return place.file == lesson->source->path() &&
         (line == 0 || (first <= place.line && place.line <= last));
}

tl::expected<Where, std::string> find_place(const Course& course, const fs::path& root,
                                            const std::string& text) {
  const std::size_t colon = std::min(text.rfind(':'), text.size());
  const std::string name = text.substr(0, colon);
  const auto lesson = std::find_if(course.lessons.begin(), course.lessons.end(),
                                   [&](const Lesson& one) { return names(one, root, name); });
  if (lesson == course.lessons.end()) return tl::unexpected(no_lesson_named(course, name));
  Where where{&*lesson};
  if (colon == text.size()) return where;
  const char* end = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data() + colon + 1, end, where.line);
  if (failure != std::errc() || stop != end || where.line < 1) {
    return tl::unexpected(text + " names no line; write it as " + name + ":210");
  }
  const Lesson whole = reload(*lesson, DiskFiles(root));
  const std::size_t lines = lines_of(whole.source->text()).size();
  if (static_cast<std::size_t>(where.line) > lines) {
    return tl::unexpected(lesson->source->path() + " has only " + std::to_string(lines) + " lines");
  }
  find_fence(whole, where);
  return where;
}

}  // namespace mjcourse

#include "lsp/asked.h"

#include "lesson/read_glossary.h"
#include "lesson/read_lesson.h"

namespace mjcourse {

std::optional<Lesson> Asked::lesson() const {
  Diagnostics published_elsewhere;
  const std::string bytes(text->text());
  if (text->path() == kGlossaryPath) {
    auto glossary = read_glossary(bytes, published_elsewhere, course().typography);
    return glossary ? std::optional(std::move(glossary->page)) : std::nullopt;
  }
  return read_lesson(text->path(), bytes, published_elsewhere, course().typography);
}

std::string_view Asked::line_before() const {
  const std::string_view before = text->text().substr(0, offset);
  return before.substr(before.rfind('\n') + 1);
}

}  // namespace mjcourse

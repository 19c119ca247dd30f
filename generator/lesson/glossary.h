// Glossary: the terms of a course and what they mean, from content/glossary.md.
//
// The file is read like a lesson, so its formulas, values, links and terms are checked and written
// by the same code. But it has no number and belongs to no level, and each heading of it is a term.
#pragma once

#include <string>
#include <vector>

#include "lesson/blocks/lesson.h"

namespace mjcourse {

inline constexpr const char* kGlossaryPath = "content/glossary.md";

struct Glossary {
  struct Term {
    std::string name;     // as its heading has it, without markup
    std::string key;      // what uses are matched by (lesson/syntax/term_syntax.h)
    std::string id;       // on the glossary's page
    Document heading;     // its inlines
    Document definition;  // blocks
  };

  Lesson page;              // its document is what stands before the first term
  std::vector<Term> terms;  // in the file's order

  const Term* find(const std::string& key) const;
  std::vector<std::string> names() const;
};

}  // namespace mjcourse

// Enter the lesson language here: from a file's bytes to a Lesson.
//
// Steps: the bytes must be UTF-8; the front matter is YAML; the rest is parsed by cmark-gfm with
// math; a walk over its tree finds the blocks. Nothing here knows MuJoCo or HTML.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "lesson/blocks/lesson.h"
#include "report/diagnostic.h"

namespace mjcourse {

// Read the lesson `path` ("content/1-state/1.2-generalized-coordinates.md"), whose bytes are
// `bytes`. Mistakes go to `diagnostics`; nothing is returned only when the file cannot be read at
// all (not UTF-8, no front matter, a file name without a number).
std::optional<Lesson> read_lesson(const std::string& path, std::string bytes,
                                  Diagnostics& diagnostics, const Typography& typography = {});

// The file's text; null (reported) when it is not UTF-8.
std::shared_ptr<const SourceText> read_source(const std::string& path, std::string bytes,
                                              Diagnostics& diagnostics);

// The text for cmark: the front matter becomes blank lines, so that line numbers stay.
std::string without_front_matter(const SourceText& source, Span front);

}  // namespace mjcourse

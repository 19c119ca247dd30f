// Pictures of a lesson: `![what it shows](file.png "where it comes from")`.
#pragma once

#include <cstddef>
#include <optional>

#include "lesson/blocks/block.h"
#include "lesson/syntax/located_text.h"
#include "lesson/syntax/reading.h"

namespace mjcourse {

// `alone`: it is a whole paragraph of the lesson's own text. Nothing (reported) where no page could
// show it.
std::optional<Image> read_image(cmark_node* node, const LocatedText& file, bool alone,
                                Reading& reading);

// In a node of text, which begins at or behind `from` in `text`: names that Markdown does not take
// for a picture's, and shows as they are written.
void refuse_blank_in_name(cmark_node* node, const LocatedText& text, std::size_t from,
                          Reading& reading);

}  // namespace mjcourse

// What cmark loses of a text without a word (loss.h), told at its place.
// Tested by tests/courses/text.
#pragma once

#include <string>

#include "lesson/syntax/located_text.h"
#include "lesson/syntax/loss.h"
#include "lesson/syntax/reading.h"

namespace mjcourse {

void tell_losses(const Losses& losses, const LocatedText& text, Reading& reading);

// At its mark in `span`.
void refuse_second_footnote(const std::string& name, Span span, Reading& reading);

}  // namespace mjcourse

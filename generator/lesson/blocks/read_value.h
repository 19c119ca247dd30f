// Inline values: code spans that begin with a name in braces.
//
// `{joint_zoo} model.nq` is one, `{x}` alone and `{1, 2}` are code. What is nearly one, as
// `{joint_zoo}model.nq`, is an error and not code: a reader would see it in the page, and its
// author might not. Code that must look like that is written `<code>…</code>`.
#pragma once

#include <optional>
#include <string_view>

#include "lesson/blocks/block.h"
#include "lesson/syntax/reading.h"

namespace mjcourse {

// Whether a code span is for read_value, or plain code.
bool is_value(std::string_view code);

// Nothing (reported) when the form is wrong.
std::optional<InlineValue> read_value(const LocatedText& code, Reading& reading);

}  // namespace mjcourse

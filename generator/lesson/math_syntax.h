// Math for cmark-gfm: `$…$`, `$$…$$` in a line, and `$$` blocks, through its extension API.
//
// Pandoc's rule tells math from money: the opening dollar is followed by no space, the closing one
// follows no space and no digit follows it. So `$5 and $6` is text.
#pragma once

#include <cmark-gfm-extension_api.h>

namespace mjcourse {

// The one extension object, made at first use and kept for the life of the program.
cmark_syntax_extension* math_syntax();

}  // namespace mjcourse

// Math for cmark-gfm: `$…$`, `$$…$$` in a line, and `$$` blocks, through its extension API.
//
// Pandoc's rule tells math from money: no space follows the opening dollar; the next dollar closes,
// and follows no space and has no digit behind it, or the first one is text. So `$5 and $6` is.
#pragma once

#include <cmark-gfm-extension_api.h>

namespace mjcourse {

// The one extension object, made at first use, when the table's is registered, and kept for the
// life of the program.
cmark_syntax_extension* math_syntax();

}  // namespace mjcourse

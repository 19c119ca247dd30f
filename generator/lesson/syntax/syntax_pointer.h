// Owns an extension of cmark's that one parser has.
#pragma once

#include <cmark-gfm-extension_api.h>

#include <memory>

namespace mjcourse {

struct FreeSyntax {
  void operator()(cmark_syntax_extension* syntax) const {
    cmark_syntax_extension_free(cmark_get_default_mem_allocator(), syntax);
  }
};

using SyntaxPointer = std::unique_ptr<cmark_syntax_extension, FreeSyntax>;

}  // namespace mjcourse

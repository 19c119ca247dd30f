// The tokens of a C++ text, as clang's own lexer has them before the preprocessor does anything.
//
// What a text means is for its compiler to say: where a comment ends, whether a quote opens a
// string. So the compiler is asked (-dump-raw-tokens), as confined as it is where it compiles.
// Tested by tests/generator/toolchain/raw_tokens_test.cpp.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "toolchain/toolchain.h"

namespace mjcourse {

// Together, the tokens of a text are all of it.
struct RawToken {
  std::string kind;        // clang's: "raw_identifier", "comment", "hash", "unknown" of blanks …
  std::size_t begin, end;  // in the text

  std::string_view in(std::string_view text) const { return text.substr(begin, end - begin); }
};

using RawTokens = std::vector<RawToken>;

// Of each of `texts`, in their order: all are read in one go. A text has no carriage returns, and
// ends with a line feed. In words, why there is no answer: a toolchain may be none of clang's, and
// a lexer crash.
tl::expected<std::vector<RawTokens>, std::string> raw_tokens(const std::vector<std::string>& texts,
                                                             const Toolchain& toolchain);

}  // namespace mjcourse

// Text that runs on in one line, whatever lines it had.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace mjcourse {

// `text` with each stretch of blanks as one, and none at its ends.
std::string with_single_blanks(std::string_view text);

// At most so many bytes of `text`, which is UTF-8, up to the end of a word; where there is no
// blank, of a letter.
std::string beginning_of(const std::string& text, std::size_t most);

}  // namespace mjcourse

// Messages: how an editor and a language server talk, each message behind a header that says how
// many bytes it has.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>

namespace mjcourse {

// What a message may have; who sends more is no editor.
inline constexpr std::size_t kLongestMessage = std::size_t{64} << 20;

// The next message's body; nothing at the end, or where it cannot be known any more where a message
// begins. A header that names no length is passed over.
std::optional<std::string> read_message(std::istream& in);

// Written out at once, for who waits on the other side.
void write_message(std::ostream& out, const std::string& body);

}  // namespace mjcourse

// Messages: how an editor and a language server talk, each message behind a header that says how
// many bytes it has.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace mjcourse {

// What a message may have; what sends more is no editor.
inline constexpr std::size_t kLongestMessage = std::size_t{64} << 20;

// The next message's body; nothing at the end, or where it cannot be known any more where a message
// begins. A header that names no length is passed over.
std::optional<std::string> read_message(std::istream& in);

// Copying and writing JSON recurse into it, so a message nests no deeper than any editor's.
inline constexpr int kDeepestMessage = 500;

// A message's JSON; a discarded value where it is none, or nests too deep.
nlohmann::json parse_message(const std::string& body);

// Written out at once, for the editor that waits on the other side.
void write_message(std::ostream& out, const std::string& body);

}  // namespace mjcourse

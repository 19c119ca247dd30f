#include "lesson/is_utf8.h"

#include <string_view>
#include <utility>

#include "base/utf8.h"
#include "lesson/reading.h"

namespace mjcourse {

bool is_utf8(const std::string& path, const std::string& bytes, Diagnostics& diagnostics) {
  const std::optional<std::size_t> first = find_invalid_utf8(bytes);
  if (!first) return true;
  constexpr std::string_view hex = "0123456789ABCDEF";
  const auto byte = static_cast<unsigned char>(bytes[*first]);
  const std::string code{hex[byte >> 4], hex[byte & 15]};
  // The excerpt is to be UTF-8.
  std::string readable = bytes;
  for (std::optional<std::size_t> bad = first; bad; bad = find_invalid_utf8(readable)) {
    readable.replace(*bad, 1, "\uFFFD");
  }
  const SourceText source(path, std::move(readable));
  Reading(source, diagnostics)
      .error("E-not-utf8", {*first, *first + 3}, "byte 0x" + code + " is not UTF-8",
             "save the file as UTF-8");
  return false;
}

}  // namespace mjcourse

#include "lesson/syntax/picture_name.h"

#include <re2/re2.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "base/percent_encoding.h"
#include "base/utf8.h"

namespace mjcourse {
namespace {

// The byte that the escape at `at` stands for; nothing where there is none, or where no name has
// such a byte.
std::optional<char> escaped_byte(std::string_view text, std::size_t at) {
  const std::optional<char> byte = encoded_byte(text, at);
  const auto number = static_cast<unsigned char>(byte.value_or('\0'));
  return number < 0x20 || number == 0x7F ? std::nullopt : byte;
}

}  // namespace

LocatedText file_of_target(const LocatedText& target) {
  LocatedText file;
  for (std::size_t at = 0; at < target.text.size();) {
    const std::optional<char> byte = escaped_byte(target.text, at);
    file.text += byte.value_or(target.text[at]);
    file.offsets.push_back(target.span(at, at).begin);
    at += byte ? kEncodedByte : 1;
  }
  if (find_invalid_utf8(file.text)) return target;
  file.offsets.push_back(target.span().end);
  return file;
}

std::string target_of_file(const std::string& file) {
  std::string target;
  for (std::size_t at = 0; at < file.size(); ++at) {
    target += escaped_byte(file, at) ? "%25" : std::string(1, file[at]);
  }
  return target.find_first_of(" ()") == target.npos ? target : "<" + target + ">";
}

std::vector<LocatedText> names_with_blanks(const LocatedText& text, std::size_t at) {
  static const RE2 form(
      R"re((?i)(^|[^\\])\]\(([^()<>\n"]*[^()<>\n" \t][ \t][^()<>\n"]*\.(?:png|jpe?g|webp|svg))(?:[ \t][^()\n]*)?\))re");
  const std::size_t end = std::min(text.text.find("\n\n", at), text.text.size());
  // Few texts have this, and the expression takes a fifteenth of reading a course of prose.
  if (text.text.find("](", at) >= end) return {};
  re2::StringPiece rest(text.text.data() + at, end - at);
  std::vector<LocatedText> names;
  for (re2::StringPiece before, name; RE2::FindAndConsume(&rest, form, &before, &name);) {
    const auto begin = static_cast<std::size_t>(name.data() - text.text.data());
    names.push_back(text.part(begin, begin + name.size()));
  }
  return names;
}

}  // namespace mjcourse

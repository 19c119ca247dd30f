#include "course/lesson_name.h"

#include <re2/re2.h>

#include <algorithm>
#include <cctype>

namespace mjcourse {

std::optional<LessonName> read_lesson_name(const std::string& name) {
  static const RE2 form(R"((?s)(\d+|[A-Z])\.(\d{1,6})-([^/]+))", RE2::Latin1);
  LessonName read;
  if (!RE2::FullMatch(name, form, &read.level, &read.place, &read.slug)) return std::nullopt;
  return read;
}

std::string slug_of(const std::string& title) {
  std::string slug;
  for (const char c : title) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80) return "";
    if (std::isalnum(byte) != 0) {
      slug += static_cast<char>(std::tolower(byte));
    } else if (c != '\'' && !slug.empty() && slug.back() != '-') {
      slug += '-';  // "Newton's" is one word
    }
  }
  if (slug.ends_with('-')) slug.pop_back();
  return slug;
}

std::string title_of(const std::string& slug) {
  std::string title = slug;
  std::replace(title.begin(), title.end(), '-', ' ');
  if (!title.empty()) {
    title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  }
  return title;
}

}  // namespace mjcourse

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
  static const RE2 apostrophe("['\u2019]"), between(R"([^\p{L}\p{M}\p{N}]+)"),
      english("[A-Za-z0-9-]*");
  std::string slug = title;
  RE2::GlobalReplace(&slug, apostrophe, "");  // "Newton's" is one word
  RE2::GlobalReplace(&slug, between, "-");
  if (slug.starts_with('-')) slug.erase(0, 1);
  if (slug.ends_with('-')) slug.pop_back();
  if (!RE2::FullMatch(slug, english)) return "";
  for (char& c : slug) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
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

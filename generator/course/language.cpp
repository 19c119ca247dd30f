#include "course/language.h"

#include <re2/re2.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "base/utf8.h"

namespace mjcourse {
namespace {

// RFC 5646, 2.1, without languages of four letters or more, as none is registered.
bool has_form(const std::string& tag) {
  static const RE2 form(
      "(?i)[a-z]{2,3}(-[a-z]{3}){0,3}"        // de, zh-yue
      "(-[a-z]{4})?(-([a-z]{2}|[0-9]{3}))?"   // zh-Hans, en-GB, es-419
      "(-([a-z0-9]{5,8}|[0-9][a-z0-9]{3}))*"  // ca-valencia, de-1996
      "(-[a-wyz0-9](-[a-z0-9]{2,8})+)*"       // en-u-co-phonebk
      "(-x(-[a-z0-9]{1,8})+)?");
  return RE2::FullMatch(tag, form);
}

bool is_listed(const std::string& name, const auto& names) {
  return std::ranges::find(names, name) != names.end();
}

constexpr std::array<std::string_view, 16> kFromRight{"ar", "arc", "ckb", "dv", "fa", "glk",
                                                      "he", "lrc", "mzn", "ps", "sd", "syr",
                                                      "ug", "ur",  "yi",  "nqo"};
constexpr std::array<std::string_view, 9> kScriptsFromRight{"adlm", "arab", "hebr", "mand", "nkoo",
                                                            "rohg", "samr", "syrc", "thaa"};

}  // namespace

LanguageParts parts_of_language(const std::string& tag) {
  static const RE2 form(
      "([a-z]{2,3})(?:-[a-z]{3}){0,3}(?:-([a-z]{4}))?(?:-([a-z]{2}|[0-9]{3}))?(?:-.*)?");
  LanguageParts parts;
  RE2::FullMatch(lower_case_utf8(tag), form, &parts.language, &parts.script, &parts.region);
  return parts;
}

std::optional<std::string> cure_of_language(const std::string& tag) {
  if (has_form(tag)) return std::nullopt;
  std::string mended = tag;
  std::ranges::replace(mended, '_', '-');
  mended = mended.substr(0, mended.find('.'));  // de_DE.UTF-8
  if (mended != tag && has_form(mended)) return "did you mean `" + mended + "`?";
  return "write a tag of BCP 47, as `de`, `en-GB` or `zh-Hans`";
}

bool is_right_to_left(const std::string& tag) {
  const LanguageParts parts = parts_of_language(tag);
  return parts.script.empty() ? is_listed(parts.language, kFromRight)
                              : is_listed(parts.script, kScriptsFromRight);
}

}  // namespace mjcourse

#include "script/page_function.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "base/utf8.h"

namespace mjcourse {
namespace {

// Part of a JavaScript name; what is not ASCII may be one.
bool is_name_part(char c) {
  return is_word_character(c) || c == '$' || static_cast<unsigned char>(c) >= 0x80;
}

// All words of `text` but the members that follow a dot: not the `qvel` of `data.qvel`.
std::set<std::string> words_of(const std::string& text) {
  std::set<std::string> words;
  for (auto at = text.begin(); at != text.end();) {
    const auto begin = std::find_if(at, text.end(), is_name_part);
    at = std::find_if_not(begin, text.end(), is_name_part);
    const std::string_view before(text.begin(), begin);
    const bool is_member = before.ends_with('.') && !before.ends_with("...");
    if (begin != at && !is_member) words.emplace(begin, at);
  }
  return words;
}

// "({ data, Math }) => {": a word that is no name there, say in a comment, does no harm.
std::string head(const std::string& text, const std::vector<std::string>& names,
                 const std::string& more = "") {
  const std::set<std::string> words = words_of(text);
  std::string taken;
  const auto take = [&](const std::string& name) { taken += (taken.empty() ? "" : ", ") + name; };
  for (const std::string& name : names) {
    if (words.contains(name)) take(name);
  }
  if (!more.empty()) take(more);
  return taken.empty() ? "() => {" : "({ " + taken + " }) => {";
}

}  // namespace

std::string page_script(const std::string& script, const std::vector<std::string>& names) {
  return head(script, names) + " {\n" + script + "\n} }";
}

std::string page_expression(const std::string& expression, const std::vector<std::string>& names) {
  return head(expression, names) + " return (\n" + expression + "\n); }";
}

std::string page_assignment(const std::string& target, const std::vector<std::string>& names) {
  return head(target, names, "value") + " (\n" + target + "\n) = value; }";
}

}  // namespace mjcourse

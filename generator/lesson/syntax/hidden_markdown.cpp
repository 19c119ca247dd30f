#include "lesson/syntax/hidden_markdown.h"

#include <re2/re2.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <utility>

#include "base/utf8.h"
#include "lesson/syntax/html_tags.h"
#include "lesson/syntax/inline_length.h"

namespace mjcourse {
namespace {

// What begins a block of Markdown at a line's start.
std::optional<HiddenMarkdown> block_at(std::string_view line, std::size_t at) {
  struct Form {
    RE2 form;
    const char* what;
  };
  static const std::array<Form, 6> forms{{
      {RE2(R"([ \t]*(`{3,}|~{3,}))"), "a fence"},
      {RE2(R"([ \t]*(\$\$))"), "a formula"},
      {RE2(R"([ \t]*(#{1,6}) )"), "a heading"},
      {RE2(R"([ \t]*(> ?\[!))"), "a callout"},
      {RE2(R"([ \t]*([-*+]|\d+[.)]) +\S)"), "a list"},
      {RE2(R"([ \t]*(\|?[ \t]*:?-+:?[ \t]*(?:\|[ \t]*:?-+:?[ \t]*)+\|?)[ \t]*$)"), "a table"},
  }};
  for (const Form& form : forms) {
    re2::StringPiece rest(line.data(), line.size()), mark;
    if (!RE2::Consume(&rest, form.form, &mark)) continue;
    const std::size_t begin = at + static_cast<std::size_t>(mark.data() - line.data());
    return HiddenMarkdown{begin, begin + mark.size(), form.what};
  }
  return std::nullopt;
}

struct InlineForm {
  RE2 form;
  const char* what;
};

template <std::size_t N>
std::optional<HiddenMarkdown> one_of(const std::array<InlineForm, N>& forms, std::string_view rest,
                                     std::size_t at) {
  const re2::StringPiece piece(rest.data(), rest.size());
  for (const InlineForm& form : forms) {
    re2::StringPiece behind = piece, mark;
    if (!RE2::Consume(&behind, form.form, &mark)) continue;
    return HiddenMarkdown{at, at + mark.size(), form.what};
  }
  return std::nullopt;
}

// What begins with the bracket `rest` begins with, at byte `at`.
std::optional<HiddenMarkdown> bracket_at(std::string_view rest, std::size_t at) {
  static const std::array<InlineForm, 3> forms{{
      {RE2(R"((\[\[[\pL`][^\[\]\n]*\]\]))"), "a term"},
      {RE2(R"((\[[^\[\]\n]+\]\([^()\s]+\)))"), "a link"},
      {RE2(R"((\[\^[^\[\]\s]+\]))"), "a footnote's mark"},
  }};
  return one_of(forms, rest, at);
}

// Of words within a line, where none goes on before and behind: `2*3*4` has none.
std::optional<HiddenMarkdown> emphasis_at(std::string_view rest, std::size_t at) {
  if (rest[0] != '*' && rest[0] != '_' && rest[0] != '~') return std::nullopt;
  static const std::array<InlineForm, 5> forms{{
      {RE2(R"((\*\*[^\s*](?:[^*\n]*[^\s*])?\*\*)(?:[^\w*]|$))"), "emphasis"},
      {RE2(R"((\*[^\s*](?:[^*\n]*[^\s*])?\*)(?:[^\w*]|$))"), "emphasis"},
      {RE2(R"((__[^\s_](?:[^\n]*?[^\s_])?__)(?:\W|$))"), "emphasis"},
      {RE2(R"((_[^\s_](?:[^\n]*?[^\s_])?_)(?:\W|$))"), "emphasis"},
      {RE2(R"((~~[^\s~](?:[^~\n]*[^\s~])?~~))"), "text struck out"},
  }};
  return one_of(forms, rest, at);
}

// What begins at byte `at` of a text.
std::optional<HiddenMarkdown> inline_at(std::string_view text, std::size_t at, CodeLengths& codes) {
  const std::string_view rest = text.substr(at);
  if (rest[0] == '$') {
    if (const std::size_t length = math_length(rest)) {
      return HiddenMarkdown{at, at + length, "a formula"};
    }
  }
  if (rest[0] == '`') {
    if (const std::size_t length = codes.at(rest)) {
      return HiddenMarkdown{at, at + length, "a piece of code"};
    }
  }
  if (rest[0] == '[') return bracket_at(rest, at);
  if (at > 0 && is_word_character(text[at - 1])) return std::nullopt;
  return emphasis_at(rest, at);
}

class HiddenFinder {
 public:
  explicit HiddenFinder(std::string_view html) : html_(html) {}

  // Look from `begin` to `end`.
  void look(std::size_t begin, std::size_t end) {
    text_ = html_.substr(0, end);
    codes_ = {};
    bool at_line_start = begin == 0 || html_[begin - 1] == '\n';
    for (std::size_t at = begin; at < end;) {
      const std::size_t before = at;
      if (at_line_start) at = behind_block(at);
      if (at == before) at = behind_inline(at);
      at_line_start = text_[std::min(at, end) - 1] == '\n';
    }
  }

  std::vector<HiddenMarkdown> found() && { return std::move(found_); }

 private:
  // Where what begins a block at `at` ends; `at` where nothing does.
  std::size_t behind_block(std::size_t at) {
    const std::size_t line_end = std::min(text_.find('\n', at), text_.size());
    const auto block = block_at(text_.substr(at, line_end - at), at);
    if (!block) return at;
    const std::string_view mark = text_.substr(block->begin, block->end - block->begin);
    const bool is_list = std::string_view(block->what) == "a list";
    if (!is_list || !std::exchange(has_list_, true)) found_.push_back(*block);
    if (mark[0] != '`' && mark[0] != '~' && mark[0] != '$') return block->end;
    const std::size_t close = text_.find(mark, block->end);  // nothing within is read
    return close == text_.npos ? text_.size() : close + mark.size();
  }

  std::size_t behind_inline(std::size_t at) {
    if (text_[at] == '\\') return std::min(at + 2, text_.size());
    if (const auto one = inline_at(text_, at, codes_)) {
      found_.push_back(*one);
      return one->end;
    }
    return at + (text_[at] == '`' ? backticks(text_.substr(at)) : 1);
  }

  std::string_view html_, text_;
  CodeLengths codes_;  // of `text_`
  bool has_list_ = false;
  std::vector<HiddenMarkdown> found_;
};

bool holds_code(std::string_view name) {
  return name == "code" || name == "pre" || name == "kbd" || name == "samp";
}

}  // namespace

std::vector<HiddenMarkdown> hidden_markdown(std::string_view html) {
  HiddenFinder finder(html);
  std::size_t at = 0;
  int in_code = 0;
  for (const HtmlTag& tag : tags_of_html(html)) {
    if (in_code == 0) finder.look(at, tag.begin);
    if (holds_code(tag.name)) in_code = std::max(0, in_code + (tag.closes ? -1 : 1));
    at = tag.end;
  }
  if (in_code == 0) finder.look(at, html.size());
  return std::move(finder).found();
}

}  // namespace mjcourse

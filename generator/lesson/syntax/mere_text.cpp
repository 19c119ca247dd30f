#include "lesson/syntax/mere_text.h"

#include <re2/re2.h>

#include <algorithm>

#include "base/text_lines.h"
#include "base/utf8.h"
#include "lesson/syntax/inline_length.h"
#include "lesson/syntax/picture_name.h"

namespace mjcourse {
namespace {

constexpr std::size_t kMostRead = 100'000'000;  // in bytes, of what is shown
constexpr std::size_t kLongestLabel = 1000;     // in bytes, as CommonMark has it
constexpr std::size_t kLongestAddress = 4000;
constexpr std::size_t kLongestTex = 10'000;
constexpr std::size_t kLongestComment = 10'000;
constexpr char kBlank = '\x01';

// Of the comment that begins a text, as Markdown has one within a line; 0 where it has none.
std::size_t comment_length(std::string_view text) {
  const std::size_t end = text.substr(0, kLongestComment).find("--", 4);
  const bool is_one = end != text.npos && text.substr(end).starts_with("-->") && text[4] != '>' &&
                      text.substr(4, 2) != "->";
  return is_one ? end + 3 : 0;
}

// `source` with `\x01` for each byte of code, formulas, tags and, but for their backslash, escapes.
std::string without_literals(std::string_view source) {
  std::string text(source);
  CodeLengths codes;
  bool has_tags = true;
  std::size_t length = 1;
  for (std::size_t at = 0; at < source.size(); at += length) {
    const std::string_view rest = source.substr(at);
    length = 1;
    std::size_t blanks = 0;
    if (rest[0] == '\\' && rest.size() > 1) {
      length = 2;
    } else if (rest[0] == '`') {
      blanks = codes.at(rest);
      length = std::max(blanks, backticks(rest));
    } else if (rest[0] == '$') {
      blanks = math_length(rest);
      length = std::max<std::size_t>(blanks, 1);
    } else if (rest.starts_with("<!--")) {
      blanks = comment_length(rest);
      length = std::max<std::size_t>(blanks, 1);
    } else if (rest[0] == '<' && has_tags && rest.size() > 1 && rest[1] != ' ') {
      const std::size_t end = rest.find('>');
      has_tags = end != rest.npos;
      if (has_tags) blanks = length = end + 1;
    }
    text.replace(at, blanks, blanks, kBlank);
  }
  return text;
}

bool has_letter(std::string_view text) {
  return std::any_of(text.begin(), text.end(),
                     [](char c) { return is_letter(c) || static_cast<unsigned char>(c) >= 0x80; });
}

// Quotes, dashes and dots, of which typed ones are others in the page, are left out.
std::string without_marks(std::string_view text) {
  static const RE2 marks("[-\"'.\u2013\u2014\u2026\u202f“”„‘’‚«»‹›「」『』]+");
  std::string rest(text);
  RE2::GlobalReplace(&rest, marks, "");
  return rest;
}

class Finder {
 public:
  Finder(std::string_view source, std::string_view shown)
      : source_(source), shown_(without_marks(shown)), text_(without_literals(source)) {}

  std::vector<MereText> all() {
    for (std::size_t at = 0; at < text_.size(); ++at) {
      if (text_[at] == '\\') {
        look_at_escape(at);
        ++at;
      } else if (text_[at] == '[') {
        opened_.push_back(at);
        if (text_.compare(at, 2, "[^") == 0) look_at_footnote(at);
        if (at > 0 && text_[at - 1] == '^') look_at_inline_note(at);
      } else if (text_.compare(at, 4, "<!--") == 0) {
        look_at_comment(at);
      } else if (text_[at] == ']') {
        look_at_end(at);
        if (!opened_.empty()) opened_.pop_back();
      }
    }
    look_at_lines();
    return std::move(found_);
  }

 private:
  void tell(std::size_t begin, std::size_t end, const char* id, const std::string& message,
            const std::string& cure) {
    found_.push_back({begin, end, id, message, cure});
  }

  // Each looks through all of the text. The limit is beyond what a person writes in a paragraph.
  bool is_shown(std::string_view text) {
    read_ += shown_.size();
    return read_ < kMostRead && shown_.find(without_marks(text)) != shown_.npos;
  }

  // The next of `signs` behind `at`, if it is not far.
  std::size_t next(const char* signs, std::size_t at, std::size_t most) const {
    return std::string_view(text_).substr(0, at + most).find_first_of(signs, at);
  }

  // `\(x\)` and `\[y\]`, of which Markdown keeps the brackets alone.
  void look_at_escape(std::size_t at) {
    if (text_.compare(at, 7, "\\begin{") == 0) return look_at_environment(at);
    const bool inline_math = text_.compare(at, 2, "\\(") == 0;
    if (at < told_ || (!inline_math && text_.compare(at, 2, "\\[") != 0)) return;
    std::size_t& end = inline_math ? round_end_ : square_end_;
    if (end < at + 2) end = std::min(text_.find(inline_math ? "\\)" : "\\]", at + 2), text_.size());
    if (end == text_.size() || end - at > kLongestTex) return;
    const std::string tex(source_.substr(at + 2, end - at - 2));
    // Brackets as text need their backslash, round ones do not.
    static const RE2 math(R"((?s)^\s.*\s$|.[\^_=]|\\[A-Za-z])");
    if (!inline_math && !RE2::PartialMatch(tex, math)) return;
    const std::string dollars = inline_math ? "$" : "$$";
    const std::string written = tex.find('\n') == tex.npos ? std::string(trimmed(tex)) : "…";
    tell(at, at + 2, "W-math-brackets",
         "`" + text_.substr(at, 2) + "` begins no formula: it is a bracket",
         "write `" + dollars + written + dollars + "`");
    told_ = end + 2;
  }

  // `\begin{align}` without dollars around it.
  void look_at_environment(std::size_t at) {
    const std::size_t end = next("}\n", at, kLongestLabel);
    if (end == text_.npos || text_[end] != '}') return;
    const std::string begin = text_.substr(at, end + 1 - at);
    if (!is_shown(begin)) return;
    tell(at, end + 1, "W-math-brackets", "`" + begin + "` begins no formula: it is text",
         "put the formula between `$$` and `$$`, each on a line of its own");
  }

  // One with `--` in it, or without an end. In the page, two hyphens are a dash.
  void look_at_comment(std::size_t at) {
    if (!is_shown("<!\u2013") && !is_shown("<!--")) return;
    const std::size_t end = source_.substr(0, at + kLongestComment).find("-->", at + 4);
    if (end == source_.npos) {
      return tell(at, at + 4, "W-html-comment",
                  "this comment is never closed, and is shown as text",
                  "write `-->` where it ends; for the characters as text, write `\\<!--`");
    }
    tell(at, end + 3, "W-html-comment",
         "within a line, this is not a comment, and is shown as text: `--` stands in it",
         "leave out the `--`, or put the comment on a line of its own");
  }

  void look_at_footnote(std::size_t at) {
    const std::size_t end = next("]\n", at, kLongestLabel);
    if (end == text_.npos || text_[end] != ']' || end == at + 2) return;
    const std::string mark = text_.substr(at, end + 1 - at);
    std::string name = mark.substr(2, mark.size() - 3);
    const bool has_blank = name.find_first_of(" \t") != name.npos;
    if ((has_blank && !has_letter(name.substr(0, 1))) || !is_shown(mark)) return;
    if (has_blank) {
      std::ranges::replace(name, ' ', '-');
      return tell(at, end + 1, "W-footnote-unknown", "the name of a footnote has no spaces",
                  "write `[^" + name + "]`; for brackets as text, `\\" + mark + "`");
    }
    tell(at, end + 1, "W-footnote-unknown", "there is no footnote `" + name + "`",
         "define it on a line of its own, `" + mark + ": …`; for brackets as text, write `\\" +
             mark + "`");
  }

  // `^[a note]`, as Pandoc has them.
  void look_at_inline_note(std::size_t at) {
    const std::size_t end = next("]\n", at, kLongestLabel);
    if (end == text_.npos || text_.find(' ', at) > end) return;
    const std::string note = text_.substr(at - 1, end + 1 - (at - 1));
    if (!is_shown(note.substr(0, note.find_first_of("*_`\\$<&\x01", 2)))) return;
    tell(at - 1, end + 1, "W-footnote-unknown", "a footnote does not stand in the line",
         "write `[^name]` here, and `[^name]: …` on a line of its own");
  }

  // The bracket at `at` ends what may be the text of a link or a picture.
  void look_at_end(std::size_t at) {
    if (opened_.empty()) return;
    std::size_t begin = opened_.back();
    const bool picture = begin > 0 && text_[begin - 1] == '!';
    if (picture) --begin;
    // What stands behind a word is an index: `a[i][j]`.
    const bool index =
        begin > 0 && (is_word_character(text_[begin - 1]) || text_[begin - 1] == ')' ||
                      text_[begin - 1] == ']' || text_[begin - 1] == kBlank);
    if (index || at == opened_.back() + 1) return;
    if (text_.compare(at, 2, "](") == 0) {
      pass_address(at + 2);
      return look_at_address(begin, at);
    }
    if (text_.compare(at, 2, "][") == 0) return look_at_reference(begin, at);
    const std::string name = text_.substr(opened_.back() + 1, at - opened_.back() - 1);
    if (picture && name.size() <= kLongestLabel && has_letter(name) &&
        is_shown("![" + name + "]")) {
      tell_reference(begin, at + 1, name, true);
    }
  }

  void look_at_reference(std::size_t begin, std::size_t at) {
    const std::size_t end = next("]", at + 2, kLongestLabel);
    if (end == text_.npos) return;
    std::string name = text_.substr(at + 2, end - at - 2);
    if (!is_shown("][" + name + "]")) return;
    if (name.empty())
      name = text_.substr(opened_.back() + 1, std::min(at - opened_.back() - 1, kLongestLabel));
    if (has_letter(name)) tell_reference(begin, end + 1, name, text_[begin] == '!');
  }

  void tell_reference(std::size_t begin, std::size_t end, const std::string& name, bool picture) {
    const std::string address = picture ? "picture.png" : "https://…";
    tell(begin, end, "W-reference-unknown", "nothing defines the reference `" + name + "`",
         "define it on a line of its own, `[" + name + "]: " + address +
             "`, or write the address here, `" + (picture ? "!" : "") + "[…](" + address + ")`");
  }

  // Of a link, no bracket in it begins a formula.
  void pass_address(std::size_t at) {
    static const RE2 address(R"((?:[^\s()\\]|\\.|\([^\s()]*\))*[)\s])");
    re2::StringPiece rest(text_.data() + at, text_.size() - at);
    if (RE2::Consume(&rest, address)) told_ = text_.size() - rest.size();
  }

  void look_at_address(std::size_t begin, std::size_t at) {
    const std::size_t end = next(")\n", at, kLongestAddress);
    if (end == text_.npos || text_[end] != ')' || end == at + 2) return;
    const std::string address = text_.substr(at + 2, end - at - 2);
    if (!names_with_blanks({"](" + address + ")", {}}, 0).empty()) return;  // E-image-blank
    if (address.find(' ') == address.npos || !is_shown("](" + address)) return;
    tell(begin, end + 1, "W-link-blank", "this is not a link, since its address has a space",
         "put the address in `<…>`: `" + std::string(text_[begin] == '!' ? "!" : "") + "[…](<" +
             address + ">)`");
  }

  void look_at_lines() {
    look_at_headings();
    look_at_rows();
  }

  // `+---+---+`, `|===|===|` and, with the dashes of a word processor, `|––|––|`
  void look_at_rows() {
    static const RE2 form(
        "(?m)^[ >\\t]*(\\+(?:[-=]{2,}\\+)+|\\|(?:[ \\t]*:?(?:={2,}|[–—]+):?[ \\t]*\\|)+)[ "
        "\\t\\r]*$");
    re2::StringPiece rest(text_), row;
    if (!RE2::FindAndConsume(&rest, form, &row)) return;
    const std::string signs = row.as_string();
    if (!is_shown(signs.substr(0, signs.find_first_of("-=\xE2")))) return;
    const auto begin = static_cast<std::size_t>(row.data() - text_.data());
    tell(begin, begin + row.size(), "W-table-head",
         "this is not a table: its row of dashes has other signs",
         "write the rows as `| a | b |`, and `|---|---|` below the first");
  }

  // `##Heading`
  void look_at_headings() {
    for (std::size_t at = 0; at < text_.size();
         at = std::min(text_.find('\n', at), text_.size() - 1) + 1) {
      static const RE2 form(R"(((?:[ >\t]|[-*+][ \t]|\d{1,9}[.)][ \t])*)(#{2,6})([^#\s\x01]))");
      re2::StringPiece rest(text_.data() + at, text_.size() - at), before, marks, letter;
      if (!RE2::Consume(&rest, form, &before, &marks, &letter)) continue;
      const std::size_t begin = at + before.size();
      if (!is_shown(marks.as_string() + letter.as_string())) continue;
      tell(begin, begin + marks.size(), "W-heading-blank",
           "this is not a heading, since no space follows its `" + marks.as_string() + "`",
           "write `" + marks.as_string() + " " + letter.as_string() +
               "…`; for the signs as text, `\\" + marks.as_string() + "`");
    }
  }

  std::string_view source_;
  std::string shown_, text_;
  std::vector<std::size_t> opened_;  // the brackets that no other has closed
  std::size_t read_ = 0;
  std::size_t round_end_ = 0, square_end_ = 0;  // the next `\)` and `\]`
  std::size_t told_ = 0;  // how far a formula in brackets, or an address, reaches
  std::vector<MereText> found_;
};

}  // namespace

bool is_suspicious(std::string_view source) {
  for (const char* sign : {"\\(", "\\[", "[^", "^[", "](", "][", "![", "##", "<!--", "\\begin{",
                           "+--", "+==", "==", "–", "—"}) {
    if (source.find(sign) != source.npos) return true;
  }
  return false;
}

std::vector<MereText> mere_text(std::string_view source, std::string_view shown) {
  return Finder(source, shown).all();
}

}  // namespace mjcourse

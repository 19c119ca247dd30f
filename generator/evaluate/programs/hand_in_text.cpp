#include "evaluate/programs/hand_in_text.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "base/text_lines.h"
#include "base/utf8.h"

namespace mjcourse {
namespace {

// What a region has no use for: the checks, and what takes it out of its function. Names with two
// underscores in front (__asm__, __builtin_trap) are refused as a kind. To end the program wins
// nothing: what it then does not check, fails.
constexpr std::array<std::string_view, 7> kRefused{"expect", "expect_near", "expect_alike", "main",
                                                   "asm",    "extern",      "_Pragma"};

// Of macros of the standard library, as NULL, NAN and assert().
constexpr std::array<std::string_view, 25> kHarmless{"__null",
                                                     "__builtin_nan",
                                                     "__builtin_nanf",
                                                     "__builtin_nanl",
                                                     "__builtin_nans",
                                                     "__builtin_nansf",
                                                     "__builtin_nansl",
                                                     "__builtin_inf",
                                                     "__builtin_inff",
                                                     "__builtin_infl",
                                                     "__builtin_huge_val",
                                                     "__builtin_huge_valf",
                                                     "__builtin_huge_vall",
                                                     "__builtin_offsetof",
                                                     "__builtin_alloca",
                                                     "__builtin_va_start",
                                                     "__builtin_va_arg",
                                                     "__builtin_va_copy",
                                                     "__builtin_va_end",
                                                     "__assert_fail",
                                                     "__extension__",
                                                     "__PRETTY_FUNCTION__",
                                                     "__errno_location",
                                                     "__clock_t",
                                                     "__ctype_get_mb_cur_max"};

bool is_blank(std::string_view text) {
  return text.find_first_not_of(" \t\n") == text.npos;
}

bool is_code(const RawToken& token, std::string_view text) {
  return token.kind != "comment" && !(token.kind == "unknown" && is_blank(token.in(text)));
}

bool is_reserved(std::string_view word) {
  return word.starts_with("__") || word.starts_with("MJCOURSE");
}

// Those that are code, one after the other.
RawTokens code_of(const RawTokens& tokens, std::string_view text) {
  RawTokens code;
  std::ranges::copy_if(tokens, std::back_inserter(code),
                       [&](const RawToken& token) { return is_code(token, text); });
  return code;
}

// Is it the first of its line?
bool begins_line(const RawTokens& tokens, std::size_t index, std::string_view text) {
  for (std::size_t i = index; i-- > 0;) {
    const std::string_view before = tokens[i].in(text);
    if (is_code(tokens[i], text)) return false;
    if (tokens[i].kind != "comment" && before.find('\n') != before.npos) return true;
  }
  return true;
}

// The directives of a text, each with its place; blanks between the words are one.
std::vector<std::pair<std::string, Span>> directives_in(const std::string& text,
                                                        const RawTokens& tokens) {
  std::vector<std::pair<std::string, Span>> all;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].kind != "hash" || !begins_line(tokens, i, text)) continue;
    std::string words;
    std::size_t end = tokens[i].end;
    for (std::size_t k = i; k < tokens.size(); ++k) {
      const std::string_view word = tokens[k].in(text);
      if (is_code(tokens[k], text)) {
        words.append(words.empty() ? "" : " ").append(word);
        end = tokens[k].end;
      } else if (tokens[k].kind != "comment" && word.find('\n') != word.npos) {
        break;
      }
    }
    all.emplace_back(std::move(words), Span{tokens[i].begin, end});
  }
  return all;
}

// Does the preprocessor say by it where a line is from?
bool is_line_mark(std::string_view directive) {
  return directive.size() > 2 && is_digit(directive[2]);
}

int depth_change(const RawToken& token) {
  for (const char* kind : {"l_brace", "l_paren", "l_square"}) {
    if (token.kind == kind) return 1;
  }
  for (const char* kind : {"r_brace", "r_paren", "r_square"}) {
    if (token.kind == kind) return -1;
  }
  return 0;
}

// The first bracket that closes none of the text's own, or opens what it does not close.
std::optional<Span> open_bracket(const RawTokens& code) {
  std::vector<Span> open;
  for (const RawToken& token : code) {
    const int change = depth_change(token);
    if (change > 0) open.push_back({token.begin, token.end});
    if (change < 0 && open.empty()) return Span{token.begin, token.end};
    if (change < 0) open.pop_back();
  }
  return open.empty() ? std::nullopt : std::optional(open.back());
}

// A line that ends with a backslash goes on in the next one; blanks may stand behind it.
std::optional<Span> splice_in(std::string_view text, std::size_t begin, std::size_t end) {
  for (std::size_t at = begin; (at = text.find('\\', at)) < end; ++at) {
    const std::size_t behind = text.find_first_not_of(" \t", at + 1);
    if (behind != text.npos && behind < text.size() && text[behind] == '\n') {
      return Span{at, at + 1};
    }
  }
  return std::nullopt;
}

bool is_raw_string(const RawToken& token, std::string_view text) {
  const std::string_view words = token.in(text);
  const std::size_t quote = words.find('"');
  return token.kind.ends_with("string_literal") && quote != words.npos && quote > 0 &&
         words[quote - 1] == 'R';
}

// What is no C++ outside of strings and comments.
std::optional<TextFault> token_fault(const std::string& text, const RawTokens& tokens) {
  for (const RawToken& token : tokens) {
    const std::string_view words = token.in(text);
    const bool is_long = token.kind == "comment" && words.starts_with("/*");
    const auto splice = is_long || is_raw_string(token, text)
                            ? std::nullopt
                            : splice_in(text, token.begin, token.end);
    if (splice) {
      return TextFault{"a line ends with a backslash, so the next one belongs to it", *splice};
    }
    const bool is_foreign = token.kind == "unknown" && !is_blank(words);
    const bool is_odd_name =
        token.kind == "raw_identifier" && words.find_first_of("\\$") != words.npos;
    if (!is_foreign && !is_odd_name) continue;
    const std::size_t begin =
        token.begin + std::min(words.find_first_not_of(" \t\n"), words.size());
    const std::size_t end = std::min(token.end, character_end(text, begin));
    if (is_foreign && words.find_first_of("\"'/") != words.npos) {
      return TextFault{"a quote or a comment is opened and not closed", {begin, end}};
    }
    const std::string name = code_point_of(text.substr(begin, end - begin));
    return TextFault{"C++ has no such character here, " + name, {begin, end}};
  }
  return std::nullopt;
}

}  // namespace

HandInRules::HandInRules(const std::vector<std::string>& texts,
                         const std::vector<RawTokens>& tokens) {
  for (std::size_t i = 0; i < texts.size(); ++i) {
    for (const RawToken& token : tokens[i]) {
      if (token.kind == "raw_identifier") words_.emplace(token.in(texts[i]));
    }
    for (auto& [words, span] : directives_in(texts[i], tokens[i])) {
      directives_.insert(std::move(words));
    }
  }
  is_closed_ = !open_bracket(code_of(tokens[0], texts[0]));
}

std::optional<TextFault> HandInRules::word_fault(const std::string& text, const RawTokens& tokens,
                                                 std::span<const std::string_view> harmless) const {
  const RawTokens code = code_of(tokens, text);
  const auto word = [&](std::size_t i) { return i < code.size() ? code[i].in(text) : ""; };
  for (std::size_t i = 0; i < code.size(); ++i) {
    if (code[i].kind != "raw_identifier" || words_.contains(word(i)) ||
        std::ranges::count(harmless, word(i)) > 0) {
      continue;
    }
    const bool replaces =
        word(i) == "operator" && (word(i + 1) == "new" || word(i + 1) == "delete");
    // An alias, a name to use, and a part without a name replace nothing.
    const bool opens = word(i) == "namespace" && (i == 0 || word(i - 1) != "using") &&
                       word(i + 1) != "{" && word(i + 1) != "<%" && word(i + 2) != "=";
    const bool is_attribute = (word(i) == "gnu" || word(i) == "clang") &&
                              (word(i + 1) == "::" || (i > 0 && word(i - 1) == "using"));
    if (std::ranges::count(kRefused, word(i)) == 0 && !is_reserved(word(i)) && !replaces &&
        !opens && !is_attribute) {
      continue;
    }
    const std::string used =
        std::string(word(i)) + (replaces ? " " + std::string(word(i + 1)) : "");
    return TextFault{"a hand-in may not use `" + used + "`", {code[i].begin, code[i].end}};
  }
  return std::nullopt;
}

std::optional<TextFault> HandInRules::expanded_fault(const std::string& text,
                                                     const RawTokens& tokens) const {
  for (const auto& [words, span] : directives_in(text, tokens)) {
    if (is_line_mark(words) || directives_.contains(words)) continue;
    return TextFault{"a macro makes the directive `" + words + "`, and a region has none", span};
  }
  auto fault = word_fault(text, tokens, kHarmless);
  if (fault) fault->why += ", which a macro makes here";
  return fault;
}

void HandInRules::allow_expanded(const std::string& text, const RawTokens& tokens) {
  for (const RawToken& token : tokens) {
    if (token.kind == "raw_identifier") words_.emplace(token.in(text));
  }
  for (auto& [words, span] : directives_in(text, tokens)) {
    if (!is_line_mark(words)) directives_.insert(std::move(words));
  }
}

std::optional<TextFault> HandInRules::scope_fault(const std::string& text,
                                                  const RawTokens& tokens) const {
  for (const auto& [words, span] : directives_in(text, tokens)) {
    if (directives_.contains(words)) continue;
    return TextFault{directives_.empty()
                         ? "a region of this exercise has no preprocessor directives"
                         : "a region has no other preprocessor directives than its solution",
                     span};
  }
  const auto open = is_closed_ ? open_bracket(code_of(tokens, text)) : std::nullopt;
  if (!open) return std::nullopt;
  return TextFault{"a region closes each bracket that it opens, and no other", *open};
}

std::optional<TextFault> HandInRules::fault(const std::string& text,
                                            const RawTokens& tokens) const {
  if (auto found = token_fault(text, tokens)) return found;
  if (auto found = scope_fault(text, tokens)) return found;
  return word_fault(text, tokens, {});
}

std::optional<TextFault> character_fault(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (text[i] == '\r') {
      return TextFault{"a carriage return stands alone, which ends a line for some", {i, i + 1}};
    }
    if ((byte < ' ' && text[i] != '\t' && text[i] != '\n') || byte == 0x7f) {
      return TextFault{"a region has no control characters", {i, i + 1}};
    }
  }
  return std::nullopt;
}

namespace {

// Those without a fault of their characters, which a lexer can read.
std::vector<std::string> readable_ones(const std::vector<std::string>& texts) {
  std::vector<std::string> all;
  for (const std::string& text : texts) all.push_back(character_fault(text) ? "" : text);
  return all;
}

std::vector<std::optional<TextFault>> faults_of(const std::vector<std::string>& texts,
                                                const std::vector<RawTokens>& tokens,
                                                const HandInRules& rules) {
  std::vector<std::optional<TextFault>> faults;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    auto fault = character_fault(texts[i]);
    faults.push_back(fault ? std::move(fault) : rules.fault(texts[i], tokens[i]));
  }
  return faults;
}

}  // namespace

tl::expected<OwnRules, std::string> hand_in_rules(const ExerciseText& exercise,
                                                  const Toolchain& toolchain) {
  std::vector<std::string> texts{exercise.solution()};
  for (const ExerciseText::Variant& variant : exercise.variants()) texts.push_back(variant.code);
  const std::vector<std::string> asked = readable_ones(texts);
  return raw_tokens(asked, toolchain).map([&](const std::vector<RawTokens>& tokens) {
    HandInRules rules(asked, tokens);
    auto faults = faults_of(texts, tokens, rules);
    return OwnRules{std::move(rules), std::move(faults)};
  });
}

tl::expected<std::vector<std::optional<TextFault>>, std::string> hand_in_faults(
    const std::vector<std::string>& texts, const HandInRules& rules, const Toolchain& toolchain) {
  return raw_tokens(readable_ones(texts), toolchain).map([&](const std::vector<RawTokens>& tokens) {
    return faults_of(texts, tokens, rules);
  });
}

}  // namespace mjcourse

// What the text of a hand-in must not have, as it is compiled into one program with its checks.
//
// Its tokens are those of clang's lexer (toolchain/raw_tokens.h). Numbers are judged outside of the
// program (judge.h), so nothing here keeps them; it keeps a text within its region, and makes it
// hard to answer for the checks that say themselves whether they hold.
// Tested by tests/generator/evaluate/programs/hand_in_text_test.cpp.
#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/source_text.h"
#include "lesson/syntax/exercise_text.h"
#include "toolchain/raw_tokens.h"

namespace mjcourse {

struct TextFault {
  std::string why;
  Span span;  // in the text
};

class HandInRules {
 public:
  // What the author's own texts have, a hand-in may have: the solution, the starter and the wrong
  // variants, each with its tokens. The first is the solution.
  HandInRules(const std::vector<std::string>& texts, const std::vector<RawTokens>& tokens);

  std::optional<TextFault> fault(const std::string& text, const RawTokens& tokens) const;

  // The same of what the preprocessor has made of a text, by macros of headers: a word or a
  // directive that is refused. What it has made of the solution, is allowed before.
  std::optional<TextFault> expanded_fault(const std::string& text, const RawTokens& tokens) const;
  void allow_expanded(const std::string& text, const RawTokens& tokens);

 private:
  // Of the author's own text no word is refused; `harmless` are those of others.
  std::optional<TextFault> word_fault(const std::string& text, const RawTokens& tokens,
                                      std::span<const std::string_view> harmless) const;
  std::optional<TextFault> scope_fault(const std::string& text, const RawTokens& tokens) const;

  std::set<std::string, std::less<>> words_, directives_;
  bool is_closed_ = true;  // does the solution close what it opens?
};

// What is no C++ to begin with, before a lexer is asked: carriage returns, of which one ends a
// comment for some compilers, and control characters.
std::optional<TextFault> character_fault(const std::string& text);

// Of an exercise, with what is wrong with the author's own texts: the solution, the starter, and
// the mistakes in their order. In words, why `toolchain` cannot tell.
struct OwnRules {
  HandInRules rules;
  std::vector<std::optional<TextFault>> faults;
};
tl::expected<OwnRules, std::string> hand_in_rules(const ExerciseText& exercise,
                                                  const Toolchain& toolchain);

// Of each of `texts`, whose lines end with line feeds.
tl::expected<std::vector<std::optional<TextFault>>, std::string> hand_in_faults(
    const std::vector<std::string>& texts, const HandInRules& rules, const Toolchain& toolchain);

}  // namespace mjcourse

// Judge: holds what a program found against what its solution expects.
//
// A program that has somebody else's text in it may say of itself whatever it likes. So it does not
// judge, and does not know the answers: its checks report what they found, line by line
// (reported_checks.hpp), and the judge, in our own process, says whether that holds. The answers
// are those of the solution's run: of each check, what was expected, and how far off one may be.
//
// A plain true or false is the program's word, and so are two numbers that are held against each
// other. Each report has a mark, a hash under a key that is in the machine code alone. A forged one
// has to find it there; one that is left out, is missed.
//
//   Judge author(mark);            // hears the solution's run
//   Answers answers = author.answers();
//   Judge judge(answers, mark);    // hears another's
//   judge.verdict();
//
// Tested by tests/generator/evaluate/programs/judge_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/sip_hash.h"
#include "findings/result.h"

namespace mjcourse {

// What a check was given: a number, or a vector.
struct Found {
  std::vector<double> numbers;
  bool is_vector = false;
};

// One call of a check in the solution's run.
struct KnownCall {
  int order = 0;  // among the calls of all checks
  // Of expect_near().
  std::optional<Found> expected = {};
  double tolerance = 0;
};

struct JudgedCheck : Check {
  // Does the program itself say whether it holds?
  bool is_its_word = true;
  int calls = 0;
};

struct Answers {
  struct Known {
    JudgedCheck check;  // that of the solution's run
    std::vector<KnownCall> calls;
  };
  std::vector<Known> checks;  // in the order in which they were made first
  bool is_ended = false;      // did the solution's run say that it came to its end?

  const Known* find(std::string_view what) const;
  bool hold() const;
  // As if none had been made.
  std::vector<JudgedCheck> not_reached() const;
  // All of it, as text.
  std::string key() const;
};

class Judge {
 public:
  // Of the solution's run, which knows itself what is expected. Reports have marks under this key.
  explicit Judge(const SipKey& mark) : mark_(mark) {}
  // Of another's. The answers must outlive it.
  Judge(const Answers& answers, const SipKey& mark) : answers_(&answers), mark_(mark) {}

  // A report, a line; gives what the program then reads ("1" where it holds, "0" where it does not,
  // "" where it does not ask).  What is no report of the checks' own holds nothing.
  std::string hear(std::string_view line);

  // Was there a report that the program's checks did not make?
  bool is_forged() const { return is_forged_; }
  // In the order in which they were made first.
  const std::vector<JudgedCheck>& made() const { return made_; }
  // Those of the answers, in their order, and behind them what the solution does not check. One
  // that was not made fails. So does one with numbers that was made more often than in the
  // solution's run; and one that was made less often, unless the program came to its end and either
  // another fails, from which that may follow, or it is a plain one; then it is the program's word.
  std::vector<JudgedCheck> verdict() const;
  // Of the solution's run.
  Answers answers() const;

 private:
  struct Report;
  bool judge(const Report& report, JudgedCheck& check);
  bool judge_numbers(const Report& report, const Answers::Known& known, JudgedCheck& check);
  std::optional<Report> read(std::string_view line);
  JudgedCheck& made(const Report& report);

  const Answers* answers_ = nullptr;
  SipKey mark_;
  unsigned long number_ = 0;  // of the next report
  bool is_forged_ = false, is_ended_ = false;
  int order_ = 0;  // in the solution's run, of the latest call
  std::vector<JudgedCheck> made_;
  std::vector<Answers::Known> known_;  // of the solution's run
};

}  // namespace mjcourse

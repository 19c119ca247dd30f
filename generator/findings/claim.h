// Claim: one thing that a lesson states, and what came of it.
//
// Claims are the one source of every count: the line in the terminal, the foot of a page, the
// verification page, the report. They are made of a lesson's blocks and results, once all of these
// are there (evaluate/claims/claims.h).
// Tested by tests/generator/page/verification_page_test.cpp.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/diagnostic.h"

namespace mjcourse {

struct Claim {
  enum class Kind {
    program,   // examples/x.cpp compiles and runs as it should
    page,      // a reader's page runs it too, and it prints the same
    region,    // these are lines of it
    exercise,  // its solution passes each check, and what is wrong does not
    snippet,   // this function's body compiles and runs
    commands,  // these commands run
    output,    // this is what it prints
    listing,   // this is a part of a model, or a model
    value,     // this number in the text
    formula,   // this is TeX
    lab,       // every control and reading of it works
    picture,   // this is what the model looks like
    plot,      // this is what an example reported
    image,     // a picture of the author's own
    answer,    // the answer of one question
    citation,  // an established fact, from a source
    code       // code that nobody runs
  };
  enum class Status {
    proved,     // found again by computing it
    cited,      // said by a source that the lesson names
    asserted,   // said by the author alone
    unchecked,  // shown and not run
    failed      // not so, or nobody can know: a diagnostic says why
  };

  Kind kind = Kind::formula;
  Status status = Status::failed;
  std::string what;                 // "examples/x.cpp", "question 3: How many …"; one line
  Place place;                      // where the lesson states it
  Span extent;                      // all that states it
  std::size_t block = 0, part = 0;  // the lesson's block, and which question of a quiz

  std::string how;     // how it was found out, a phrase: "compiled by …"; empty when it was not
  std::string limits;  // what was not looked at, or how far; may be empty
  std::string reason;  // why it is not proved: an author's words or a source; may be empty

  // A hash, the same for two reports that found the same. It is taken of four things. First, the
  // claim as it is written, with its options. Second, what is known to have gone into it: a
  // program's text, the helper header, the bytes of the models that it names, TeX macros. Third,
  // the versions of mjcourse, MuJoCo and whatever else worked on it. Fourth, what was found: what
  // it printed, computed, drew, or was refused for. Not of where the course lies, of hosts, users
  // or times, nor of where in the lesson it stands. What it cannot see: system headers and
  // libraries, files that a program opens under names it puts together, and changes of the
  // generator between two versions.
  std::string key;

  // Measured, and in no site: the whole of it, and of a program or snippet the run alone.
  double seconds = 0, run_seconds = 0;
};

using Claims = std::vector<Claim>;

// "program", "proved": their names in a report.
const char* name_of(Claim::Kind kind);
const char* name_of(Claim::Status status);

}  // namespace mjcourse

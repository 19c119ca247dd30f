// The text of a program that is an exercise: one file has what its reader begins with, the
// solution, and mistakes that people make, so none of them can lag behind the others.
//
//   // #region answer
//   return mass * 9.81;             the solution, as every compiler sees it
//   // #starter
//   // return 0;                    what a reader begins with
//   // #wrong forgets-g: the weight  a mistake, and the check that refuses it
//   // return mass;
//   // #endregion
//
// Enter at read_exercise().
// Tested by tests/generator/lesson/syntax/exercise_text_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "base/source_text.h"
#include "report/diagnostic.h"

namespace mjcourse {

class ExerciseText {
 public:
  // What may stand in the place of the solution.
  struct Variant {
    std::string name;   // "" of the starter
    std::string check;  // how the check begins that is to fail; "" of the starter
    int mark = 0;       // the line of its mark, from 1
    int end = 0;        // the line behind its last
    std::string code;   // without the comment signs, with the indentation that it is to have
  };

  const SourceText& file() const { return file_; }
  // The lines between the region's mark and the starter's.
  const std::string& solution() const { return solution_; }
  int solution_line() const { return begin_ + 1; }
  const Variant& starter() const { return variants_.front(); }
  // The starter, and then the mistakes.
  const std::vector<Variant>& variants() const { return variants_; }

  // The file with `code` in the region, whose marks stay, as a reader has it: other regions' are
  // left out.
  std::string program(std::string_view code) const;
  // Where the code begins in there, and in which line.
  std::size_t code_begin() const;
  int code_line() const;
  // The same, whose lines behind the region a compiler counts as in the file.
  std::string numbered_program(std::string_view code) const;
  // The file with the variant in the solution's place. Each of its words is in the same line as
  // in the file, so the words of a compiler lead there.
  std::string in_place(const Variant& variant) const;

 private:
  friend class ExerciseReader;
  explicit ExerciseText(SourceText file) : file_(std::move(file)) {}

  SourceText file_;
  int begin_ = 0, solution_end_ = 0, end_ = 0;  // the lines of the first three kinds of marks
  std::string solution_;
  std::vector<Variant> variants_;
};

// The exercise that `region` of `file` is. Nothing (reported) where it has no starter, or its marks
// say nothing that can be understood.
std::optional<ExerciseText> read_exercise(const SourceText& file, const std::string& region,
                                          Diagnostics& diagnostics);

// Is this line `// #starter` or `// #wrong NAME: CHECK`, which end the solution?
bool begins_variant(std::string_view line);

// The code between the marks of a region, in a text that a reader wrote. In words, what the text
// has in place of that: no mark, or two of them, of which one may be in a comment.
tl::expected<std::string, std::string> code_in_region(std::string_view program,
                                                      std::string_view region);

// `program` with `code` between these marks; nothing where one is gone. A compiler counts its lines
// from kCodeLine on, and those behind it as in `program`, which it is told is `path`.
inline constexpr int kCodeLine = 1'000'000;
std::optional<std::string> with_code_in_region(std::string_view program, std::string_view region,
                                               std::string_view code, const std::string& path);

// `program` with the solution alone in each region. A text that is no exercise is the same.
std::string without_exercise(std::string_view program);

}  // namespace mjcourse

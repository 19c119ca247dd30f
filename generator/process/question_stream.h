// QuestionStream: the other end of ProcessSupervisor::ask(), for a program that is asked.
// Tested by tests/generator/evaluate/worker_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mjcourse {

class QuestionStream {
 public:
  // From now on, what is printed goes to stderr: whatever a library prints must not come between
  // answers.
  QuestionStream();

  // Nothing at the end.
  std::optional<std::string> next() const;
  // False where nobody listens any more.
  bool answer(std::string_view text) const;

 private:
  int answers_;
};

}  // namespace mjcourse

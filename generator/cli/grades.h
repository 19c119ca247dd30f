// What hand-ins came to, as text for people and for other tools.
//
// A Grade is plain data: `grade` keeps it as JSON, and takes it up again.
// Tested by tests/generator/cli/grades_test.cpp.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "evaluate/hand_in.h"

namespace mjcourse {

struct GradedCheck : JudgedCheck {
  bool is_hidden = false;
};

// Of one exercise in one hand-in.
struct Grade {
  std::string exercise, title, lesson;
  bool handed_in = false;
  std::vector<GradedCheck> checks = {};
  // Why there are no checks that count: JSON of diagnostics, as reports have it.
  nlohmann::json faults = nlohmann::json::array();
  bool is_hidden_fault = false;
  std::optional<std::int64_t> minutes_late =
      {};  // of a file that was changed after the time it was due

  double points() const;
  double most() const;  // points that can be had
  // Of points(), those that a check gave of which the program itself said that it holds.
  double own_word() const;
  // Why there are no checks that count, in one line; "" where there are.
  std::string fault() const;
  // May what ended it be of others, who had the processors, the memory or the threads?
  bool may_be_of_others() const;
  std::string late() const;  // "2 h 5 min late", or ""
};

// Of a judgement; and of what was not handed in, or cannot be judged.
Grade grade_of(const JudgedExercise& exercise, const std::string& title, const Verdict& verdict);

// What a judgement comes to, without what belongs to a student. Nothing where that is none, or not
// of the same checks as `like`.
nlohmann::json judgement_json(const Grade& grade);
std::optional<Grade> grade_of_json(const nlohmann::json& judgement, const Grade& like);

struct GradedHandIn {
  std::string student, folder;
  std::string remark;  // "" where all is well
  std::vector<Grade> grades;

  double points() const;
  double most() const;
};

std::string grades_text(const std::vector<GradedHandIn>& graded, GradeFormat format);
// A row for each student.
std::string students_csv(const std::vector<GradedHandIn>& graded);
// Markdown, for the student.
std::string letter(const GradedHandIn& graded);

// "1.5 of 3 points"
std::string points_text(double points, double most);

}  // namespace mjcourse

#include "cli/grades.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/counted.h"
#include "base/utf8.h"
#include "page/html/csv.h"
#include "report/diagnostic_json.h"
#include "report/junit.h"

namespace mjcourse {
namespace {

using nlohmann::json;

std::string short_number(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", number);
  return text;
}

std::string points_text(double points, double most) {
  return short_number(points) + " of " + short_number(most) + (most == 1 ? " point" : " points");
}

// Why there are no checks that count, in one line; "" where there are.
std::string fault_of(const Grade& grade) {
  if (!grade.handed_in) return "not handed in";
  if (grade.verdict.faults.empty()) return "";
  const Diagnostic& first = grade.verdict.faults.front();
  const std::string line =
      first.place.line > 0 ? " in line " + std::to_string(first.place.line) : "";
  return readable(first.message) + line;
}

// Those of a grade, with whether its reader sees them.
template <typename Take>
void for_each_check(const Grade& grade, const Take& take) {
  for (const Check& check : grade.verdict.shown) take(check, false);
  for (const Check& check : grade.verdict.hidden) take(check, true);
}

std::string for_people(const std::vector<GradedHandIn>& graded) {
  std::string text;
  for (const GradedHandIn& hand_in : graded) {
    text += readable(hand_in.folder) + "\n";
    for (const Grade& grade : hand_in.grades) {
      const std::string fault = fault_of(grade);
      text += "  " + grade.exercise + ": " + points_text(grade.verdict.points(), grade.most) +
              (fault.empty() ? "" : "; " + fault) + "\n";
      if (!fault.empty()) continue;
      for_each_check(grade, [&](const Check& check, bool) {
        if (!check.holds) text += "  " + check_text(check);
      });
    }
  }
  return text + counted(graded.size(), "hand-in") + "\n";
}

json json_of(const Grade& grade) {
  json checks = json::array();
  for_each_check(grade, [&](const Check& check, bool hidden) {
    checks.push_back({{"what", check.what},
                      {"hidden", hidden},
                      {"holds", check.holds},
                      {"points", check.points},
                      {"meaning", check.meaning},
                      {"found", check.found}});
  });
  json faults = json::array();
  for (const Diagnostic& fault : grade.verdict.faults) faults.push_back(mjcourse::json_of(fault));
  return {
      {"exercise", grade.exercise},       {"lesson", grade.lesson}, {"handed_in", grade.handed_in},
      {"points", grade.verdict.points()}, {"of", grade.most},       {"checks", std::move(checks)},
      {"faults", std::move(faults)}};
}

std::string as_json(const std::vector<GradedHandIn>& graded) {
  json all = json::array();
  for (const GradedHandIn& hand_in : graded) {
    double points = 0, most = 0;
    json exercises = json::array();
    for (const Grade& grade : hand_in.grades) {
      points += grade.verdict.points();
      most += grade.most;
      exercises.push_back(json_of(grade));
    }
    all.push_back({{"hand_in", hand_in.folder},
                   {"points", points},
                   {"of", most},
                   {"exercises", std::move(exercises)}});
  }
  // What a stranger's program says may be no text.
  return all.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

// What a spreadsheet would take for a formula is text.
std::string cell(const std::string& text) {
  const bool is_formula = text.find_first_of("=+-@\t") == 0;
  return csv_field((is_formula ? "'" : "") + readable(text));
}

std::string as_csv(const std::vector<GradedHandIn>& graded) {
  std::string text = "hand_in,lesson,exercise,check,hidden,holds,points,of,remark\r\n";
  for (const GradedHandIn& hand_in : graded) {
    for (const Grade& grade : hand_in.grades) {
      for_each_check(grade, [&](const Check& check, bool hidden) {
        text += cell(hand_in.folder) + "," + cell(grade.lesson) + "," + cell(grade.exercise) + "," +
                cell(check.what) + (hidden ? ",yes" : ",no") + (check.holds ? ",yes," : ",no,") +
                short_number(check.holds ? check.points : 0) + "," + short_number(check.points) +
                "," + cell(fault_of(grade)) + "\r\n";
      });
    }
  }
  return text;
}

std::string as_junit(const std::vector<GradedHandIn>& graded) {
  std::vector<TestSuite> suites;
  for (const GradedHandIn& hand_in : graded) {
    TestSuite& suite = suites.emplace_back(TestSuite{readable(hand_in.folder), "", {}});
    for (const Grade& grade : hand_in.grades) {
      const std::string fault = fault_of(grade);
      for_each_check(grade, [&](const Check& check, bool) {
        TestCase& made =
            suite.cases.emplace_back(TestCase{grade.exercise + ": " + readable(check.what)});
        if (check.holds) return;
        made.failure = !fault.empty() ? fault : readable(check.meaning + " " + check.found);
        made.id = "E-check-fails";
      });
    }
  }
  return junit_xml(suites, 0);
}

}  // namespace

std::string grades_text(const std::vector<GradedHandIn>& graded, GradeFormat format) {
  switch (format) {
    case GradeFormat::text:
      return for_people(graded);
    case GradeFormat::json:
      return as_json(graded);
    case GradeFormat::csv:
      return as_csv(graded);
    case GradeFormat::junit:
      return as_junit(graded);
  }
  return "";
}

}  // namespace mjcourse

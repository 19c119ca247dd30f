#include "cli/grades.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>
#include <utility>

#include "base/counted.h"
#include "base/utf8.h"
#include "cli/exercise_list.h"
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

std::string for_people(const std::vector<GradedHandIn>& graded) {
  std::string text;
  for (const GradedHandIn& hand_in : graded) {
    text +=
        readable(hand_in.student) + (hand_in.remark.empty() ? "" : ": " + hand_in.remark) + "\n";
    for (const Grade& grade : hand_in.grades) {
      const std::string fault = grade.fault(), late = grade.late();
      const double word = grade.own_word();
      text += "  " + grade.exercise + ": " + points_text(grade.points(), grade.most()) +
              (word > 0 ? ", " + short_number(word) + " of them at its own word" : "") +
              (late.empty() ? "" : ", " + late) + (fault.empty() ? "" : "; " + fault) + "\n";
      if (!fault.empty()) continue;
      for (const GradedCheck& check : grade.checks) {
        if (!check.holds) text += "  " + check_text(check);
      }
    }
  }
  return text + counted(graded.size(), "hand-in") + "\n";
}

json json_of(const Grade& grade) {
  json all = judgement_json(grade);
  all["handed_in"] = grade.handed_in;
  all["points"] = grade.points();
  all["of"] = grade.most();
  all["minutes_late"] = grade.minutes_late ? json(*grade.minutes_late) : json();
  return all;
}

std::string as_json(const std::vector<GradedHandIn>& graded) {
  json all = json::array();
  for (const GradedHandIn& hand_in : graded) {
    json exercises = json::array();
    for (const Grade& grade : hand_in.grades) exercises.push_back(json_of(grade));
    all.push_back({{"student", hand_in.student},
                   {"hand_in", hand_in.folder},
                   {"remark", hand_in.remark},
                   {"points", hand_in.points()},
                   {"of", hand_in.most()},
                   {"exercises", std::move(exercises)}});
  }
  // What a stranger's program says may be no text.
  return all.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

// What a spreadsheet would take for a formula is text, also behind a semicolon: where a comma
// stands in numbers, that parts the fields, and a quote in the middle of one keeps nothing
// together.
std::string without_formulas(const std::string& text) {
  constexpr std::array<std::string_view, 8> signs{"=", "+", "-", "@", "＝", "＋", "－", "＠"};
  std::string safe;
  bool is_begin = true;
  for (const std::string_view character : characters_of(text)) {
    if (is_begin && std::ranges::count(signs, character) > 0) safe += "'";
    is_begin = character == ";" || (is_begin && (character == " " || character == "\""));
    safe += character;
  }
  return safe;
}

std::string cell(const std::string& text) {
  const std::string field = csv_field(without_formulas(readable(text)));
  return field.find(';') == field.npos || field.starts_with('"') ? field : "\"" + field + "\"";
}

std::string row(const std::vector<std::string>& cells) {
  std::string text;
  for (const std::string& one : cells) text += (text.empty() ? "" : ",") + one;
  return text + "\r\n";
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : "; ") + word;
  return text;
}

const char* yes_or_no(bool is_so) {
  return is_so ? "yes" : "no";
}

std::string checks_csv(const std::vector<GradedHandIn>& graded) {
  std::string text =
      "student,lesson,exercise,check,hidden,own_word,holds,points,of,late,remark\r\n";
  for (const GradedHandIn& hand_in : graded) {
    for (const Grade& grade : hand_in.grades) {
      for (const GradedCheck& check : grade.checks) {
        text +=
            row({cell(hand_in.student), cell(grade.lesson), cell(grade.exercise), cell(check.what),
                 yes_or_no(check.is_hidden), yes_or_no(check.is_its_word), yes_or_no(check.holds),
                 short_number(check.holds ? check.points : 0), short_number(check.points),
                 yes_or_no(grade.minutes_late.has_value()), cell(grade.fault())});
      }
    }
  }
  return text;
}

std::string as_junit(const std::vector<GradedHandIn>& graded) {
  std::vector<TestSuite> suites;
  for (const GradedHandIn& hand_in : graded) {
    TestSuite& suite = suites.emplace_back(TestSuite{readable(hand_in.student), "", {}});
    for (const Grade& grade : hand_in.grades) {
      const std::string fault = grade.fault();
      for (const GradedCheck& check : grade.checks) {
        TestCase& made =
            suite.cases.emplace_back(TestCase{grade.exercise + ": " + readable(check.what)});
        if (check.holds) continue;
        made.failure = !fault.empty() ? fault : readable(check.meaning + " " + check.found);
        made.id = "E-check-fails";
      }
    }
  }
  return junit_xml(suites, 0);
}

// In one line, of which Markdown takes nothing for a sign.
std::string plain(const std::string& words) {
  std::string text;
  for (const char c : readable(words)) {
    if (std::string_view("\\`*_{}[]<>()#+-!|~&").find(c) != std::string_view::npos) text += '\\';
    text += c;
  }
  return text;
}

std::string letter_line(const GradedCheck& check) {
  std::string line = std::string("- ") + (check.holds ? "✓" : "✗") + " " + plain(check.what) +
                     " (" + short_number(check.points) +
                     (check.points == 1 ? " point)" : " points)");
  // Of hidden checks nobody is told what they found: another may still have to hand in.
  if (check.holds || check.is_hidden) return line + "\n";
  for (const std::string& words : {check.meaning, check.found}) {
    if (!words.empty()) line += "  \n  " + plain(words);
  }
  return line + "\n";
}

// Of what ended a program, the kind alone: its words may tell of hidden checks, or of the teacher's
// machine. A compiler's words quote the program: of one with hidden checks they tell what it has.
std::string letter_fault(const Grade& grade) {
  const std::string id = grade.faults.empty() ? "" : grade.faults.front().value("id", "");
  if (!grade.handed_in) return grade.fault();
  if (id == "E-hand-in") return grade.is_hidden_fault ? "the text was refused" : grade.fault();
  if (id == "E-example-compile") {
    return grade.is_hidden_fault ? "the program did not compile" : grade.fault();
  }
  if (id == "E-example-timeout") return "the program took too long, and was stopped";
  if (id == "E-example-throws") return "the program threw an exception";
  if (id == "E-example-signal") return "the program crashed";
  return "the program did not come to its end";
}

std::string letter_part(const Grade& grade) {
  const std::string title = grade.title.empty() ? grade.exercise : grade.title;
  std::string text = "\n## " + plain(title) + ": " + points_text(grade.points(), grade.most()) +
                     "\n\n`" + grade.exercise + ".cpp`, lesson " + grade.lesson;
  const std::string late = grade.late();
  text += (late.empty() ? "" : ", " + late) + ".\n\n";
  const bool is_faulty = !grade.fault().empty();
  if (is_faulty && !grade.is_hidden_fault) return text + plain(letter_fault(grade)) + ".\n";
  const auto add = [&](bool hidden, const std::string& before) {
    const auto is = [&](const GradedCheck& check) { return check.is_hidden == hidden; };
    if (std::ranges::none_of(grade.checks, is)) return;
    text += before;
    for (const GradedCheck& check : grade.checks) {
      if (is(check)) text += letter_line(check);
    }
  };
  add(false, "");
  const std::string hidden = "\nChecks that the page does not show";
  add(true, hidden + (is_faulty ? ", with which " + plain(letter_fault(grade)) : "") + ":\n\n");
  return text;
}

// Has a bound on time ended it, or was something short that is the whole machine's?
bool is_of_others(const json& fault) {
  const std::string id = fault.value("id", ""), message = fault.value("message", "");
  const auto says = [&](const auto&... words) {
    return ((message.find(words) != message.npos) || ...);
  };
  if (id == "E-example-timeout" || id == "E-example-memory") return true;
  if (id == "E-example-signal") return says(": Killed", "could not be started");
  if (id == "E-example-throws") return says("threw std::bad_alloc", "threw std::system_error");
  if (id == "E-example-compile") {
    return message.starts_with("the compiler ") && message.ends_with(", and was stopped");
  }
  return id == "E-hand-in" && says("the lexer gave no answer");
}

}  // namespace

double Grade::points() const {
  double sum = 0;
  for (const GradedCheck& check : checks) sum += check.holds ? check.points : 0;
  return sum;
}

double Grade::most() const {
  double sum = 0;
  for (const GradedCheck& check : checks) sum += check.points;
  return sum;
}

double Grade::own_word() const {
  double sum = 0;
  for (const GradedCheck& check : checks) {
    sum += check.holds && check.is_its_word ? check.points : 0;
  }
  return sum;
}

std::string Grade::fault() const {
  if (!handed_in) return "not handed in";
  if (faults.empty()) return "";
  const json& first = faults.front();
  const json place = first.value("place", json::object());
  const int line = place.value("line", 0);
  return readable(first.value("message", "")) +
         (line > 0 ? " in line " + std::to_string(line) : "");
}

bool Grade::may_be_of_others() const {
  return std::ranges::any_of(faults, is_of_others);
}

std::string Grade::late() const {
  if (!minutes_late) return "";
  const std::int64_t days = *minutes_late / 1440, hours = *minutes_late / 60 % 24,
                     minutes = *minutes_late % 60;
  if (days > 0) return counted(days, "day") + " " + std::to_string(hours) + " h late";
  return (hours > 0 ? std::to_string(hours) + " h " : "") + std::to_string(minutes) + " min late";
}

double GradedHandIn::points() const {
  double sum = 0;
  for (const Grade& grade : grades) sum += grade.points();
  return sum;
}

double GradedHandIn::most() const {
  double sum = 0;
  for (const Grade& grade : grades) sum += grade.most();
  return sum;
}

std::string points_text(double points, double most) {
  return short_number(points) + " of " + short_number(most) + (most == 1 ? " point" : " points");
}

Grade grade_of(const JudgedExercise& exercise, const std::string& title, const Verdict& verdict) {
  Grade grade{exercise.exercise->program.name(), title, exercise.lesson->number};
  for (const JudgedCheck& check : verdict.shown) grade.checks.push_back({check, false});
  for (const JudgedCheck& check : verdict.hidden) grade.checks.push_back({check, true});
  for (const Diagnostic& fault : verdict.faults) grade.faults.push_back(mjcourse::json_of(fault));
  grade.is_hidden_fault = verdict.is_hidden_fault;
  return grade;
}

json judgement_json(const Grade& grade) {
  json checks = json::array();
  for (const GradedCheck& check : grade.checks) {
    checks.push_back({{"what", check.what},
                      {"hidden", check.is_hidden},
                      {"own_word", check.is_its_word},
                      {"holds", check.holds},
                      {"points", check.points},
                      {"meaning", check.meaning},
                      {"found", check.found}});
  }
  return {{"exercise", grade.exercise}, {"title", grade.title},
          {"lesson", grade.lesson},     {"checks", std::move(checks)},
          {"faults", grade.faults},     {"hidden_fault", grade.is_hidden_fault}};
}

std::optional<Grade> grade_of_json(const json& judgement, const Grade& like) {
  try {
    Grade grade{judgement.at("exercise").get<std::string>(),
                judgement.at("title").get<std::string>(),
                judgement.at("lesson").get<std::string>()};
    for (const json& one : judgement.at("checks")) {
      GradedCheck& check = grade.checks.emplace_back();
      check.what = one.at("what").get<std::string>();
      check.holds = one.at("holds").get<bool>();
      check.points = one.at("points").get<double>();
      check.meaning = one.at("meaning").get<std::string>();
      check.found = one.at("found").get<std::string>();
      check.is_its_word = one.at("own_word").get<bool>();
      check.is_hidden = one.at("hidden").get<bool>();
    }
    for (const json& fault : judgement.at("faults")) {
      static_cast<void>(fault.at("id").get<std::string>());
      static_cast<void>(fault.at("message").get<std::string>());
      static_cast<void>(fault.at("place").at("line").get<int>());
      grade.faults.push_back(fault);
    }
    grade.is_hidden_fault = judgement.at("hidden_fault").get<bool>();
    const auto is_same = [](const GradedCheck& a, const GradedCheck& b) {
      return a.what == b.what && a.points == b.points && a.is_hidden == b.is_hidden;
    };
    // Behind those of the solution, others may stand, which give no points.
    const bool fits = grade.exercise == like.exercise && grade.most() == like.most() &&
                      std::ranges::all_of(like.checks, [&](const GradedCheck& due) {
                        return std::ranges::any_of(grade.checks, [&](const GradedCheck& one) {
                          return is_same(one, due);
                        });
                      });
    return fits ? std::optional(std::move(grade)) : std::nullopt;
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

std::string grades_text(const std::vector<GradedHandIn>& graded, GradeFormat format) {
  switch (format) {
    case GradeFormat::text:
      return for_people(graded);
    case GradeFormat::json:
      return as_json(graded);
    case GradeFormat::csv:
      return checks_csv(graded);
    case GradeFormat::junit:
      return as_junit(graded);
  }
  return "";
}

std::string students_csv(const std::vector<GradedHandIn>& graded) {
  std::vector<std::string> head{"student", "points", "of"};
  if (!graded.empty()) {
    for (const Grade& grade : graded.front().grades) head.push_back(cell(grade.exercise));
  }
  head.insert(head.end(), {"own_word", "late", "missing", "remark"});
  std::string text = row(head);
  for (const GradedHandIn& hand_in : graded) {
    std::vector<std::string> cells{cell(hand_in.student), short_number(hand_in.points()),
                                   short_number(hand_in.most())};
    std::vector<std::string> late, missing, remarks;
    if (!hand_in.remark.empty()) remarks.push_back(hand_in.remark);
    double word = 0;
    for (const Grade& grade : hand_in.grades) {
      cells.push_back(short_number(grade.points()));
      word += grade.own_word();
      if (grade.minutes_late) late.push_back(grade.exercise + ": " + grade.late());
      if (!grade.handed_in) missing.push_back(grade.exercise);
      if (grade.handed_in && !grade.faults.empty()) {
        remarks.push_back(grade.exercise + ": " + grade.fault());
      }
    }
    cells.insert(cells.end(), {short_number(word), cell(joined(late)), cell(joined(missing)),
                               cell(joined(remarks))});
    text += row(cells);
  }
  return text;
}

std::string letter(const GradedHandIn& graded) {
  std::string text =
      "# " + plain(graded.student) + "\n\n" + points_text(graded.points(), graded.most()) + ".\n";
  if (!graded.remark.empty()) text += "\n" + plain(graded.remark) + ".\n";
  for (const Grade& grade : graded.grades) text += letter_part(grade);
  return text;
}

}  // namespace mjcourse

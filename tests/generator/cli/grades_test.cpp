#include "cli/grades.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace mjcourse {
namespace {

GradedCheck check(const Check& made, bool is_its_word = false, bool is_hidden = false) {
  GradedCheck all;
  static_cast<Check&>(all) = made;
  all.is_its_word = is_its_word;
  all.is_hidden = is_hidden;
  return all;
}

// A hand-in with a check that holds, one that does not, and a hidden one; another that does not
// compile, and is late; and one that is not there.
std::vector<GradedHandIn> graded() {
  const GradedCheck falls = check({"it falls", true, "", "", 2}, true);
  const GradedCheck rests =
      check({"it rests", false, "it is pushed", "it is 1, and should be 0 ± 1e-09"});
  const GradedCheck hidden = check({"it, \"too\"", false, "secret", "secret"}, false, true);
  const GradedCheck no_fall = check({"it falls", false, "", "", 2}, true);
  const GradedCheck no_rest = check({"it rests", false, "", ""});
  Grade whole{"fall", "A *fall*", "1.1", true, {falls, rests, hidden}};
  Grade broken{"fall", "A *fall*", "1.1", true, {no_fall, no_rest, hidden}};
  broken.minutes_late = 65;
  broken.faults = {
      {{"id", "E-example-compile"}, {"message", "expected ';'"}, {"place", {{"line", 7}}}}};
  Grade missing{"fall", "", "1.1", false, {no_fall, no_rest, hidden}};
  return {{"ann", "in/ann", "", {whole}},
          {"=cmd", "in/=cmd", "", {broken}},
          {"cid", "in/cid", "it is a link", {missing}}};
}

TEST(Grades, AreAListForPeople) {
  EXPECT_EQ(grades_text(graded(), GradeFormat::text), R"(ann
  fall: 2 of 4 points, 2 of them at its own word
    [ ] it rests
      it is pushed
      it is 1, and should be 0 ± 1e-09
    [ ] it, "too"
      secret
      secret
=cmd
  fall: 0 of 4 points, 1 h 5 min late; expected ';' in line 7
cid: it is a link
  fall: 0 of 4 points; not handed in
3 hand-ins
)");
}

TEST(Grades, AreATableOfChecksWithoutFormulas) {
  EXPECT_EQ(grades_text(graded(), GradeFormat::csv),
            "student,lesson,exercise,check,hidden,own_word,holds,points,of,late,remark\r\n"
            "ann,1.1,fall,it falls,no,yes,yes,2,2,no,\r\n"
            "ann,1.1,fall,it rests,no,no,no,0,1,no,\r\n"
            "ann,1.1,fall,\"it, \"\"too\"\"\",yes,no,no,0,1,no,\r\n"
            "'=cmd,1.1,fall,it falls,no,yes,no,0,2,yes,\"expected ';' in line 7\"\r\n"
            "'=cmd,1.1,fall,it rests,no,no,no,0,1,yes,\"expected ';' in line 7\"\r\n"
            "'=cmd,1.1,fall,\"it, \"\"too\"\"\",yes,no,no,0,1,yes,\"expected ';' in line 7\"\r\n"
            "cid,1.1,fall,it falls,no,yes,no,0,2,no,not handed in\r\n"
            "cid,1.1,fall,it rests,no,no,no,0,1,no,not handed in\r\n"
            "cid,1.1,fall,\"it, \"\"too\"\"\",yes,no,no,0,1,no,not handed in\r\n");
}

TEST(Grades, AreATableOfStudents) {
  EXPECT_EQ(students_csv(graded()),
            "student,points,of,fall,own_word,late,missing,remark\r\n"
            "ann,2,4,2,2,,,\r\n"
            "'=cmd,0,4,0,0,fall: 1 h 5 min late,,\"fall: expected ';' in line 7\"\r\n"
            "cid,0,4,0,0,,fall,it is a link\r\n");
}

TEST(Grades, AreLettersThatKeepWhatHiddenChecksFound) {
  EXPECT_EQ(letter(graded()[0]), R"(# ann

2 of 4 points.

## A \*fall\*: 2 of 4 points

`fall.cpp`, lesson 1.1.

- ✓ it falls (2 points)
- ✗ it rests (1 point)  
  it is pushed  
  it is 1, and should be 0 ± 1e\-09

Checks that the page does not show:

- ✗ it, "too" (1 point)
)");
  EXPECT_EQ(letter(graded()[1]), R"(# =cmd

0 of 4 points.

## A \*fall\*: 0 of 4 points

`fall.cpp`, lesson 1.1, 1 h 5 min late.

expected ';' in line 7.
)");
}

// The words of an exception may hold what a hidden check was made of.
TEST(Grades, AreLettersThatTellOfAFaultItsKindAlone) {
  GradedHandIn ann = graded()[0];
  ann.grades[0].faults = {{{"id", "E-example-throws"}, {"message", "threw 0.75"}}};
  ann.grades[0].is_hidden_fault = true;
  EXPECT_EQ(letter(ann), R"(# ann

2 of 4 points.

## A \*fall\*: 2 of 4 points

`fall.cpp`, lesson 1.1.

- ✓ it falls (2 points)
- ✗ it rests (1 point)  
  it is pushed  
  it is 1, and should be 0 ± 1e\-09

Checks that the page does not show, with which the program threw an exception:

- ✗ it, "too" (1 point)
)");
  ann.grades[0].is_hidden_fault = false;
  EXPECT_NE(letter(ann).find("lesson 1.1.\n\nthe program threw an exception.\n"),
            std::string::npos);
}

// What the compiler says of the program with the hidden checks has their numbers.
TEST(Grades, AreLettersWithoutWordsOnTheHiddenProgram) {
  GradedHandIn ann = graded()[0];
  ann.grades[0].is_hidden_fault = true;
  const auto shown = [&](const std::string& id) {
    ann.grades[0].faults = {{{"id", id},
                             {"message", "no type named 'secret' in 'integer_sequence<long, 75>'"},
                             {"detail", "75"},
                             {"place", {{"line", 75}}}}};
    const std::string text = letter(ann);
    return text.substr(std::min(text.find("Checks that"), text.size()));
  };
  const auto with = [](const std::string& fault) {
    return "Checks that the page does not show, with which " + fault +
           ":\n\n- ✗ it, \"too\" (1 point)\n";
  };
  EXPECT_EQ(shown("E-example-compile"), with("the program did not compile"));
  EXPECT_EQ(shown("E-hand-in"), with("the text was refused"));
  EXPECT_EQ(shown("E-example-timeout"), with("the program took too long, and was stopped"));
  EXPECT_EQ(shown("E-example-signal"), with("the program crashed"));
  EXPECT_EQ(shown("E-example-mujoco"), with("the program did not come to its end"));
  EXPECT_EQ(letter(ann).find("75"), std::string::npos);
}

// Read with a semicolon between fields, the remark is no longer a field in quotes.
TEST(Grades, AreTablesWithoutFormulasBehindASemicolon) {
  GradedHandIn ann = graded()[0];
  const auto remark = [&](const std::string& message) {
    ann.grades[0].faults = {{{"id", "E-example-throws"}, {"message", message}}};
    const std::string table = students_csv({ann});
    return table.substr(table.find("ann,"));
  };
  EXPECT_EQ(remark(";=HYPERLINK(\"http://x\")"),
            "ann,2,4,2,2,,,\"fall: ;'=HYPERLINK(\"\"http://x\"\")\"\r\n");
  EXPECT_EQ(remark("a; \"+1;@b;;-2"), "ann,2,4,2,2,,,\"fall: a; \"\"'+1;'@b;;'-2\"\r\n");
  EXPECT_EQ(remark(";＝1"), "ann,2,4,2,2,,,\"fall: ;'＝1\"\r\n");
  EXPECT_EQ(remark("x = 1, -2; y = -3"), "ann,2,4,2,2,,,\"fall: x = 1, -2; y = -3\"\r\n");
  ann.grades[0].faults = nlohmann::json::array();
  for (const auto& [student, field] :
       {std::pair("x;=1", "\"x;'=1\""), std::pair(" =1", " '=1"), std::pair("a;b", "\"a;b\""),
        std::pair("\"=1", "\"\"\"'=1\"")}) {
    ann.student = student;
    EXPECT_NE(students_csv({ann}).find(std::string("\r\n") + field + ",2,4,"), std::string::npos)
        << students_csv({ann});
  }
}

TEST(Grades, MayBeOfOthersWhereTimeOrMemoryWasShort) {
  Grade grade = graded()[1].grades[0];
  const auto is_so = [&](const char* id, const char* message) {
    grade.faults = {{{"id", id}, {"message", message}}};
    return grade.may_be_of_others();
  };
  EXPECT_TRUE(is_so("E-example-timeout", "the program still ran after 10 s, and was stopped"));
  EXPECT_TRUE(is_so("E-example-memory", "the program took more than 4 GiB of memory"));
  EXPECT_TRUE(is_so("E-example-signal", "the program was killed: Killed"));
  EXPECT_TRUE(is_so("E-example-signal", "the program could not be started: no memory"));
  EXPECT_TRUE(is_so("E-example-throws", "the program threw std::bad_alloc: std::bad_alloc"));
  EXPECT_TRUE(is_so("E-example-throws", "the program threw std::system_error: no more threads"));
  EXPECT_TRUE(is_so("E-example-compile", "the compiler still ran after 120 s, and was stopped"));
  EXPECT_TRUE(is_so("E-hand-in", "the lexer gave no answer"));
  EXPECT_FALSE(is_so("E-example-signal", "the program was killed: Segmentation fault"));
  EXPECT_FALSE(is_so("E-example-throws", "the program threw std::runtime_error: no"));
  EXPECT_FALSE(is_so("E-example-compile", "the compiler gives no reason"));
  EXPECT_FALSE(is_so("E-hand-in", "it has no region `answer`"));
  grade.faults = nlohmann::json::array();
  EXPECT_FALSE(grade.may_be_of_others());
}

TEST(Grades, AreJson) {
  const auto all = nlohmann::json::parse(grades_text(graded(), GradeFormat::json));
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0]["student"], "ann");
  EXPECT_EQ(all[0]["hand_in"], "in/ann");
  EXPECT_EQ(all[0]["points"], 2);
  EXPECT_EQ(all[0]["of"], 4);
  EXPECT_EQ(all[0]["exercises"][0]["checks"][2]["hidden"], true);
  EXPECT_EQ(all[0]["exercises"][0]["checks"][0]["own_word"], true);
  EXPECT_EQ(all[1]["exercises"][0]["faults"][0]["message"], "expected ';'");
  EXPECT_EQ(all[1]["exercises"][0]["minutes_late"], 65);
  EXPECT_EQ(all[2]["exercises"][0]["handed_in"], false);
}

TEST(Grades, AreTestsToOthers) {
  const std::string xml = grades_text(graded(), GradeFormat::junit);
  EXPECT_NE(xml.find("tests=\"9\" failures=\"8\""), xml.npos) << xml;
  EXPECT_NE(xml.find(">it is pushed it is 1, and should be 0 ± 1e-09<"), xml.npos) << xml;
  EXPECT_NE(xml.find(">not handed in<"), xml.npos) << xml;
}

TEST(Grades, AreTakenUpAsTheyWereKept) {
  const Grade grade = graded()[1].grades[0];
  const auto again = grade_of_json(judgement_json(grade), grade);
  ASSERT_TRUE(again);
  EXPECT_EQ(judgement_json(*again), judgement_json(grade));
  for (const char* damaged : {"null", "[]", "{}", R"({"exercise": 1})",
                              R"({"exercise": "a", "title": "", "lesson": "", "checks": [1],
                                  "faults": []})"}) {
    EXPECT_FALSE(grade_of_json(nlohmann::json::parse(damaged), grade)) << damaged;
  }
  nlohmann::json richer = judgement_json(grade);
  richer["checks"][0]["points"] = 9;
  EXPECT_FALSE(grade_of_json(richer, grade)) << "the check has other points";
  nlohmann::json odd = judgement_json(grade);
  for (const char* faults : {"[1]", "[{}]", R"([{"id": 1, "message": "", "place": {"line": 1}}])",
                             R"([{"id": "", "message": "", "place": {"line": "1"}}])",
                             R"([{"id": "", "message": "", "place": []}])"}) {
    odd["faults"] = nlohmann::json::parse(faults);
    EXPECT_FALSE(grade_of_json(odd, grade)) << faults;
  }
}

}  // namespace
}  // namespace mjcourse

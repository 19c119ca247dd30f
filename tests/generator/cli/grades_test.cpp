#include "cli/grades.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace mjcourse {
namespace {

// A hand-in with a check that holds, one that does not, and a hidden one; another that does not
// compile; and one that is not there.
std::vector<GradedHandIn> graded() {
  const Check falls{"it falls", true, "", "", 2};
  const Check rests{"it rests", false, "it is pushed", "it is 1, and should be 0"};
  const Check hidden{"it, \"too\"", false, "", ""};
  const std::vector<Check> none{{"it falls", false, "", "", 2}, {"it rests", false, "", ""}};
  Grade whole{"fall", "1.1", true, {{falls, rests}, {hidden}, {}}, 4};
  Grade broken{"fall", "1.1", true, {none, {hidden}, {}}, 4};
  Place place;
  place.file = "fall.cpp";
  place.line = 7;
  broken.verdict.faults.push_back(error_at(place, "E-example-compile", "expected ';'"));
  Grade missing{"fall", "1.1", false, {none, {hidden}, {}}, 4};
  return {{"ann", {whole}}, {"=cmd", {broken}}, {"cid", {missing}}};
}

TEST(Grades, AreAListForPeople) {
  EXPECT_EQ(grades_text(graded(), GradeFormat::text), R"(ann
  fall: 2 of 4 points
    [ ] it rests
      it is pushed
      it is 1, and should be 0
    [ ] it, "too"
=cmd
  fall: 0 of 4 points; expected ';' in line 7
cid
  fall: 0 of 4 points; not handed in
3 hand-ins
)");
}

TEST(Grades, AreATableWithoutFormulas) {
  EXPECT_EQ(grades_text(graded(), GradeFormat::csv),
            "hand_in,lesson,exercise,check,hidden,holds,points,of,remark\r\n"
            "ann,1.1,fall,it falls,no,yes,2,2,\r\n"
            "ann,1.1,fall,it rests,no,no,0,1,\r\n"
            "ann,1.1,fall,\"it, \"\"too\"\"\",yes,no,0,1,\r\n"
            "'=cmd,1.1,fall,it falls,no,no,0,2,expected ';' in line 7\r\n"
            "'=cmd,1.1,fall,it rests,no,no,0,1,expected ';' in line 7\r\n"
            "'=cmd,1.1,fall,\"it, \"\"too\"\"\",yes,no,0,1,expected ';' in line 7\r\n"
            "cid,1.1,fall,it falls,no,no,0,2,not handed in\r\n"
            "cid,1.1,fall,it rests,no,no,0,1,not handed in\r\n"
            "cid,1.1,fall,\"it, \"\"too\"\"\",yes,no,0,1,not handed in\r\n");
}

TEST(Grades, AreJson) {
  const auto all = nlohmann::json::parse(grades_text(graded(), GradeFormat::json));
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0]["hand_in"], "ann");
  EXPECT_EQ(all[0]["points"], 2);
  EXPECT_EQ(all[0]["of"], 4);
  EXPECT_EQ(all[0]["exercises"][0]["checks"][2]["hidden"], true);
  EXPECT_EQ(all[1]["exercises"][0]["faults"][0]["message"], "expected ';'");
  EXPECT_EQ(all[2]["exercises"][0]["handed_in"], false);
}

TEST(Grades, AreTestsToOthers) {
  const std::string xml = grades_text(graded(), GradeFormat::junit);
  EXPECT_NE(xml.find("tests=\"9\" failures=\"8\""), xml.npos) << xml;
  EXPECT_NE(xml.find(">it is pushed it is 1, and should be 0<"), xml.npos) << xml;
  EXPECT_NE(xml.find(">not handed in<"), xml.npos) << xml;
}

}  // namespace
}  // namespace mjcourse

// What the verification page says of claims, and where these lead.
#include "page/verification_page.h"

#include <gtest/gtest.h>

#include "page/course_data.h"
#include "page/html/anchors.h"
#include "page/html/verification.h"
#include "page/page_fixture.h"

namespace mjcourse {
namespace {

using nlohmann::json;

class VerificationTest : public PageWriterTest {
 protected:
  // The data of the page of a course whose first lesson has this body and these claims.
  json data(const std::string& body, Claims claims, bool links = true,
            const Findings& findings = {}) {
    writer(body);
    evaluation_.lessons.resize(2);
    evaluation_.lessons[0].claims = std::move(claims);
    return verification_data(published_verification(course_, evaluation_), links, findings);
  }

  static Claim claim(Claim::Kind kind, Claim::Status status, std::size_t block, int line) {
    Claim made;
    made.kind = kind;
    made.status = status;
    made.block = block;
    made.what = "w";
    made.how = "h";
    made.place.line = line;
    return made;
  }

  Evaluation evaluation_;
};

using Kind = Claim::Kind;
using Status = Claim::Status;

TEST_F(VerificationTest, LeadsToTheBlockOrTheHeadingAboveIt) {
  const json page = data(
      "$a$\n\n## One\n\n$b$\n\n```cpp file=examples/x.cpp\n```\n\n```text\n1\n```\n",
      {claim(Kind::formula, Status::proved, 0, 4), claim(Kind::formula, Status::proved, 1, 8),
       claim(Kind::program, Status::proved, 2, 10), claim(Kind::output, Status::proved, 3, 13)});
  std::vector<std::string> found;
  for (const json& group : page["lessons"][0]["groups"]) {
    for (const json& one : group["claims"]) found.push_back(one["href"]);
  }
  EXPECT_EQ(found, (std::vector<std::string>{"1-a/1.1-x.html#example-x", "1-a/1.1-x.html#example-x",
                                             "1-a/1.1-x.html", "1-a/1.1-x.html#one"}));
}

TEST_F(VerificationTest, ShowsFirstWhatIsNotProved) {
  Claim asserted = claim(Kind::formula, Status::asserted, 0, 4);
  asserted.reason = "r";
  const json page = data("$a$\n", {claim(Kind::formula, Status::proved, 0, 4), asserted});
  ASSERT_EQ(page["open"].size(), 1u);
  EXPECT_EQ(page["open"][0]["reason"], "r");
  EXPECT_EQ(page["open"][0]["id"], "");  // its entry is further down
  EXPECT_EQ(page["lessons"][0]["groups"][0]["claims"][1]["id"], "lesson-1-1-2");
  EXPECT_EQ(page["counts"].size(), 2u);
}

TEST_F(VerificationTest, SaysOnceWhatIsTrueOfAList) {
  const Claim one = claim(Kind::formula, Status::proved, 0, 4);
  json group = data("$a$\n", {one, one})["lessons"][0]["groups"][0];
  EXPECT_EQ(group["how"], "h");
  EXPECT_EQ(group["claims"][0]["how"], "");
  Claim failed = claim(Kind::formula, Status::failed, 0, 4);
  failed.how = "";
  EXPECT_EQ(data("$a$\n", {one, failed, one})["lessons"][0]["groups"][0]["how"], "h");
  Claim other = one;
  other.how = "otherwise";
  group = data("$a$\n", {one, other})["lessons"][0]["groups"][0];
  EXPECT_EQ(group["how"], "");
  EXPECT_EQ(group["claims"][1]["how"], "otherwise");
}

TEST_F(VerificationTest, CountsManyFormulasThatAreProved) {
  Claims claims(9, claim(Kind::formula, Status::proved, 0, 4));
  json group = data("$a$\n", claims)["lessons"][0]["groups"][0];
  EXPECT_EQ(group["counted"], 9);
  EXPECT_EQ(group["claims"].size(), 0u);
  claims.push_back(claim(Kind::formula, Status::failed, 0, 4));
  group = data("$a$\n", claims)["lessons"][0]["groups"][0];
  EXPECT_EQ(group["count"], 10);
  EXPECT_EQ(group["counted"], 9);
  ASSERT_EQ(group["claims"].size(), 1u);
  EXPECT_EQ(group["claims"][0]["id"], "lesson-1-1-10");
  claims[0].how = "otherwise";
  EXPECT_EQ(data("$a$\n", claims)["lessons"][0]["groups"][0]["claims"].size(), 10u);

  json lesson = data("$a$\n", Claims(9, claims[1]))["lessons"][0];
  EXPECT_NE(render_template(*templates_, "verified-lesson", lesson)
                .find("<p>9 of them; <a href=\"verification.json\">the JSON</a> has each with its "
                      "line and its key.</p>\n</details>"),
            std::string::npos);
}

TEST_F(VerificationTest, FoldsLongLists) {
  const Claim one = claim(Kind::value, Status::proved, 0, 4);
  EXPECT_EQ(data("$a$\n", Claims(8, one))["lessons"][0]["groups"][0]["open"], true);
  EXPECT_EQ(data("$a$\n", Claims(9, one))["lessons"][0]["groups"][0]["open"], false);
}

TEST_F(VerificationTest, ShowsMistakesAndPicturesInAReport) {
  Findings findings;
  findings.of_claim["lesson-1-1-1"] = {"wrong <here>"};
  findings.others = {"elsewhere"};
  findings.pictures = {{"p", "pictures/p-reference.png", "pictures/p-actual.png",
                        "pictures/p-difference.png", false}};
  json page = data("$a$\n", {claim(Kind::formula, Status::failed, 0, 4)}, false, findings);
  EXPECT_EQ(page["failed"][0]["href"], "");
  page["language"] = "en";
  page["right_to_left"] = false;
  page["assets"] = {{"css", "c"}, {"favicon", "f"}};
  const std::string html = render_template(*templates_, "report", page);
  EXPECT_NE(html.find("wrong &lt;here&gt;"), std::string::npos) << html;
  EXPECT_NE(html.find("<pre class=\"message\" tabindex=\"0\">elsewhere</pre>"), std::string::npos)
      << html;
  EXPECT_NE(html.find("<img src=\"pictures/p-difference.png\""), std::string::npos) << html;
}

TEST_F(VerificationTest, LeavesOutDrafts) {
  writer("$a$\n");
  course_.lessons[0].front.draft = true;
  evaluation_.lessons.resize(2);
  evaluation_.lessons[0].claims = {claim(Kind::formula, Status::proved, 0, 4)};
  const json published = published_verification(course_, evaluation_);
  EXPECT_EQ(published["lessons"].size(), 1u);
  EXPECT_EQ(published["counts"]["proved"], 0);
  const json full = full_verification(&course_, evaluation_, 1.23456);
  EXPECT_EQ(full["lessons"].size(), 2u);
  EXPECT_EQ(full["lessons"][0]["claims"][0]["page"], "");
  EXPECT_EQ(full["seconds"], 1.235);
}

TEST_F(VerificationTest, IsReachedFromTheAnswersOfTheLesson) {
  const std::string quiz =
      "$a$\n\n```quiz\n{\"id\": \"1.1-q\", \"questions\": [{\"kind\": \"numeric\", \"q\": \"Q\", "
      "\"answer\": 1, \"explain\": \"x\"}]}\n```\n";
  EXPECT_EQ(body(quiz).find("verification.html"), std::string::npos);
  results_.claims = {claim(Kind::formula, Status::proved, 0, 4),
                     claim(Kind::answer, Status::proved, 1, 7)};
  results_.of_block[1] = QuizResult{{QuestionResult{.proved = true, .proofs = {}, .because = ""}}};
  EXPECT_NE(body(quiz).find("<a href=\"../verification.html#lesson-1-1-2\">"), std::string::npos);
}

}  // namespace
}  // namespace mjcourse

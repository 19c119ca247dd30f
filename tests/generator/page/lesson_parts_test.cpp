// What a lesson gives to the pages of what its reader's browser remembers.
#include "page/lesson_parts.h"

#include "page/page_fixture.h"

namespace mjcourse {
namespace {

using nlohmann::json;

constexpr const char* kQuiz =
    "```quiz\n{\"id\": \"q.1\", \"questions\": ["
    "{\"kind\": \"numeric\", \"q\": \"See [two](1.2).\", \"answer\": 4, \"tol\": 0.5},"
    "{\"kind\": \"mcq\", \"q\": \"<?\", \"options\": [\"a\", \"b\"], \"answer\": 1}]}\n```\n";

class LessonPartsTest : public PageWriterTest {
 protected:
  // What a lesson with this body asks, for a page at the site's root.
  json questions(const std::string& body) {
    writer(body);
    return PageWriter(course_, course_.lessons[0], results_,
                      {*templates_, *highlighter_, manifest_, styles_, "review.html"})
        .questions();
  }
};

TEST_F(LessonPartsTest, HasTheQuestionsForTheReview) {
  const json asked = questions("Text.\n\n" + std::string(kQuiz));
  const json review = json::parse(review_json(course_.lessons[0], {asked}, *templates_));
  EXPECT_EQ(review["href"], "1-a/1.1-x.html");
  EXPECT_EQ(review["name"], "1.1 T");
  ASSERT_EQ(review["questions"].size(), 2u);
  EXPECT_EQ(review["questions"][1]["id"], "quiz-q-1-2");
  const std::string html = review["questions"][0]["html"];
  EXPECT_TRUE(html.starts_with("<form class=\"question\" id=\"quiz-q-1-1\"")) << html;
  EXPECT_NE(html.find("See <a href=\"1-a/1.2-y.html\">two</a>."), html.npos) << html;
}

TEST_F(LessonPartsTest, HasNothingForTheReviewWhereNothingIsAsked) {
  const json none = questions("Text.\n");
  EXPECT_EQ(review_json(course_.lessons[0], {none}, *templates_), "");
}

TEST_F(LessonPartsTest, TellsTheTableOfProgressWhatIsRight) {
  const json asked = questions(kQuiz);
  const std::string row = progress_row(course_.lessons[0], {asked}, *templates_);
  EXPECT_TRUE(row.starts_with("<tr data-lesson=\"1-a/1.1-x.html\">")) << row;
  EXPECT_NE(row.find("<span data-id=\"quiz-q-1-1\" data-kind=\"numeric\" data-key=\"4\" "
                     "data-tolerance=\"0.5\"></span>"
                     "<span data-id=\"quiz-q-1-2\" data-kind=\"mcq\" data-key=\"B\""),
            row.npos)
      << row;
}

}  // namespace
}  // namespace mjcourse

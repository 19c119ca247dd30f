#include <gtest/gtest.h>

#include "cli/on_a_course.h"
#include "cli/ran.h"

namespace mjcourse {
namespace {

TEST(Explain, ExplainsAMessageByItsName) {
  const Ran result = ran({"explain", "W-lesson-unlisted", "E-lesson-number"});
  EXPECT_EQ(result.code, kClean);
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.out,
            "warning W-lesson-unlisted\n"
            "\n"
            "  A file is in the folder of a level, but `content/course.yaml` does not list it. It "
            "is not in the\n"
            "  site, and nothing in it is checked, perhaps contrary to what you expect. List it. "
            "If you are still\n"
            "  working on it, put `draft: true` in its front matter: the lesson then stays out of "
            "the site but is\n"
            "  checked all the same.\n"
            "\n"
            "  wrong: `lessons: [1.1-lesson]` beside a file `1.2-more.md`\n"
            "  right: `lessons: [1.1-lesson, 1.2-more]`\n"
            "\n"
            "error E-lesson-number\n"
            "\n"
            "  Two lessons of the course have the same number, so a link to it would be ambiguous. "
            "Give one of\n"
            "  them another number.\n"
            "\n"
            "  wrong: `1.2-state.md` and `1.2-joints.md`\n"
            "  right: `1.2-state.md` and `1.3-joints.md`\n");
}

TEST(Explain, KnowsWhichMessagesThereAre) {
  const auto refused = [](const std::vector<std::string>& arguments) {
    const Ran result = ran(arguments);
    EXPECT_EQ(result.code, kWrongUsage);
    EXPECT_EQ(result.out, "");
    return result.err;
  };
  EXPECT_EQ(refused({"explain", "E-output-difers"}),
            "mjcourse: there is no message E-output-difers; did you mean `E-output-differs`?\n");
  EXPECT_EQ(refused({"explain", "E-frobnicate"}),
            "mjcourse: there is no message E-frobnicate; lesson A.9 of the author guide has them "
            "all\n");
  EXPECT_EQ(refused({"explain", "E-output-differs", "1.2"}),
            "mjcourse: explain takes the names of messages or places in the course, not both\n");
}

class ExplainACourse : public OnACourse {};

// What a course names may hold any character; a terminal obeys some, and a line feed forges a line.
TEST_F(ExplainACourse, ShowsItsWordsAsTheyStand) {
  write(
      "content/1-a/1.1-x.md",
      "---\ntitle: First\n---\n## A part\n\n```quiz\n"
      R"({"id": "a\n0 errors\u001b]0;t\u0007\u202e", "questions": [{"kind": "numeric", "q": "x", )"
      R"("answer": 1, "verify": [{"joints": {"hinge": 1}, "value": "model.nq"}]}]})"
      "\n```\n");
  const std::string words = R"(prove the answers of a\n0 errors\x1b]0;t\x07\u202e)";
  const std::string store = (folder_.path() / "store").string();
  const Ran explained = on_course({"explain", "--store", store});
  EXPECT_EQ(explained.out, "content/1-a/1.1-x.md:7: " + words +
                               ": to be done\n  was never evaluated here\n1 task, 0 kept\n");
  const Ran checked = on_course({"check", "--timings", "--store", store});
  EXPECT_NE(checked.out.find("  " + words + "\n"), std::string::npos) << checked.out << checked.err;
}

}  // namespace
}  // namespace mjcourse

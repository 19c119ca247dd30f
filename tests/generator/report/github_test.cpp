#include "report/github.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

TEST(Github, AnnotatesTheLine) {
  Diagnostic error = error_at({"content/1.1.md", 41, 34, 9, "…"}, "E-script-name",
                              "data.qpso does not exist", "did you mean `data.qpos`?");
  error.detail = "first\nsecond\n\n";
  EXPECT_EQ(github_annotations({error}, "."),
            "::error file=content/1.1.md,line=41,col=34,endColumn=43,title=E-script-name::"
            "data.qpso does not exist%0Afirst%0Asecond%0Acure: did you mean `data.qpos`?\n");
}

TEST(Github, EscapesWhatWouldEndAMessageOrAProperty) {
  Diagnostic warning = error_at({"a,b:c%.md", 0, 0, 1, ""}, "W-x", "100 %, and: more");
  warning.severity = Severity::warning;
  EXPECT_EQ(github_annotations({warning}, "docs/course"),
            "::warning file=docs/course/a%2Cb%3Ac%25.md,title=W-x::100 %25, and: more\n");
}

TEST(Github, NamesAFileOfAnyNameInOneLine) {
  const Diagnostic error = error_at({"a\033[31m\n::b.md", 0, 0, 1, ""}, "E-x", "m");
  EXPECT_EQ(github_annotations({error}, "."),
            "::error file=a\\x1b[31m\\n%3A%3Ab.md,title=E-x::m\n");
}

TEST(Github, SaysNothingOfNothing) {
  EXPECT_EQ(github_annotations({}, "."), "");
}

}  // namespace
}  // namespace mjcourse

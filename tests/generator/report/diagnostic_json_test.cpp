#include "report/diagnostic_json.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

TEST(DiagnosticJson, HasAllThatATerminalShows) {
  Diagnostic one = error_at({"content/a.md", 3, 2, 4, "a line"}, "E-x", "wrong", "mend it");
  one.detail = "-1\n+2\n";
  one.notes = {{"see here", {"models/m.xml", 7, 1, 2, "<b/>"}}};
  EXPECT_EQ(json_of(one), nlohmann::json::parse(R"({
    "id": "E-x", "severity": "error", "message": "wrong", "detail": "-1\n+2\n", "cure": "mend it",
    "place": {"file": "content/a.md", "line": 3, "column": 2, "width": 4, "excerpt": "a line"},
    "notes": [{"message": "see here",
      "place": {"file": "models/m.xml", "line": 7, "column": 1, "width": 2, "excerpt": "<b/>"}}]
  })"));
}

TEST(DiagnosticJson, OfAWarningAboutAFileHasTheSameKeys) {
  Diagnostic one = error_at({"content/a.md", 0, 0, 1, ""}, "W-x", "doubtful");
  one.severity = Severity::warning;
  EXPECT_EQ(json_of(one), nlohmann::json::parse(R"({
    "id": "W-x", "severity": "warning", "message": "doubtful", "detail": "", "cure": "",
    "place": {"file": "content/a.md", "line": 0, "column": 0, "width": 1, "excerpt": ""},
    "notes": []
  })"));
}

}  // namespace
}  // namespace mjcourse

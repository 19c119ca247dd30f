#include "lsp/editor_diagnostics.h"

#include <gtest/gtest.h>

#include <sstream>

#include "lsp/messages.h"

namespace mjcourse {
namespace {

using nlohmann::json;

std::string text_of(const TextRange& range) {
  const auto text = [](const TextPoint& at) {
    return std::to_string(at.line) + ":" + std::to_string(at.unit);
  };
  return text(range.begin) + "-" + text(range.end);
}

Diagnostic mistake_in(const std::string& file, const std::string& message = "wrong") {
  return error_at({file, 3, 2, 2, "a😀öz"}, "E-x", message);
}

TEST(EditorDiagnostics, StandWhereTheEditorCountsThem) {
  const Place place{"a.md", 3, 2, 2, "a😀öz"};
  EXPECT_EQ(text_of(range_of(place, Units::utf16)), "2:1-2:4");
  EXPECT_EQ(text_of(range_of(place, Units::utf8)), "2:1-2:7");
}

TEST(EditorDiagnostics, OfAWholeFileStandAtItsBeginning) {
  EXPECT_EQ(text_of(range_of({"a.md", 0, 0, 1, ""}, Units::utf16)), "0:0-0:0");
}

TEST(EditorDiagnostics, OfALongLineStandBehindWhatWasCutOff) {
  EXPECT_EQ(text_of(range_of({"a.md", 1, 1002, 3, "xyöabc", 1000}, Units::utf8)), "0:1001-0:1005");
}

TEST(EditorDiagnostics, EndWithTheirLine) {
  EXPECT_EQ(text_of(range_of({"a.md", 1, 3, 50, "abcd"}, Units::utf16)), "0:2-0:4");
}

TEST(EditorDiagnostics, AreShownInAFileWhateverTheyBelongTo) {
  EXPECT_EQ(file_of(mistake_in("content/a.md")), "content/a.md");
  EXPECT_EQ(file_of(mistake_in("")), "content/course.yaml");
}

TEST(EditorDiagnostics, SayAllInOneText) {
  const OpenDocuments documents("/c");
  Diagnostic mistake = mistake_in("a.md");
  mistake.detail = "line 1\nline 2";
  mistake.notes = {{"more of it", {}}, {"over there", {"b.md", 2, 1, 1, "xy"}}};
  mistake.cure = "do this";
  EXPECT_EQ(json_of(mistake, documents, Units::utf16), json::parse(R"({
    "code": "E-x",
    "message": "wrong\nline 1\nline 2\nnote: more of it\ncure: do this",
    "range": {"start": {"line": 2, "character": 1}, "end": {"line": 2, "character": 4}},
    "relatedInformation": [{
      "location": {
        "uri": "file:///c/b.md",
        "range": {"start": {"line": 1, "character": 0}, "end": {"line": 1, "character": 1}}
      },
      "message": "over there"
    }],
    "severity": 1,
    "source": "mjcourse"
  })"));
}

TEST(EditorDiagnostics, OfAWarningWithoutMoreAreShort) {
  Diagnostic doubt = mistake_in("a.md");
  doubt.severity = Severity::warning;
  const json one = json_of(doubt, OpenDocuments("/c"), Units::utf16);
  EXPECT_EQ(one.at("severity"), 2);
  EXPECT_EQ(one.at("message"), "wrong");
  EXPECT_FALSE(one.contains("relatedInformation"));
}

class PublishedTest : public testing::Test {
 protected:
  // What is said of each file: "a.md: wrong, wrong; b.md: ;"
  std::string published(const Diagnostics& diagnostics) {
    diagnostics_.publish(diagnostics, Units::utf16);
    std::string all;
    while (const auto body = read_message(out_)) {
      const json message = json::parse(*body);
      EXPECT_EQ(message.at("method"), "textDocument/publishDiagnostics");
      const json& params = message.at("params");
      all += params.at("uri").get<std::string>().substr(std::string("file:///c/").size()) + ":";
      for (const json& one : params.at("diagnostics")) {
        all += " " + one.at("message").get<std::string>();
      }
      all += "; ";
    }
    out_.clear();
    return all;
  }

  std::stringstream out_;
  Connection connection_{out_};
  OpenDocuments documents_{"/c"};
  EditorDiagnostics diagnostics_{documents_, connection_};
};

TEST_F(PublishedTest, GoWhenTheyAreMendedAndOnlyOnce) {
  EXPECT_EQ(published({mistake_in("b.md", "one"), mistake_in("a.md", "two"),
                       mistake_in("b.md", "three")}),
            "a.md: two; b.md: one three; ");
  EXPECT_EQ(published({mistake_in("a.md", "two")}), "a.md: two; b.md:; ");
  EXPECT_EQ(published({}), "a.md:; ");
  EXPECT_EQ(published({}), "");
}

TEST_F(PublishedTest, TellOfAnOpenFileThatNothingIsWrong) {
  documents_.open("a.md", "typed");
  EXPECT_EQ(published({}), "a.md:; ");
  EXPECT_EQ(published({}), "a.md:; ");
}

}  // namespace
}  // namespace mjcourse

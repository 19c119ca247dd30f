#include "lsp/accept_action.h"

#include <gtest/gtest.h>

#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

using nlohmann::json;

constexpr const char* kFile = "content/1-a/1.1-x.md";

// A lesson of three lines, in the second of which an output differs.
class AcceptActionTest : public testing::Test {
 protected:
  AcceptActionTest() { write_file(folder_.path() / kFile, "one\ntwo\nthree\n"); }

  Diagnostic mistake(const std::optional<Edit>& edit, int line = 2) const {
    Diagnostic one = error_at({kFile, line, 1, 3, "two"}, "E-output-differs", "differs");
    one.edit = edit;
    return one;
  }
  Edit edit() const {
    return {kFile, Span{4, 7}, "2\nnew", "the output of x", "one\ntwo\nthree\n"};
  }

  json actions(const Diagnostics& diagnostics, int first = 1, int last = 1) const {
    Snapshot snapshot;
    snapshot.diagnostics = diagnostics;
    return accept_actions(snapshot, documents_, kFile, {{first, 0}, {last, 0}}, Units::utf16);
  }
  std::string uri(const std::string& file) const { return documents_.uri_of(file); }

  TemporaryFolder folder_;
  OpenDocuments documents_{folder_.path()};
};

TEST_F(AcceptActionTest, WritesTheLinesThatDiffer) {
  const json all = actions({mistake(edit())});
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].at("title"), "Accept the output of x");
  EXPECT_EQ(all[0].at("kind"), "quickfix");
  EXPECT_EQ(all[0].at("diagnostics").at(0).at("code"), "E-output-differs");
  EXPECT_EQ(all[0].at("edit"), (json{{"changes",
                                      {{uri(kFile),
                                        {{{"range",
                                           {{"start", {{"line", 1}, {"character", 0}}},
                                            {"end", {{"line", 1}, {"character", 3}}}}},
                                          {"newText", "2\nnew"}}}}}}}));
}

TEST_F(AcceptActionTest, MakesAFileThatIsNotThere) {
  const json all = actions({mistake(Edit{"examples/x.cpp", {}, "int x;\n", "the program"})});
  ASSERT_EQ(all.size(), 1U);
  const json& changes = all[0].at("edit").at("documentChanges");
  EXPECT_EQ(changes.at(0), (json{{"kind", "create"}, {"uri", uri("examples/x.cpp")}}));
  EXPECT_EQ(changes.at(1).at("edits").at(0).at("newText"), "int x;\n");
}

TEST_F(AcceptActionTest, IsOfferedOnTheLinesThatWereAskedFor) {
  EXPECT_EQ(actions({mistake(edit())}, 0, 2).size(), 1U);
  EXPECT_EQ(actions({mistake(edit())}, 0, 0).size(), 0U);
  EXPECT_EQ(actions({mistake(edit())}, 2, 9).size(), 0U);
}

TEST_F(AcceptActionTest, IsNotOfferedWhereNothingCanBeDone) {
  EXPECT_EQ(actions({mistake(std::nullopt)}), json::array());
  const Edit picture{"content/1-a/pictures/x.png", {}, std::string("\x89PNG\0", 5), "the picture"};
  EXPECT_EQ(actions({mistake(picture)}), json::array());
}

// What was computed belongs to the text as it was.
TEST_F(AcceptActionTest, IsNotOfferedOfATextThatChangedMeanwhile) {
  documents_.open(kFile, "one\nTWO\nthree\n");
  EXPECT_EQ(actions({mistake(edit())}), json::array());
  documents_.close(kFile);
  EXPECT_EQ(actions({mistake(edit())}).size(), 1U);
  write_file(folder_.path() / kFile, "one\n");
  EXPECT_EQ(actions({mistake(edit())}), json::array());
}

}  // namespace
}  // namespace mjcourse

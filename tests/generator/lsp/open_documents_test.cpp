#include "lsp/open_documents.h"

#include <gtest/gtest.h>

#include "base/temporary_folder.h"
#include "lsp/file_uri.h"

namespace mjcourse {
namespace {

class OpenDocumentsTest : public testing::Test {
 protected:
  OpenDocumentsTest() { write_file(folder_.path() / "content/a.md", "saved"); }

  TemporaryFolder folder_;
  OpenDocuments documents_{folder_.path()};
};

TEST_F(OpenDocumentsTest, StandInForWhatIsSaved) {
  EXPECT_EQ(documents_.read("content/a.md"), "saved");
  documents_.open("content/a.md", "typed");
  documents_.open("content/b.md", "new");
  EXPECT_EQ(documents_.read("content/a.md"), "typed");
  EXPECT_TRUE(documents_.exists("content/b.md"));
  EXPECT_EQ(documents_.list("content"), (std::vector<std::string>{"a.md", "b.md"}));
  documents_.close("content/a.md");
  documents_.close("content/b.md");
  EXPECT_EQ(documents_.read("content/a.md"), "saved");
  EXPECT_FALSE(documents_.exists("content/b.md"));
}

TEST_F(OpenDocumentsTest, ChangeOneAfterTheOther) {
  documents_.open("content/a.md", "one\ntwo\n");
  documents_.change("content/a.md",
                    {{TextRange{{1, 0}, {1, 3}}, "2"}, {TextRange{{1, 1}, {2, 0}}, "😀!\n"}},
                    Units::utf16);
  EXPECT_EQ(documents_.read("content/a.md"), "one\n2😀!\n");
  documents_.change("content/a.md", {{TextRange{{1, 3}, {1, 4}}, "?"}}, Units::utf16);
  EXPECT_EQ(documents_.read("content/a.md"), "one\n2😀?\n");
  documents_.change("content/a.md", {{std::nullopt, "all"}}, Units::utf16);
  EXPECT_EQ(documents_.read("content/a.md"), "all");
  documents_.change("content/closed.md", {{std::nullopt, "all"}}, Units::utf16);
  EXPECT_FALSE(documents_.exists("content/closed.md"));
}

TEST_F(OpenDocumentsTest, KnowWhatIsOfTheCourse) {
  const auto name = [&](const std::string& path) {
    return documents_.name_of(uri_of(folder_.path() / path));
  };
  EXPECT_EQ(name("content/a.md"), "content/a.md");
  EXPECT_EQ(name("content/new.md"), "content/new.md");
  EXPECT_EQ(name("../a.md"), std::nullopt);
  EXPECT_EQ(name(""), std::nullopt);
  EXPECT_EQ(documents_.name_of("untitled:1"), std::nullopt);
}

TEST_F(OpenDocumentsTest, AreNamedAsTheEditorNamesThem) {
  const std::filesystem::path link = folder_.path() / "link";
  std::filesystem::create_directory_symlink(folder_.path() / "content", link);
  const OpenDocuments linked(link);
  EXPECT_EQ(linked.name_of(uri_of(link / "a.md")), "a.md");
  EXPECT_EQ(linked.name_of(uri_of(folder_.path() / "content/a.md")), "a.md");
  EXPECT_EQ(linked.uri_of("a.md"), uri_of(link / "a.md"));
}

}  // namespace
}  // namespace mjcourse

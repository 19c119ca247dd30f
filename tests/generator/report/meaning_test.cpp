#include "report/meaning.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>

#include "base/files.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

// The ids that stand in quotes in the sources below `folder`.
Names ids_in(const fs::path& folder) {
  const std::regex id("\"([EW]-[a-z0-9-]+)\"");
  const DiskFiles files(folder);
  Names ids;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const std::string kind = entry.path().extension();
    if (kind != ".cpp" && kind != ".h" && kind != ".ts") continue;
    const std::string text = files.read(entry.path().lexically_relative(folder)).value();
    for (auto at = std::sregex_iterator(text.begin(), text.end(), id); at != std::sregex_iterator();
         ++at) {
      ids.insert((*at)[1]);
    }
  }
  return ids;
}

Names ids_of_meanings() {
  Names ids;
  for (const Meaning& meaning : meanings()) ids.emplace(meaning.id);
  return ids;
}

TEST(Meaning, IsThereForEachIdOfTheSourcesAndForNoOther) {
  Names said;
  for (const char* folder : {"generator", "site/press/script", "site/browser/engine"}) {
    said.merge(ids_in(fs::path(MJCOURSE_ROOT) / folder));
  }
  EXPECT_GT(said.size(), 100u);
  EXPECT_EQ(ids_of_meanings(), said);
  EXPECT_EQ(meanings().size(), said.size()) << "one of them stands twice";
}

TEST(Meaning, EndsWithWhatIsWrongAndWhatIsRight) {
  for (const Meaning& meaning : meanings()) {
    EXPECT_TRUE(
        std::regex_match(std::string(meaning.text),
                         std::regex("(?:[A-Z`][^\n]*\\.\n\n)+- wrong: [^\n]+\n- right: [^\n]+")))
        << meaning.id << ":\n"
        << meaning.text;
  }
}

// Code is shown as it stands.
TEST(Meaning, HasNoMarksLeftInATerminal) {
  const std::regex marks("\\]\\([A-Z#]|</?code>|\\*\\*");
  for (const Meaning& meaning : meanings()) {
    const std::string text =
        std::regex_replace(plain_text_of(meaning), std::regex("`[^`\n]+`"), "`…`");
    EXPECT_FALSE(std::regex_search(text, marks)) << text;
  }
}

const char* const kPage =
    "---\ntitle: T\n---\n\n## One\n\n### E-a\n\nIt is *so*. See [tables](A.3#tables), [A.2](A.2) "
    "and [above](#one).\n\nMore.\n\n- wrong: `` ```sh `` or `[x](y)`\n- right: <code>{m} x</code>\n"
    "\n## Two\n\nText.\n\n### W-b\n\nIt is.\n";

TEST(Meaning, IsASectionOfThePage) {
  const std::vector<Meaning> two = read_meanings(kPage);
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two[0].id, "E-a");
  EXPECT_TRUE(two[0].text.starts_with("It is *so*.")) << two[0].text;
  EXPECT_TRUE(two[0].text.ends_with("x</code>")) << two[0].text;
  EXPECT_EQ(two[1].id, "W-b");
  EXPECT_EQ(two[1].text, "It is.");
}

TEST(Meaning, IsPlainTextWithoutMarks) {
  EXPECT_EQ(plain_text_of(read_meanings(kPage)[0]),
            "It is *so*. See tables (A.3), A.2 and above.\n"
            "More.\n"
            "wrong: ```sh or `[x](y)`\n"
            "right: `{m} x`\n");
}

TEST(Meaning, IsSetForATerminal) {
  TerminalStyle style;
  style.width = 30;
  EXPECT_EQ(format_for_terminal(read_meanings(kPage)[0], style),
            "error E-a\n"
            "\n"
            "  It is *so*. See tables\n"
            "  (A.3), A.2 and above.\n"
            "\n"
            "  More.\n"
            "\n"
            "  wrong: ```sh or `[x](y)`\n"
            "  right: `{m} x`\n");
  style.colours = true;
  EXPECT_EQ(format_for_terminal(read_meanings(kPage)[1], style),
            "\033[1;33mwarning \033[0m\033[1mW-b\033[0m\n"
            "\n"
            "  It is.\n");
}

TEST(Meaning, IsFoundByItsId) {
  ASSERT_NE(meaning_of("E-output-differs"), nullptr);
  EXPECT_EQ(meaning_of("E-output-differs")->id, "E-output-differs");
  EXPECT_EQ(meaning_of("E-output"), nullptr);
  EXPECT_TRUE(is_like_id("E-output"));
  EXPECT_FALSE(is_like_id("1.2"));
}

}  // namespace
}  // namespace mjcourse

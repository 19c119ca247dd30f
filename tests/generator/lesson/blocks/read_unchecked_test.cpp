#include "lesson/blocks/read_unchecked.h"

#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

TEST(ReadUnchecked, TakesCodeThatNobodyRuns) {
  const ReadingOf reading = reading_of("```cpp unchecked because=\"needs a GPU\"\nx;\n```\n");
  EXPECT_EQ(reading.mistakes(), "");
  const auto& unchecked = reading.only<Unchecked>();
  EXPECT_EQ(unchecked.code.text, "x;\n");
  EXPECT_EQ(unchecked.language, "cpp");
  EXPECT_EQ(unchecked.because, "needs a GPU");
  EXPECT_EQ(reading.place(unchecked.span), "4:1");
}

TEST(ReadUnchecked, TakesEveryLanguageAndNoReason) {
  std::vector<std::string> languages = unchecked_languages();
  languages.insert(languages.end(), {"cpp", "xml", "text"});
  for (const std::string& language : languages) {
    const ReadingOf reading = reading_of("```" + language + " unchecked\nx\n```\n");
    EXPECT_EQ(reading.mistakes(), "");
    EXPECT_EQ(reading.only<Unchecked>().language, language);
    EXPECT_EQ(reading.only<Unchecked>().because, "");
  }
}

TEST(ReadUnchecked, BelongsToNoProgram) {
  EXPECT_EQ(underlined_mistakes(reading_of("```text unchecked\nx\n```\n\n```text\n1\n```\n")),
            "E-output-stray <```text> this output belongs to no program | put it right after a "
            "`cpp file=…`, `cpp snippet` or `sh run` fence, or name the example above: `text "
            "output=NAME`\n");
}

TEST(ReadUnchecked, MustBeSaid) {
  EXPECT_EQ(
      mistakes_in("```sh\nls\n```\n"),
      R"(content/1-a/1.1-x.md:4:1: error: a plain `sh` fence would show code that nobody ran [E-fence-kind]
  4 | ```sh
    | ^~~~~
  cure: let it run: `sh run`; or say that nobody does, and why: `sh unchecked because="…"`
)");
  EXPECT_EQ(
      underlined_mistakes(reading_of("```cmake\n#\n```\n")),
      "E-fence-kind <```cmake> a plain `cmake` fence would show code that nobody ran | say so, "
      "and why: `cmake unchecked because=\"…\"`\n");
}

}  // namespace
}  // namespace mjcourse

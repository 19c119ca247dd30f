// What a lesson may have no more of: reading says so, and ends soon whatever it is given.
#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

std::string times(int count, const std::string& text) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

constexpr const char* kTooManyParts =
    "a lesson has at most 10000 paragraphs, formulas, links and other parts in all "
    "[E-lesson-size]\n";

TEST(Bounds, OfATextAreOneMebibyte) {
  const std::string front = "---\ntitle: T\n---\n";
  const std::string most(std::size_t{1 << 20} - front.size(), 'a');
  EXPECT_EQ(mistakes_in(most), "");
  EXPECT_EQ(
      mistakes_in(most + "a"),
      R"(content/1-a/1.1-x.md: error: a text file may be at most 1 MiB, and this one has 1048577 bytes [E-text-size]
  cure: make several of it; a program, a model or a picture is a file of its own
)");
}

TEST(Bounds, OfPartsAreTenThousand) {
  // The document, and each paragraph with its formula.
  EXPECT_EQ(mistakes_in("a\n\n" + times(4998, "$x$\n\n") + "b\n"), "");
  EXPECT_EQ(mistakes_in("a\n\n" + times(4999, "$x$\n\n") + "b $y$\n"),
            "content/1-a/1.1-x.md:10004:1: error: " + std::string(kTooManyParts) +
                "  10004 | b $y$\n        | ^\n  cure: make several of it\n");
}

TEST(Bounds, OfPartsHoldForTermsFragmentsAndDemosTogether) {
  for (const std::string& body :
       {times(50'000, "[[a|b]] "), times(60'000, "`a` "), times(6000, "````demo\n$x$\n````\n\n"),
        "```io\n" + times(12'000, "INPUT: $x$\n") + "```\n"}) {
    const ReadingOf reading = reading_of(body);
    ASSERT_EQ(reading.diagnostics.size(), 1U) << body.substr(0, 20);
    EXPECT_EQ(reading.diagnostics[0].id, "E-lesson-size") << body.substr(0, 20);
  }
}

TEST(Bounds, OfATable) {
  const auto table = [](int columns, int rows) {
    return times(columns, "|a") + "|\n" + times(columns, "|-") + "|\n" + times(rows, "|b|\n");
  };
  EXPECT_EQ(mistakes_in(table(200, 49)), "");
  const std::string refused =
      " error: a table has at most 200 columns, and all tables of a lesson 10000 cells "
      "[E-table-size]\n";
  const std::string cure =
      "  cure: show a part of it, or a plot; each row has a cell in each column\n";
  EXPECT_EQ(mistakes_in(table(100, 100) + "\n- - -\n"),
            "content/1-a/1.1-x.md:105:1:" + refused + "  105 | |b|\n      | ^\n" + cure);
  const ReadingOf wide = reading_of(table(201, 1));
  ASSERT_EQ(wide.diagnostics.size(), 1U);
  EXPECT_EQ(wide.diagnostics[0].id + " " + std::to_string(wide.diagnostics[0].place.line),
            "E-table-size 5");
  // A hundred million cells, of which nobody wrote any; and as many in many tables.
  EXPECT_EQ(reading_of(table(10'000, 10'000)).diagnostics[0].id, "E-table-size");
  EXPECT_EQ(reading_of(times(60, table(200, 1000) + "\n")).diagnostics[0].id, "E-table-size");
}

TEST(Bounds, OfWhatLinksCopy) {
  const std::string reference = "[a]: /b \"" + std::string(100'000, 'c') + "\"\n\n";
  EXPECT_EQ(mistakes_in(reference + times(100, "[a]\n")), "");
  const ReadingOf reading = reading_of("x\n\n" + reference + times(1000, "[a]\n"));
  ASSERT_EQ(reading.diagnostics.size(), 1U);
  const Diagnostic& refused = reading.diagnostics[0];
  EXPECT_EQ(refused.id + " " + std::to_string(refused.place.line), "E-reference-size 6");
  EXPECT_EQ(refused.message, "this reference with all links that may name it is more than 64 MiB");
  EXPECT_EQ(refused.cure, "end it with an empty line, and give it a shorter address");
  EXPECT_TRUE(reading.lesson->links.empty());
  // In a quote, in a list, and over several lines.
  for (const std::string& mark : {"> ", "- ", "> 1. "}) {
    const std::string quoted = mark + "[a]: /b \"" + times(5000, "cccccccccccccccccccc\n");
    EXPECT_EQ(reading_of(quoted + "\"\n\n" + times(1000, "[a]\n")).diagnostics[0].id,
              "E-reference-size")
        << mark;
  }
}

TEST(Bounds, OfWhatIsToldOfAFile) {
  const ReadingOf reading = reading_of(times(3000, "[[a|\n"));
  ASSERT_EQ(reading.diagnostics.size(), 1000U);
  EXPECT_EQ(reading.diagnostics[998].id, "E-term-unclosed");
  EXPECT_EQ(
      shown({reading.diagnostics[999]}),
      R"(content/1-a/1.1-x.md:1003:1: error: this file has a thousand mistakes or more; those from here on are not reported [E-mistakes]
  1003 | [[a|
       | ^~
  cure: fix the first ones: others often follow from them
)");
}

// Each of these took minutes once, as all that follows was read again for each.
TEST(Bounds, AreNotReachedByWhatIsReadOnce) {
  const auto read = [](const std::string& body) { reading_of(body); };
  read(times(200'000, "[[a|"));
  read(times(130'000, "[[a|b]] "));
  read(times(200'000, "["));
  read(times(200'000, "!["));
  read(times(200'000, "[a]("));
  read(times(250'000, "<"));
  read(times(250'000, "$a "));
  read(times(200'000, "$$a "));
  read(times(200'000, "${a "));
  read(times(200'000, "[a](b 'c') [a](b c"));
  read(times(150'000, "\\(a [^"));
  read(times(90'000, "[^a]: b\n"));
  read("<div>\n" + times(100'000, "<b>") + times(100'000, "</i>") + times(100'000, "`` [a]"));
  read(times(100'000, "## a\n\n"));
  read(times(200'000, "`a\nb` "));
  read(times(150'000, "[a](b) "));
  read("```lab simlab\n{" + times(100'000, "\"k\":1,") + "}\n```\n");
  std::string ticks;
  for (std::size_t i = 1; i < 1400; ++i) ticks += std::string(i, '`') + " ";
  read(ticks);
  std::string keys = "```lab simlab\n{\"k\":1";
  for (int i = 0; i < 80'000; ++i) keys += ",\"k" + std::to_string(i) + "\":1";
  read(keys + "}\n```\n");
  read(times(400'000, "\n") + times(20'000, "````demo\n$x$\n````\n\n"));
}

}  // namespace
}  // namespace mjcourse

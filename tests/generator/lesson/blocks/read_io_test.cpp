#include "lesson/blocks/read_io.h"

#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

TEST(Io, IsAPanelOfRows) {
  const ReadingOf reading = reading_of("```io\nINPUT: a\n  more $x$\nPROCESS:b\nOUTPUT:\n```\n");
  EXPECT_EQ(reading.mistakes(), "");
  std::string rows;
  for (const Io::Row& row : reading.only<Io>().rows) {
    rows += row.label + "=" + (row.text ? plain_text(row.text.get()) : "") + "\n";
  }
  EXPECT_EQ(rows, "INPUT=a more x\nPROCESS=b\nOUTPUT=\n");
  EXPECT_EQ(reading.place(reading.only<Math>().tex), "6:9");
}

TEST(Io, BeginsWithALabel) {
  EXPECT_EQ(
      mistakes_in("```io\na row\nINPUT: b\n```\n"),
      R"(content/1-a/1.1-x.md:5:1: error: this line has none of the labels of an `io` panel [E-io-label]
  5 | a row
    | ^~~~~
  cure: begin it with `INPUT:`, `PROCESS:` or `OUTPUT:`
)");
}

}  // namespace
}  // namespace mjcourse

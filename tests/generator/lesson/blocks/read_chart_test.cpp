#include "lesson/blocks/read_chart.h"

#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

ReadingOf chart_of(const std::string& data, const std::string& rest = R"(, "alt": "A line.")") {
  return reading_of("```plot\n{" + data + R"(, "caption": "It *falls*.")" + rest + "}\n```\n");
}

std::string mistakes_of(const std::string& data) {
  return underlined_mistakes(chart_of(data));
}

TEST(Chart, KnowsItsTableAndItsWords) {
  const ReadingOf reading = chart_of(R"("mark": "line", "data": {"name": "fall/energy"})");
  EXPECT_EQ(reading.mistakes(), "");
  const Chart& chart = reading.only<Chart>();
  EXPECT_EQ(chart.example.text, "fall");
  EXPECT_EQ(chart.table.text, "energy");
  EXPECT_EQ(reading.place(chart.table), "5:41");
  EXPECT_EQ(chart.alt, "A line.");
  EXPECT_EQ(plain_text(chart.caption.get()), "It falls.");
  EXPECT_EQ(chart.tree.members.front().key.text, "mark");
  EXPECT_EQ(chart.json.front(), '{');
}

TEST(Chart, ShowsWhatAnExampleReportedAlone) {
  const std::string cure = "write \"data\": {\"name\": \"EXAMPLE/TABLE\"}";
  EXPECT_EQ(mistakes_of(R"("mark": "line")"),
            "E-json-missing <{> this plot has no \"data\" | " + cure + "\n");
  for (const std::string name : {"energy", "/energy", "fall/"}) {
    EXPECT_EQ(
        mistakes_of(R"("data": {"name": ")" + name + "\"}"),
        "E-plot-data <" + name + "> this does not name a table of an example | " + cure + "\n");
  }
  EXPECT_EQ(mistakes_of(R"("data": {"url": "x.csv"})"),
            "E-plot-data <\"x.csv\"> a plot shows a table that an example of the course reported, "
            "and no other data | " +
                cure + "\n");
  EXPECT_EQ(mistakes_of(R"("data": {"nmae": "fall/energy"})"),
            "E-json-missing <{> this plot's data has no \"name\" | add \"name\": …\n"
            "E-json-key <nmae> a plot's data has no key \"nmae\" | did you mean `name`?\n");
}

TEST(Chart, IsKeptWithoutItsDataSoThatItsSpecIsLookedAt) {
  EXPECT_EQ(chart_of(R"("data": {"url": "x.csv"})").only<Chart>().example.text, "");
}

TEST(Chart, NeedsItsWords) {
  const std::string data = R"("data": {"name": "fall/energy"})";
  EXPECT_EQ(underlined_mistakes(chart_of(data, "")),
            "E-json-missing <{> this plot has no \"alt\" | add \"alt\": …\n");
  EXPECT_EQ(underlined_mistakes(chart_of(data, R"(, "alt": "")")),
            "E-json-missing <\"\"> \"alt\" is empty\n");
  EXPECT_EQ(underlined_mistakes(reading_of("```plot\n[]\n```\n")),
            "E-json-kind <[]> \"plot\" is a list; expected an object\n");
}

TEST(Chart, IsNumberedAmongItsKind) {
  const std::string chart =
      "```plot\n{\"data\": {\"name\": \"a/b\"}, \"caption\": \"$x$\", \"alt\": \"A.\"}\n```\n";
  const ReadingOf reading = reading_of(chart + "\n$y$\n\n" + chart);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < reading.lesson->blocks.size(); ++i) {
    names.push_back(block_name(*reading.lesson, i));
  }
  EXPECT_EQ(names, (std::vector<std::string>{"", "plot-1", "", "", "plot-2"}));
}

}  // namespace
}  // namespace mjcourse

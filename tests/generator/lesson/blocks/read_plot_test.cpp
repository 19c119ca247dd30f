#include "lesson/blocks/read_plot.h"

#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

ReadingOf plot_of(const std::string& data, const std::string& rest = R"(, "alt": "A line.")") {
  return reading_of("```plot\n{" + data + R"(, "caption": "It *falls*.")" + rest + "}\n```\n");
}

std::string mistakes_of(const std::string& data) {
  return underlined_mistakes(plot_of(data));
}

TEST(Plot, KnowsItsTableAndItsWords) {
  const ReadingOf reading = plot_of(R"("mark": "line", "data": {"name": "fall/energy"})");
  EXPECT_EQ(reading.mistakes(), "");
  const Plot& plot = reading.only<Plot>();
  EXPECT_EQ(plot.example.text, "fall");
  EXPECT_EQ(plot.table.text, "energy");
  EXPECT_EQ(reading.place(plot.table), "5:41");
  EXPECT_EQ(plot.alt, "A line.");
  EXPECT_EQ(plain_text(plot.caption.get()), "It falls.");
  EXPECT_EQ(plot.tree.members.front().key.text, "mark");
  EXPECT_EQ(plot.json.front(), '{');
}

TEST(Plot, ShowsWhatAnExampleReportedAlone) {
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

TEST(Plot, IsKeptWithoutItsDataSoThatItsSpecIsLookedAt) {
  EXPECT_EQ(plot_of(R"("data": {"url": "x.csv"})").only<Plot>().example.text, "");
}

TEST(Plot, NeedsItsWords) {
  const std::string data = R"("data": {"name": "fall/energy"})";
  EXPECT_EQ(underlined_mistakes(plot_of(data, "")),
            "E-json-missing <{> this plot has no \"alt\" | add \"alt\": …\n");
  EXPECT_EQ(underlined_mistakes(plot_of(data, R"(, "alt": "")")),
            "E-json-missing <\"\"> \"alt\" is empty\n");
  EXPECT_EQ(underlined_mistakes(reading_of("```plot\n[]\n```\n")),
            "E-json-kind <[]> \"plot\" is a list; expected an object\n");
}

TEST(Plot, IsNumberedAmongItsKind) {
  const std::string plot =
      "```plot\n{\"data\": {\"name\": \"a/b\"}, \"caption\": \"$x$\", \"alt\": \"A.\"}\n```\n";
  const ReadingOf reading = reading_of(plot + "\n$y$\n\n" + plot);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < reading.lesson->blocks.size(); ++i) {
    names.push_back(block_name(*reading.lesson, i));
  }
  EXPECT_EQ(names, (std::vector<std::string>{"", "plot-1", "", "", "plot-2"}));
}

}  // namespace
}  // namespace mjcourse

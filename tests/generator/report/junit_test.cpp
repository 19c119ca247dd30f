#include "report/junit.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

TEST(Junit, CountsAndListsWhatWasLookedAt) {
  TestCase proved{"examples/a.cpp", 3, 0.25};
  TestCase open{"question 2", 9, 0};
  open.skipped = "asserted: \"by hand\"";
  TestCase wrong{"data.qpso does not exist", 41, 0};
  wrong.failure = "1.1.md:41: error: data.qpso < \x1b\n  41 | x\n";
  wrong.id = "E-script-name";
  EXPECT_EQ(
      junit_xml({{"1.1 One", "content/1.1.md", {proved, open, wrong}}, {"2", "b.md", {}}}, 1.5),
      R"(<?xml version="1.0" encoding="UTF-8"?>
<testsuites name="mjcourse" tests="3" failures="1" errors="0" skipped="1" time="1.500">
    <testsuite name="1.1 One" tests="3" failures="1" errors="0" skipped="1" time="0.250" file="content/1.1.md">
        <testcase classname="content/1.1.md" name="examples/a.cpp" file="content/1.1.md" line="3" time="0.250"/>
        <testcase classname="content/1.1.md" name="question 2" file="content/1.1.md" line="9" time="0.000">
            <skipped message="asserted: &quot;by hand&quot;"/>
        </testcase>
        <testcase classname="content/1.1.md" name="data.qpso does not exist" file="content/1.1.md" line="41" time="0.000">
            <failure type="E-script-name" message="data.qpso does not exist">1.1.md:41: error: data.qpso &lt; ?
  41 | x
</failure>
        </testcase>
    </testsuite>
    <testsuite name="2" tests="0" failures="0" errors="0" skipped="0" time="0.000" file="b.md"/>
</testsuites>
)");
}

// It may end in the log of a service that takes some lines for commands.
TEST(Junit, HasNoCommandAndNothingThatXmlHasNot) {
  TestCase wrong{"two\nlines \uFFFE\uFFFF", 1, 0};
  wrong.failure = "::error::a\n \t\u00A0::b\nstd::array ##[group]c";
  const std::string xml = junit_xml({{"1", "a.md", {wrong}}}, 1);
  EXPECT_NE(xml.find("name=\"two lines \uFFFD\uFFFD\""), xml.npos) << xml;
  EXPECT_NE(xml.find("\n \t\u00A0&#58;:b\nstd::array &#35;#[group]c"), xml.npos) << xml;
  EXPECT_EQ(xml.find("\n::"), xml.npos);
}

}  // namespace
}  // namespace mjcourse

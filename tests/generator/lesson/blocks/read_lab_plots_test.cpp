#include "lesson/blocks/read_lab_plots.h"

#include <gtest/gtest.h>

#include "lesson/lab_reading.h"

namespace mjcourse {
namespace {

TEST(Plots, HaveKeysOfTheirOwn) {
  EXPECT_EQ(lab_mistakes(R"("plots": [{"traces": [{"label": "t", "expr": "1", "digits": 3}]}])"),
            "E-json-key <digits> a trace has no key \"digits\" | known: label, expr\n");
}

TEST(Plots, ReadSomething) {
  EXPECT_EQ(lab_mistakes(R"("readouts": [{"label": "l"}], "plots": [{}])"),
            "E-json-missing <{> this readout has no \"expr\" | add \"expr\": …\n"
            "E-json-missing <{> this plot has no \"traces\" | add \"traces\": …\n");
  EXPECT_EQ(lab_mistakes(R"("plots": [{"traces": []}])"),
            "E-json-missing <[]> \"traces\" is empty | add a trace: {\"label\": …, \"expr\": …}\n");
}

TEST(Plots, HaveNoMoreTracesThanColours) {
  const std::string trace = R"({"label": "t", "expr": "1"}, )";
  const std::string four = trace + trace + trace + R"({"label": "t", "expr": "1"})";
  EXPECT_EQ(lab_mistakes("\"plots\": [{\"traces\": [" + four + "]}]"), "");
  EXPECT_EQ(
      lab_mistakes("\"plots\": [{\"traces\": [" + four + R"(, {"label": "five", "expr": "1"}]}])"),
      "E-lab-plot <five> a plot has colours for four traces | put the others into a plot of "
      "their own\n");
}

TEST(Plots, HaveEndsInOrder) {
  const std::string traces = R"("traces": [{"label": "t", "expr": "1"}])";
  EXPECT_EQ(lab_mistakes(R"("plots": [{"ymin": 1, "ymax": 1, )" + traces + "}]"),
            "E-json-range <1> \"ymax\" is the upper end of the plot: more than \"ymin\"\n");
  EXPECT_EQ(lab_mistakes(R"("plots": [{"window": 0, )" + traces + "}]"),
            "E-json-range <0> \"window\" is a number of seconds: from 0.1 to 1000\n");
}

TEST(Readouts, CountTheirDigits) {
  for (const std::string digits : {"1.5", "-1", "16"}) {
    EXPECT_EQ(
        lab_mistakes(R"("readouts": [{"label": "l", "expr": "1", "digits": )" + digits + "}]"),
        "E-json-range <" + digits +
            "> \"digits\" counts the digits after the point: a whole number from 0 to 15\n");
  }
}

}  // namespace
}  // namespace mjcourse

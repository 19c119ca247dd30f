#include "chart_press_fixture.h"

namespace mjcourse {
namespace {

TEST_F(ChartPressTest, DrawsForWideAndForNarrowScreens) {
  const ChartDrawings drawings = press_.draw(line(), table_, "plot-1").value();
  EXPECT_EQ(drawings.wide.width, 640);
  EXPECT_EQ(drawings.wide.height, 320);
  ASSERT_TRUE(drawings.narrow);
  EXPECT_EQ(drawings.narrow->width, 328);
  const std::string& svg = drawings.wide.svg;
  EXPECT_NE(svg.find("stroke=\"var(--data-1)\""), std::string::npos) << svg;
  EXPECT_NE(svg.find("font-family=\"var(--sans)\""), std::string::npos) << svg;
  EXPECT_NE(svg.find(">−1.0<"), std::string::npos) << svg;  // a minus, not a hyphen
  for (const char* foreign : {"<svg", "class=", "style=", "role=", "aria-"}) {
    EXPECT_EQ(svg.find(foreign), std::string::npos) << foreign << "\n" << svg;
  }
}

TEST_F(ChartPressTest, DrawsTheSameAgainWhateverCameBefore) {
  const std::string clipped =
      R"({"mark": {"type": "area", "clip": true, "color": {"gradient": "linear",
          "stops": [{"offset": 0, "color": "red"}, {"offset": 1, "color": "blue"}]}},
          "encoding": {"x": {"field": "x", "type": "quantitative"},
                       "y": {"field": "y", "type": "quantitative"}}})";
  const std::string first = press_.draw(clipped, table_, "plot-1").value().wide.svg;
  EXPECT_NE(first.find("id=\"plot-1-wide-clip"), std::string::npos) << first;
  EXPECT_NE(first.find("url(#plot-1-wide-gradient"), std::string::npos) << first;
  const std::string small = line(R"(, "width": 90, "height": 60)");
  for (int i = 0; i < 35; ++i) ASSERT_TRUE(press_.draw(small, table_, "plot-2"));
  EXPECT_EQ(press_.draw(clipped, table_, "plot-1").value().wide.svg, first);
}

TEST_F(ChartPressTest, LeavesTheSizeToAnAuthorWhoSaysIt) {
  const ChartDrawings drawings = press_.draw(line(R"(, "width": 200)"), table_, "plot-1").value();
  EXPECT_FALSE(drawings.narrow);
  EXPECT_GT(drawings.wide.width, 200);
  EXPECT_LT(drawings.wide.width, 300);
  EXPECT_EQ(faults(line(R"(, "width": 640)")),
            "E-plot-size [] this plot is 697 pixels wide, and the page has 640 for it | make its "
            "parts narrower, or its labels shorter\n");
}

TEST_F(ChartPressTest, TellsSeriesApartByMoreThanColour) {
  const std::string spec = line(R"(, "transform": [{"fold": ["y", "x"], "as": ["which", "y"]}])");
  const std::string coloured = R"("color": {"field": "which", "type": "nominal"}, "x":)";
  const std::string with_colour = std::string(spec).replace(spec.rfind("\"x\":"), 4, coloured);
  EXPECT_EQ(press_.draw(spec, table_, "p").value().wide.svg.find("stroke-dasharray"),
            std::string::npos);
  const std::string svg = press_.draw(with_colour, table_, "p").value().wide.svg;
  EXPECT_NE(svg.find("stroke-dasharray=\"9,4\""), std::string::npos) << svg;
  EXPECT_NE(svg.find("var(--data-2)"), std::string::npos) << svg;
}

TEST_F(ChartPressTest, WritesPowersOfTenAsPeopleDo) {
  const json small = table({0, 1}, {1e-7, 2e-7});
  const std::string spec = line("", R"(, "axis": {"format": "e", "values": [1e-7, 2e-7]})");
  const std::string svg = press_.draw(spec, small, "p").value().wide.svg;
  EXPECT_NE(svg.find("<tspan class=\"power\" dy=\"-0.4em\">−7</tspan>"), std::string::npos) << svg;
}

TEST_F(ChartPressTest, KnowsVegaLitesWords) {
  const std::string spec =
      R"({"mark": {"type": "lin", "opacity": "0.5"}, "encodng": {}, "config": {},
          "encoding": {"x": {"field": "x", "axis": {"tittle": "t"}},
                       "y": {"field": "y", "type": "quantative"}}})";
  const std::string expected =
      "E-plot-word [\"mark\",\"type\"] \"type\" cannot be \"lin\" | did you mean `line`?\n"
      "E-json-kind [\"mark\",\"opacity\"] \"opacity\" is a string; expected a number or an object\n"
      "E-json-key [\"encodng\"] key a plot has no key \"encodng\" | did you mean `encoding`?\n"
      "E-json-key [\"config\"] key a plot of a lesson cannot have \"config\" here: all plots look "
      "alike; set this at the mark, the axis or the legend | leave it out\n"
      "E-json-key [\"encoding\",\"x\",\"axis\",\"tittle\"] key \"axis\" has no key \"tittle\" | "
      "did "
      "you mean `title`?\n"
      "E-plot-word [\"encoding\",\"y\",\"type\"] \"type\" cannot be \"quantative\" | did you mean "
      "`quantitative`?\n";
  EXPECT_EQ(faults(spec), expected);
  EXPECT_EQ(faults(spec, nullptr), expected);  // nobody need know the table
}

TEST_F(ChartPressTest, KnowsTheColumns) {
  EXPECT_EQ(faults(line("", R"(, "sort": {"field": "yy"})")),
            "E-plot-field [\"encoding\",\"y\",\"sort\",\"field\"][0,2] the table has no column "
            "\"yy\", and no transform makes it | did you mean `y`?\n");
  EXPECT_EQ(faults(line(R"(, "transform": [{"calculate": "'é' + datum.energi", "as": "z"}])")),
            "E-plot-field [\"transform\",0,\"calculate\"][13,19] the table has no column "
            "\"energi\", and no transform makes it | known: x, y, z\n");
  EXPECT_EQ(faults(line(R"(, "transform": [{"fold": ["y", "v"]}])")),
            "E-plot-field [\"transform\",0,\"fold\",1][0,1] the table has no column \"v\", and no "
            "transform makes it | known: x, y, key, value\n");
}

TEST_F(ChartPressTest, RefusesWhatIsNoNumber) {
  const std::string take_logarithm = R"j({"calculate": "log(datum.x)", "as": "x"}])j";
  EXPECT_EQ(faults(line(R"(, "transform": [)" + take_logarithm)),
            "E-plot-finite [\"transform\",0,\"as\"] \"x\" is -Infinity in row 1 of what is drawn | "
            "leave such rows out by a filter before\n");
  EXPECT_EQ(faults(line(R"(, "transform": [{"filter": "datum.x > 0"}, )" + take_logarithm)), "");
}

TEST_F(ChartPressTest, RefusesToDrawNothing) {
  EXPECT_EQ(faults(line(R"(, "transform": [{"filter": "datum.x > 9"}])")),
            "E-plot-empty [] what this plot filters leaves no row to draw | look at its filters\n");
}

TEST_F(ChartPressTest, TurnsVegasDoubtsIntoFaults) {
  EXPECT_EQ(faults(line(R"(, "transform": [{"calculate": "datum.x +", "as": "z"}])")),
            "E-plot-spec [\"transform\",0,\"calculate\"] this is no expression: Unexpected end of "
            "input\n");
  EXPECT_EQ(faults(line(R"j(, "transform": [{"calculate": "logg(datum.x)", "as": "z"}])j")),
            "E-plot-spec [\"transform\",0,\"calculate\"] Unrecognized function: logg\n");
  EXPECT_EQ(faults(line("", R"(, "stack": "zero", "scale": {"type": "point"})")),
            "E-plot-spec [] Stack is applied to a non-linear scale (point).\n"
            "E-plot-spec [\"encoding\",\"y\",\"scale\",\"type\"] FieldDef does not work with "
            "\"point\" scale. We are using \"linear\" scale instead.\n");
}

TEST_F(ChartPressTest, HasColoursForFourSeries) {
  const json five = table({0, 1, 2, 3, 4}, {0, 1, 2, 3, 4});
  const std::string spec = R"({"mark": "point", "encoding": {
      "x": {"field": "x", "type": "quantitative"}, "color": {"field": "y", "type": "nominal"}}})";
  EXPECT_EQ(faults(spec, five),
            "E-plot-series [] this plot has 5 series, and colours for 4 | leave some out, or give "
            "each a part of its own by \"facet\"\n");
}

}  // namespace
}  // namespace mjcourse

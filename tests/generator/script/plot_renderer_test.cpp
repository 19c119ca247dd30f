#include "plot_renderer_fixture.h"

namespace mjcourse {
namespace {

TEST_F(PlotRendererTest, DrawsForWideAndForNarrowScreens) {
  const PlotDrawings drawings = renderer_.draw(line(), table_, "plot-1").value();
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

TEST_F(PlotRendererTest, DrawsTheSameAgainWhateverCameBefore) {
  const std::string clipped =
      R"({"mark": {"type": "area", "clip": true, "color": {"gradient": "linear",
          "stops": [{"offset": 0, "color": "red"}, {"offset": 1, "color": "blue"}]}},
          "encoding": {"x": {"field": "x", "type": "quantitative"},
                       "y": {"field": "y", "type": "quantitative"}}})";
  const std::string first = renderer_.draw(clipped, table_, "plot-1").value().wide.svg;
  EXPECT_NE(first.find("id=\"plot-1-wide-clip"), std::string::npos) << first;
  EXPECT_NE(first.find("url(#plot-1-wide-gradient"), std::string::npos) << first;
  const std::string small = line(R"(, "width": 90, "height": 60)");
  for (int i = 0; i < 35; ++i) ASSERT_TRUE(renderer_.draw(small, table_, "plot-2"));
  EXPECT_EQ(renderer_.draw(clipped, table_, "plot-1").value().wide.svg, first);
}

TEST_F(PlotRendererTest, LeavesTheSizeToAnAuthorWhoSaysIt) {
  const PlotDrawings drawings = renderer_.draw(line(R"(, "width": 200)"), table_, "plot-1").value();
  EXPECT_FALSE(drawings.narrow);
  EXPECT_GT(drawings.wide.width, 200);
  EXPECT_LT(drawings.wide.width, 300);
  EXPECT_EQ(faults(line(R"(, "width": 640)")),
            "E-plot-size [] this plot is 697 pixels wide, and the page has 640 for it | make its "
            "parts narrower, or its labels shorter\n");
}

TEST_F(PlotRendererTest, TellsSeriesApartByMoreThanColour) {
  const std::string spec = line(R"(, "transform": [{"fold": ["y", "x"], "as": ["which", "y"]}])");
  const std::string coloured = R"("color": {"field": "which", "type": "nominal"}, "x":)";
  const std::string with_colour = std::string(spec).replace(spec.rfind("\"x\":"), 4, coloured);
  EXPECT_EQ(renderer_.draw(spec, table_, "p").value().wide.svg.find("stroke-dasharray"),
            std::string::npos);
  const std::string svg = renderer_.draw(with_colour, table_, "p").value().wide.svg;
  EXPECT_NE(svg.find("stroke-dasharray=\"9,4\""), std::string::npos) << svg;
  EXPECT_NE(svg.find("var(--data-2)"), std::string::npos) << svg;
}

TEST_F(PlotRendererTest, WritesPowersOfTenAsPeopleDo) {
  const json small = table({0, 1}, {1e-7, 2e-7});
  const std::string spec = line("", R"(, "axis": {"format": "e", "values": [1e-7, 2e-7]})");
  const std::string svg = renderer_.draw(spec, small, "p").value().wide.svg;
  EXPECT_NE(svg.find("<tspan class=\"power\" dy=\"-0.4em\">−7</tspan>"), std::string::npos) << svg;
}

TEST_F(PlotRendererTest, KnowsVegaLitesWords) {
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

TEST_F(PlotRendererTest, KnowsTheColumns) {
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

TEST_F(PlotRendererTest, RefusesWhatIsNoNumber) {
  const std::string take_logarithm = R"j({"calculate": "log(datum.x)", "as": "x"}])j";
  EXPECT_EQ(faults(line(R"(, "transform": [)" + take_logarithm)),
            "E-plot-finite [\"transform\",0,\"as\"] \"x\" is -Infinity in row 1 of what is drawn | "
            "leave such rows out by a filter before\n");
  EXPECT_EQ(faults(line(R"(, "transform": [{"filter": "datum.x > 0"}, )" + take_logarithm)), "");
}

TEST_F(PlotRendererTest, RefusesToDrawNothing) {
  EXPECT_EQ(faults(line(R"(, "transform": [{"filter": "datum.x > 9"}])")),
            "E-plot-empty [] what this plot filters leaves no row to draw | look at its filters\n");
}

TEST_F(PlotRendererTest, TurnsVegasDoubtsIntoFaults) {
  EXPECT_EQ(faults(line(R"(, "transform": [{"calculate": "datum.x +", "as": "z"}])")),
            "E-plot-spec [\"transform\",0,\"calculate\"] this is no expression: Unexpected end of "
            "input\n");
  EXPECT_EQ(faults(line(R"j(, "transform": [{"calculate": "logg(datum.x)", "as": "z"}])j")),
            "E-plot-spec [\"transform\",0,\"calculate\"] no function is named logg | "
            "Vega's documentation has those of its expressions\n");
  EXPECT_EQ(faults(line("", R"(, "stack": "zero", "scale": {"type": "point"})")),
            "E-plot-spec [] Stack is applied to a non-linear scale (point).\n"
            "E-plot-spec [\"encoding\",\"y\",\"scale\",\"type\"] FieldDef does not work with "
            "\"point\" scale. We are using \"linear\" scale instead.\n");
}

TEST_F(PlotRendererTest, SaysInItsOwnWordsWhatVegaMeans) {
  EXPECT_EQ(faults(R"({"encoding": {"x": {"field": "x", "type": "quantitative"}}})"),
            "E-plot-spec [] this plot has no mark | say what to draw: `\"mark\": \"line\"`\n");
  EXPECT_EQ(faults(line(R"(, "transform": [{"calculate": "x + 1", "as": "z"}])")),
            R"(E-plot-spec ["transform",0,"calculate"] nothing is named "x" here | )"
            "a column is `datum.NAME`; other names stand in the plot's `\"params\"`\n");
  EXPECT_EQ(faults(line("", R"(, "scale": {"domain": {"param": "brush"}})")),
            R"(E-plot-spec ["encoding","y","scale","domain","param"] nothing is named "brush" )"
            "here | a column is `datum.NAME`; other names stand in the plot's `\"params\"`\n");
  EXPECT_EQ(faults(line(R"(, "params": [{"name": "a", "value": 1}, {"name": "a", "value": 2}])")),
            R"(E-plot-spec ["params",0,"name"] two parameters are named "a" | )"
            "give each a name of its own\n");
  EXPECT_EQ(faults(line("", R"(, "axis": {"format": "zzz"})")),
            R"(E-plot-spec ["encoding","y","axis","format"] nothing is written in the format "zzz")"
            " | write `\".2f\"` or `\"%Y-%m\"`\n");
  EXPECT_EQ(faults(line("", R"(, "scale": {"domain": "unaggregated"})")),
            R"(E-plot-spec ["encoding","y","scale","domain"] the domain "unaggregated" is for )"
            "what is aggregated, and this column is not | leave \"domain\" out\n");
}

TEST_F(PlotRendererTest, FindsThePartThatVegaFailsAt) {
  const auto cannot = [](const std::string& path, const std::string& key) {
    return "E-plot-spec " + path + " key Vega-Lite cannot draw a plot with this \"" + key +
           "\", and does not say why | see what its documentation says of \"" + key +
           "\", or leave it out\n";
  };
  EXPECT_EQ(faults(R"({"mark": "bar", "encoding": {"x": {"field": "x", "type": "quantitative"},
                       "color": {"condition": {}, "value": "black"}}})"),
            cannot(R"(["encoding","color","condition"])", "condition"));
  EXPECT_EQ(faults(line(R"(, "transform": [{"filter": {}}])")),
            cannot(R"(["transform",0,"filter"])", "filter"));
  EXPECT_EQ(faults(line(R"(, "transform": [{"calculate": "datum.x.z.z", "as": "y"}])")),
            cannot(R"(["transform",0,"calculate"])", "calculate"));
  EXPECT_EQ(faults(line(R"(, "transform": [{"window": [{"op": "lag", "as": "z"}]}])")),
            cannot(R"(["transform",0,"window",0,"op"])", "op"));
  const std::string layer =
      R"({"mark": "bar", "encoding": {"color": {"condition": {}, "value": "a"},
                                "x": {"field": "x", "type": "quantitative"}}})";
  EXPECT_EQ(faults(R"({"layer": [)" + layer + ", " + layer + "]}"),
            "E-plot-spec [] Vega-Lite cannot draw this plot, and does not say why | leave out one "
            "part after another until it is drawn, and look at the last one\n");
}

TEST_F(PlotRendererTest, RefusesADomainThatTellsNoValuesApart) {
  const auto of_y = [&](const std::string& domain) {
    return faults(line("", R"(, "scale": {"domain": )" + domain + "}"));
  };
  const std::string fault =
      R"(E-plot-spec ["encoding","y","scale","domain"] the domain of a quantity goes from one )"
      "number to another | write `\"domain\": [0, 1]`, or leave it out\n";
  for (const char* domain : {"[]", "[1]", "[1, 1]", "[null, 1]", R"(["a", "b"])"}) {
    EXPECT_EQ(of_y(domain), fault) << domain;
  }
  EXPECT_EQ(of_y("[2, -2]"), "");
  EXPECT_EQ(of_y(R"([{"expr": "-2"}, 2])"), "");
  EXPECT_EQ(of_y("[-2, 0, 2]"), "");
  const auto timed = [&](const std::string& domain) {
    return faults(R"({"mark": "line", "encoding": {"x": {"field": "x", "type": "temporal",
                      "scale": {"domain": )" +
                  domain + R"(}}, "y": {"field": "y", "type": "quantitative"}}})");
  };
  EXPECT_EQ(timed(R"(["1970", "1971"])"), "");
  EXPECT_EQ(timed(R"(["foo", "bar"])"),
            R"(E-plot-spec ["encoding","x","scale","domain"] the domain of a time goes from one )"
            "date to another | write `\"domain\": [\"2024-01-01\", \"2025-01-01\"]`, or leave it "
            "out\n");
}

TEST_F(PlotRendererTest, HasColoursForFourSeries) {
  const json five = table({0, 1, 2, 3, 4}, {0, 1, 2, 3, 4});
  const std::string spec = R"({"mark": "point", "encoding": {
      "x": {"field": "x", "type": "quantitative"}, "color": {"field": "y", "type": "nominal"}}})";
  EXPECT_EQ(faults(spec, five),
            "E-plot-series [] this plot has 5 series, and colours for 4 | leave some out, or give "
            "each a part of its own by \"facet\"\n");
}

}  // namespace
}  // namespace mjcourse

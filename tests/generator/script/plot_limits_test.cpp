// What a few letters of a spec could make of any table, it may not.
#include "plot_renderer_fixture.h"

namespace mjcourse {
namespace {

class PlotLimitsTest : public PlotRendererTest {
 protected:
  // 3000 rows: x, each another number, and g: 0, 1 or 2.
  PlotLimitsTest() {
    std::vector<double> x(3000);
    std::vector<double> g(3000);
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] = static_cast<double>(i);
      g[i] = static_cast<double>(i % 3);
    }
    table_ = json::array({json::array({"x", x}), json::array({"g", g})});
  }

  // Of bars with `x` for what they show.
  static std::string bars(const std::string& more, const std::string& x = R"("field": "x")") {
    return "{" + more + R"("mark": "bar", "encoding": {"x": {)" + x +
           R"(, "type": "quantitative"}, "y": {"aggregate": "count"}}})";
  }
  static std::string transformed(const std::string& transform) {
    return bars(R"("transform": [)" + transform + "], ");
  }
  static std::string too_large(const std::string& path, const std::string& key, int most) {
    const std::string room = std::to_string(most);
    return "E-plot-size " + path + " \"" + key + "\" is 1000000000, and a plot has room for " +
           room + " | write " + room + " or less\n";
  }
  static std::string too_many_rows(const std::string& path, const std::string& rows) {
    return "E-plot-size " + path + " with this, the plot makes " + rows +
           " rows of its own, and 200000 are the most | let it make fewer\n";
  }
};

TEST_F(PlotLimitsTest, OfWhatASpecSays) {
  EXPECT_EQ(faults(bars(R"("width": 1e9, )")), too_large("[\"width\"]", "width", 4000));
  EXPECT_EQ(faults(bars(R"("height": 1e9, )")), too_large("[\"height\"]", "height", 4000));
  EXPECT_EQ(faults(bars(R"("height": {"step": 1e9}, )")),
            too_large("[\"height\",\"step\"]", "step", 4000));
  EXPECT_EQ(faults(bars("", R"("field": "x", "axis": {"tickCount": 1e9})")),
            too_large("[\"encoding\",\"x\",\"axis\",\"tickCount\"]", "tickCount", 1000));
  EXPECT_EQ(faults(bars("", R"("field": "x", "bin": {"maxbins": 1e9})")),
            too_large("[\"encoding\",\"x\",\"bin\",\"maxbins\"]", "maxbins", 1000));
  EXPECT_EQ(
      faults(transformed(R"({"regression": "g", "on": "x", "method": "poly", "order": 1e9})")),
      too_large("[\"transform\",0,\"order\"]", "order", 20));
}

TEST_F(PlotLimitsTest, OfWhatCannotBeDrawn) {
  const auto nothing = [](const std::string& path, const std::string& key,
                          const std::string& number) {
    return "E-plot-size " + path + " \"" + key + "\" is " + number +
           ", and nothing can be drawn so | write a number greater than 0\n";
  };
  EXPECT_EQ(faults(bars(R"("width": -90, )")), nothing("[\"width\"]", "width", "-90"));
  EXPECT_EQ(faults(bars(R"("height": 0, )")), nothing("[\"height\"]", "height", "0"));
  EXPECT_EQ(faults(bars("", R"("field": "x", "bin": {"step": -1})")),
            nothing(R"(["encoding","x","bin","step"])", "step", "-1"));
  EXPECT_EQ(faults(bars("", R"("field": "x", "bin": {"maxbins": 0})")),
            nothing(R"(["encoding","x","bin","maxbins"])", "maxbins", "0"));
  EXPECT_EQ(faults(bars("", R"("field": "x", "bin": {"extent": [5]})")),
            R"(E-plot-size ["encoding","x","bin"] no bins are as these should be | )"
            "write `\"extent\": [0, 5], \"step\": 0.5`\n");
  EXPECT_EQ(faults(bars("", R"("field": "x", "bin": {"step": 100})")), "");
  for (const std::string key : {"layer", "concat", "hconcat", "vconcat"}) {
    EXPECT_EQ(faults("{\"" + key + "\": []}"), "E-plot-empty [\"" + key + "\"] \"" + key +
                                                   "\" has no parts to draw | give it some\n");
  }
}

TEST_F(PlotLimitsTest, OfTicks) {
  const auto timed = [](const std::string& count) {
    return R"j({"mark": "tick", "transform": [{"calculate": "datum.x * 86400000", "as": "t"}],
               "encoding": {"x": {"field": "t", "type": "temporal", "axis": {"tickCount": )j" +
           count + "}}}}";
  };
  const std::string at = R"(E-plot-size ["encoding","x","axis","tickCount"] this makes )";
  const std::string most = " ticks, and 1000 are the most | let them be fewer\n";
  EXPECT_EQ(faults(timed(R"("day")")), at + "2999" + most);
  EXPECT_EQ(faults(timed(R"({"interval": "day", "step": 2})")), at + "1500" + most);
  EXPECT_EQ(faults(timed(R"({"expr": "1e9"})")), at + "1000000000" + most);
  EXPECT_EQ(faults(timed(R"({"interval": "month", "step": 3})")), "");
  EXPECT_EQ(faults(timed(R"("year")")), "");
}

TEST_F(PlotLimitsTest, OfTime) {
  const std::string loess = R"({"loess": "q", "on": "x", "as": ["x", "q"]})";
  EXPECT_EQ(faults(R"j({"transform": [{"calculate": "sequence(30)", "as": "q"}, {"flatten": ["q"]},
                       {"calculate": "datum.x + datum.q / 30", "as": "x"}, )j" +
                   loess + ", " + loess + ", " + loess + ", " + loess +
                   R"(], "mark": "line", "encoding": {
                       "x": {"field": "x", "type": "quantitative"},
                       "y": {"field": "q", "type": "quantitative"}}})"),
            "E-plot-size [] the drawing of this plot ran for more than 30 s | let it show fewer "
            "rows, bins or parts, or make them in the example\n");
}

TEST_F(PlotLimitsTest, OfHeight) {
  EXPECT_EQ(faults(R"({"mark": "bar", "height": 3990, "width": 90, "title": "t",
                       "encoding": {"x": {"field": "g"}}})"),
            "E-plot-size [] this plot is 4053 pixels high, and a page has room for 4000 | make its "
            "parts lower, or fewer\n");
}

// Three thousand circles, none of which is large by itself.
TEST_F(PlotLimitsTest, OfADrawing) {
  EXPECT_EQ(
      faults(R"({"mark": "point", "encoding": {"x": {"field": "x", "type": "quantitative"}}})"),
      "E-plot-size [] this plot would weigh 451 KB, more than a page should | let the example "
      "report fewer rows, say every tenth\n");
}

TEST_F(PlotLimitsTest, OfRows) {
  const std::string impute = R"({"impute": "g", "key": "x", "value": 0, )";
  EXPECT_EQ(faults(transformed(impute + R"("keyvals": {"start": 0, "stop": 1e9, "step": 1}})")),
            too_many_rows("[\"transform\",0,\"keyvals\"]", "1000000000"));
  EXPECT_EQ(faults(transformed(impute + R"("groupby": ["x"]})")),
            too_many_rows("[\"transform\",0,\"impute\"]", "9000000"));
  EXPECT_EQ(faults(transformed(R"({"density": "x", "steps": 1e9, "as": ["x", "d"]})")),
            too_many_rows("[\"transform\",0,\"density\"]", "1000000000"));
  EXPECT_EQ(faults(transformed(R"({"quantile": "x", "step": 1e-9, "as": ["p", "x"]})")),
            too_many_rows("[\"transform\",0,\"quantile\"]", "1000000000"));
  EXPECT_EQ(faults(transformed(
                R"j({"calculate": "sequence(100)", "as": "s"}, {"flatten": ["s"], "as": ["x"]})j")),
            too_many_rows("[\"transform\",0,\"calculate\"]", "200100"));
  EXPECT_EQ(faults(transformed(R"j({"calculate": "pad('x', 1e9, 'y')", "as": "s"})j")),
            "E-plot-size [\"transform\",0,\"calculate\"] this pads a text to 1000000000 "
            "characters, and 1000 are the most | write 1000 or less\n");
}

TEST_F(PlotLimitsTest, OfBins) {
  const std::string many = " this makes 2999000000 bins, and 1000 are the most | make them wider\n";
  EXPECT_EQ(faults(bars("", R"("field": "x", "bin": {"step": 1e-6})")),
            "E-plot-size [\"encoding\",\"x\",\"bin\"]" + many);
  EXPECT_EQ(faults(bars("", R"("field": "x", "scale": {"bins": {"step": 1e-6}})")),
            "E-plot-size [\"encoding\",\"x\",\"scale\",\"bins\"]" + many);
  // what is left by a filter counts
  EXPECT_EQ(faults(bars(R"("transform": [{"filter": "datum.x < 10"}], )",
                        R"("field": "x", "bin": {"step": 0.1})")),
            "");
}

TEST_F(PlotLimitsTest, OfParts) {
  const std::string point = R"("mark": "point", "width": 9, "encoding": {"x": {"field": "g"})";
  EXPECT_EQ(faults("{" + point + R"(, "row": {"field": "x"}}})"),
            "E-plot-size [\"encoding\",\"row\"] this makes 1001 parts of the plot, and 1000 are "
            "the most | leave some out by a filter\n");
  std::string columns = R"("x")";
  for (int i = 1; i < 40; ++i) columns += R"(, "x")";
  EXPECT_EQ(faults(R"({"repeat": {"row": [)" + columns + R"(], "column": [)" + columns +
                   R"(]}, "spec": {)" + point + "}}}"),
            "E-plot-size [\"repeat\"] this makes 1600 parts of the plot, and 1000 are the most | "
            "leave some out by a filter\n");
}

}  // namespace
}  // namespace mjcourse

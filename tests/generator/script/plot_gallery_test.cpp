// What Vega-Lite's own gallery does, in small: it is drawn, or refused for a reason that the guide
// states.
#include "plot_renderer_fixture.h"

namespace mjcourse {
namespace {

class PlotGalleryTest : public PlotRendererTest {
 protected:
  // x: 0 to 11; y: without outliers; g: 0, 1 or 2; k: 0 or 1.
  static json rows() {
    json columns = json::parse(R"([["x", []], ["y", []], ["g", []], ["k", []]])");
    for (int i = 0; i < 12; ++i) {
      columns[0][1].push_back(i);
      columns[1][1].push_back(i % 5 + i);
      columns[2][1].push_back(i % 3);
      columns[3][1].push_back(i / 6);
    }
    return columns;
  }

  std::string faults_of(const std::string& spec) { return faults(spec, rows()); }
  std::string svg_of(const std::string& spec) {
    return renderer_.draw(spec, rows(), "p").value().wide.svg;
  }

  static constexpr const char* kXY =
      R"("x": {"field": "x", "type": "quantitative"}, "y": {"field": "y", "type": "quantitative"})";
};

TEST_F(PlotGalleryTest, ABoxplotNeedsNoOutliers) {
  const std::string encoding = R"("encoding": {"x": {"field": "g", "type": "ordinal"},
                                   "y": {"field": "y", "type": "quantitative"})";
  EXPECT_EQ(faults_of(R"({"mark": "boxplot", )" + encoding + "}}"), "");
  EXPECT_EQ(faults_of(R"({"mark": "boxplot", "width": 90, )" + encoding +
                      R"(, "column": {"field": "k"}}})"),
            "");
  EXPECT_EQ(faults_of(R"({"hconcat": [{"mark": "boxplot", )" + encoding + "}}]}"), "");
  EXPECT_EQ(faults_of(R"({"transform": [{"filter": "datum.x > 99"}], "mark": "boxplot", )" +
                      encoding + "}}"),
            "E-plot-empty [] what this plot filters leaves no row to draw | look at its filters\n");
}

TEST_F(PlotGalleryTest, AHeightMayBeAStepForEachValue) {
  const std::string bars = R"("mark": "bar", "encoding": {"y": {"field": "g", "type": "ordinal"},
      "x": {"field": "y", "type": "quantitative", "aggregate": "sum"}})";
  const auto drawn = renderer_.draw(R"({"height": {"step": 17}, )" + bars + "}", rows(), "p");
  ASSERT_TRUE(drawn);
  EXPECT_EQ(drawn->wide.width, 640);
  EXPECT_LT(drawn->wide.height, 110);
  ASSERT_TRUE(drawn->narrow);
  EXPECT_EQ(faults_of(R"({"height": {"step": 17},
                          "autosize": {"type": "fit", "contains": "padding"}, )" +
                      bars + "}"),
            "E-plot-spec [] Dropping \"fit-y\" because spec has discrete height.\n");
}

TEST_F(PlotGalleryTest, ThePageIsNoContainer) {
  const std::string points = std::string(R"("mark": "point", "encoding": {)") + kXY + "}}";
  EXPECT_EQ(svg_of(R"({"width": "container", "height": "container", )" + points),
            svg_of("{" + points));
  EXPECT_EQ(svg_of(R"({"layer": [{"height": "container", "width": "container", )" + points + "]}"),
            svg_of(R"({"layer": [{)" + points + "]}"));
  EXPECT_EQ(svg_of(R"({"hconcat": [{"height": "container", "width": 90, )" + points + "]}"),
            svg_of(R"({"hconcat": [{"width": 90, )" + points + "]}"));
}

TEST_F(PlotGalleryTest, ALayerMayHaveASize) {
  const auto layered = [](const std::string& size) {
    return R"({"layer": [{)" + size +
           R"(, "mark": "bar", "encoding": {"y": {"field": "g", "type": "ordinal"},
               "x": {"field": "y", "type": "quantitative", "aggregate": "sum"}}}]})";
  };
  EXPECT_EQ(faults_of(layered(R"("width": 200)")), "");
  EXPECT_EQ(faults_of(layered(R"("height": 90)")), "");
  EXPECT_EQ(faults_of(layered(R"("height": {"step": 20})")), "");
}

TEST_F(PlotGalleryTest, FacetsAreSortedByWhatIsInThem) {
  const std::string sums = R"("x": {"field": "y", "type": "quantitative", "aggregate": "sum"},
                              "y": {"field": "g", "type": "ordinal", "sort": "-x"})";
  const std::string facet = R"({"field": "k", "type": "ordinal", "columns": 2,
                                "sort": {"op": "median", "field": "y", "order": "descending"}})";
  const std::string spec =
      R"({"mark": "bar", "width": 90, "encoding": {)" + sums + R"(, "facet": )" + facet + "}}";
  EXPECT_EQ(faults_of(spec), "");
  const std::string svg = svg_of(spec);
  EXPECT_LT(svg.find(">1<"), svg.find(">0<")) << svg;  // the headers, the higher median first
}

TEST_F(PlotGalleryTest, AnAxisIsAskedForItsOwnValues) {
  const auto with_axis = [](const std::string& axis) {
    return R"({"mark": "line", "encoding": {"x": {"field": "x", "type": "quantitative", "axis": {)" +
           axis + R"(}}, "y": {"field": "y", "type": "quantitative"}}})";
  };
  EXPECT_EQ(faults_of(with_axis(R"j("gridDash": {"value": [2, 2],
                "condition": {"test": "datum.value == 0 || datum.index > 3", "value": []}})j")),
            "");
  EXPECT_EQ(faults_of(with_axis(R"j("tickDash": {"value": [2, 2],
                "condition": {"test": {"field": "value", "gt": 3}, "value": []}})j")),
            "");
  EXPECT_EQ(faults_of(with_axis(R"j("labelExpr": "datum.label + datum.x")j")),
            "E-plot-field [\"encoding\",\"x\",\"axis\",\"labelExpr\"][20,21] an axis knows its own "
            "values, and no column \"x\" | known: value, label, index\n");
  EXPECT_EQ(faults_of(with_axis(R"j("labelExpr": "datum.label +")j")),
            "E-plot-spec [\"encoding\",\"x\",\"axis\",\"labelExpr\"] this is no expression: "
            "Unexpected end of input\n");
}

TEST_F(PlotGalleryTest, RepeatsByLayer) {
  const auto repeated = [](const std::string& columns) {
    return R"({"repeat": {"layer": [)" + columns +
           R"(]}, "spec": {"mark": "line", "width": 300, "encoding": {
               "x": {"field": "x", "type": "quantitative", "bin": true},
               "y": {"field": {"repeat": "layer"}, "type": "quantitative", "aggregate": "mean"},
               "color": {"datum": {"repeat": "layer"}, "type": "nominal"}}}})";
  };
  EXPECT_EQ(faults_of(repeated(R"("y", "g")")), "");
  EXPECT_EQ(faults_of(repeated(R"("y", "layer")")),
            "E-plot-field [\"repeat\",\"layer\",1][0,5] the table has no column \"layer\", and no "
            "transform makes it | known: x, y, g, k\n");
}

TEST_F(PlotGalleryTest, WhatCountsRowsReadsNoColumn) {
  const auto window = [](const std::string& op) {
    return R"({"transform": [{"window": [{"as": "n", )" + op + R"(}], "sort": [{"field": "y"}],
        "frame": [null, 0]}], "mark": "area", "encoding": {
        "x": {"field": "y", "type": "quantitative"}, "y": {"field": "n", "type": "quantitative"}}})";
  };
  EXPECT_EQ(faults_of(window(R"("op": "count", "field": "count")")), "");
  EXPECT_EQ(faults_of(window(R"("op": "rank", "field": "")")), "");
  EXPECT_EQ(faults_of(window(R"("op": "mean", "field": "count")")),
            "E-plot-field [\"transform\",0,\"window\",0,\"field\"][0,5] the table has no column "
            "\"count\", and no transform makes it | known: x, y, g, k, n\n");
  EXPECT_EQ(faults_of(R"({"mark": "bar", "encoding": {"x": {"field": "g", "type": "ordinal"},
                          "y": {"aggregate": "count", "field": "*", "type": "quantitative"}}})"),
            "");
}

TEST_F(PlotGalleryTest, KnowsWhatEachTransformMakes) {
  const auto bars = [](const std::string& transform, const std::string& y) {
    return R"({"transform": [)" + transform + R"(], "mark": "bar", "encoding": {
        "y": {"field": ")" +
           y + R"(", "type": "quantitative"}}})";
  };
  const std::string fit = R"({"regression": "y", "on": "x", "params": true})";
  EXPECT_EQ(faults_of(bars(fit, "rSquared")), "");
  EXPECT_EQ(faults_of(bars(fit + R"(, {"calculate": "datum.coef[1]", "as": "slope"})", "slope")),
            "");
  EXPECT_EQ(faults_of(bars(R"({"timeUnit": "year", "field": "x", "as": "t"})", "t_end")), "");
  EXPECT_EQ(faults_of(bars(R"({"stack": "y", "groupby": ["g"], "as": "v"})", "v_end")), "");
  const std::string best =
      R"({"aggregate": [{"op": "argmax", "field": "y", "as": "best"}], "groupby": ["g"]})";
  EXPECT_EQ(faults_of(bars(best, "best['x']")), "");
  EXPECT_EQ(faults_of(bars(best, "best.x")), "");
  EXPECT_EQ(faults_of(bars(best, "best.xx")),
            "E-plot-field [\"encoding\",\"y\",\"field\"][0,7] the table has no column \"best.xx\", "
            "and no transform makes it | known: x, y, g, k, best\n");
  EXPECT_EQ(faults_of(bars(R"({"regression": "y", "on": "xx"})", "y")),
            "E-plot-field [\"transform\",0,\"on\"][0,2] the table has no column \"xx\", and no "
            "transform makes it | did you mean `x`?\n");
}

TEST_F(PlotGalleryTest, ErrorsAreShownOverBins) {
  for (const std::string mark : {"errorband", "errorbar"}) {
    EXPECT_EQ(faults_of(R"({"mark": ")" + mark +
                        R"(", "encoding": {"x": {"field": "x", "type": "quantitative",
                            "bin": {"maxbins": 5}}, "y": {"field": "y", "type": "quantitative"}}})"),
              "");
  }
}

TEST_F(PlotGalleryTest, OrderedSeriesGetShapes) {
  const std::string svg = svg_of(std::string(R"({"mark": "point", "encoding": {)") + kXY +
                                 R"(, "color": {"field": "g", "type": "ordinal"}}})");
  EXPECT_EQ(svg.find(">g<"), svg.rfind(">g<")) << svg;  // one legend
  EXPECT_NE(svg.find(">g<"), std::string::npos) << svg;
}

TEST_F(PlotGalleryTest, WhatIsOnlyAskedNeedNotBeANumber) {
  const std::string last = R"({"window": [{"op": "lead", "field": "y", "as": "next"}]})";
  const auto filtered = [&](const std::string& field) {
    return R"({"transform": [)" + last + R"(, {"filter": "datum.next === null"}], "mark": "point",
        "encoding": {"x": {"field": ")" +
           field + R"(", "type": "quantitative"}}})";
  };
  EXPECT_EQ(faults_of(filtered("y")), "");
  EXPECT_EQ(faults_of(filtered("next")),
            "E-plot-finite [\"transform\",0,\"window\",0,\"as\"] \"next\" is null in row 1 of what "
            "is drawn | leave such rows out by a filter before\n");
}

TEST_F(PlotGalleryTest, ChanceIsTheSameInEachDrawing) {
  const std::string jitter = R"j({"transform": [{"calculate": "random()", "as": "j"}],
      "mark": "point", "encoding": {"x": {"field": "j", "type": "quantitative"}}})j";
  const std::string first = svg_of(jitter);
  EXPECT_EQ(svg_of(jitter), first);
}

TEST_F(PlotGalleryTest, NothingIsFetched) {
  EXPECT_EQ(faults_of(std::string(R"({"mark": "image", "encoding": {)") + kXY + "}}"),
            "E-plot-word [\"mark\"] \"mark\" of a lesson's plot cannot be \"image\": a plot shows "
            "what an example reported | draw it with another\n");
}

}  // namespace
}  // namespace mjcourse

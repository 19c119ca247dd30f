#include <gtest/gtest.h>

#include "page/page_fixture.h"

namespace mjcourse {
namespace {

constexpr const char* kPlot = R"(```plot
{"data": {"name": "fall/energy"}, "caption": "It *falls*.", "alt": "A \"line\"."}
```
)";

class PlotDataTest : public PageWriterTest {
 protected:
  PlotDataTest() {
    result_.drawings = {{"<path d=\"M0\"/>", 640, 320}, PlotDrawing{"<g></g>", 328, 280}};
    result_.table = {{"time (s)", {0, 0.1}}, {"e", {-1.0 / 3, -0.0}}};
    result_.file = "examples/fall.cpp";
  }
  std::string page() {
    results_.of_block[0] = result_;
    return body(kPlot);
  }

  PlotResult result_;
};

TEST_F(PlotDataTest, HasBothDrawingsAndTheNumbersBehindThem) {
  EXPECT_EQ(
      page(),
      R"(<div class="plot" id="plot-1" data-quotes="fall" data-table="energy" data-spec="../1-a/1.1-x/plot-1.json">
<figure>
<div class="plot-wide">
<svg role="img" aria-label="A &quot;line&quot;." viewBox="0 0 640 320" width="640" height="320"><path d="M0"/></svg>
</div>
<div class="plot-narrow">
<svg role="img" aria-label="A &quot;line&quot;." viewBox="0 0 328 280" width="328" height="280"><g></g></svg>
</div>
<figcaption>It <em>falls</em>. <span class="plot-source">Computed by <a href="../examples/fall.cpp" download>fall.cpp</a>.</span></figcaption>
</figure>
<details class="plot-numbers">
<summary>The numbers</summary>
<div class="table">
<table>
<thead><tr><th scope="col" class="end">time (s)</th><th scope="col" class="end">e</th></tr></thead>
<tbody>
<tr><td class="end">0</td><td class="end">−0.333333</td></tr>
<tr><td class="end">0.1</td><td class="end">0</td></tr>
</tbody>
</table>
</div>
<p><a href="../1-a/1.1-x/plot-1.csv" download>Download as CSV</a></p>
</details>
</div>
)");
}

TEST_F(PlotDataTest, LeavesALongTableToTheDownload) {
  for (Column& column : result_.table) column.values.resize(13);
  const std::string html = page();
  EXPECT_EQ(html.find("<table>"), std::string::npos) << html;
  EXPECT_NE(html.find("<p>13 rows of time (s), e.</p>"), std::string::npos) << html;
}

TEST_F(PlotDataTest, LetsALoneDrawingBeScrolled) {
  result_.drawings.narrow.reset();
  const std::string html = page();
  EXPECT_NE(
      html.find("<div class=\"plot-only\" tabindex=\"0\" role=\"group\" aria-label=\"Plot\">"),
      std::string::npos)
      << html;
  EXPECT_EQ(html.find("plot-narrow"), std::string::npos) << html;
}

}  // namespace
}  // namespace mjcourse

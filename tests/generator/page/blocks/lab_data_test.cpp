#include "page/page_fixture.h"

namespace mjcourse {
namespace {

constexpr const char* kLabFence = R"(```lab simlab
{"title": "T & U", "model": "m", "alt": "A \"ball\".", "dock": true, "toggles": ["frames"],
 "controls": [{"type": "slider", "label": "S", "bind": "data.time", "min": 0, "max": 4}],
 "readouts": [{"label": "x", "expr": "1", "digits": 1, "unit": "m"}],
 "plots": [{"ylabel": "y", "traces": [{"label": "t", "expr": "2"}]}], "note": "*N*"}
```
)";

class LabDataTest : public PageWriterTest {
 protected:
  LabDataTest() {
    LabResult result;
    result.readouts = {-0.01};
    result.traces = {{2}};
    result.poster = Poster{Blob("webp"), Blob("png"), 712, 300};
    results_.of_block[0] = result;
  }
};

TEST_F(LabDataTest, WakesUpWhereTheSiteHasAnEngine) {
  manifest_ = {{"lab.js", "assets/lab-1.js"},
               {"lab.css", "assets/lab-4.css"},
               {"engine.mjs", "assets/engine-2.mjs"},
               {"engine.wasm", "assets/engine-3.wasm"}};
  PageWriter with = writer(kLabFence);
  const std::string html = with.body();
  ASSERT_EQ(with.lab_files().size(), 1U);
  const std::string open = "<sim-lab class=\"lab dock\" id=\"lab-1\" data-module=\"../" +
                           with.lab_files()[0].module +
                           "\" data-code=\"../assets/lab-1.js\" data-style=\"../assets/lab-4.css\" "
                           "data-engine=\"../assets/engine-2.mjs\" "
                           "data-wasm=\"../assets/engine-3.wasm\">\n";
  EXPECT_TRUE(html.starts_with(open)) << html;
  EXPECT_EQ(html.find("lab-missing"), std::string::npos) << html;
}

TEST_F(LabDataTest, WaitsForItsReaderWhereItIsLarge) {
  for (const char* name : {"lab.js", "lab.css", "engine.mjs", "engine.wasm"}) {
    manifest_[name] = std::string("assets/") + name;
  }
  for (const bool large : {false, true}) {
    std::get<LabResult>(results_.of_block[0]).memory = (64ULL << 20) + (large ? 1 : 0);
    const std::string html = writer(kLabFence).body();
    EXPECT_EQ(html.find("engine.wasm\" data-large>") != std::string::npos, large) << html;
  }
}

TEST_F(LabDataTest, SaysThatItCannotWakeUpWithoutOne) {
  EXPECT_EQ(body(kLabFence), R"(<sim-lab class="lab dock" id="lab-1">
<figure aria-labelledby="lab-1-title">
<figcaption id="lab-1-title">T &amp; U</figcaption>
<div class="lab-view">
<picture><source type="image/webp" srcset="../1-a/1.1-x/lab-1.webp"><img src="../1-a/1.1-x/lab-1.png" width="712" height="300" alt="A &quot;ball&quot;." loading="lazy" decoding="async"></picture>
<p class="lab-missing">The live lab is not part of this build.</p>
</div>
<div class="lab-body">
<p class="lab-label">Readings at rest</p>
<dl class="readouts">
<div><dt>x</dt><dd><span class="value">0.0</span> <span class="unit">m</span></dd></div>
</dl>
<dl class="traces">
<div class="traces-label"><dt>Plotted</dt><dd>y</dd></div>
<div><dt>t</dt><dd>2.0000</dd></div>
</dl>
<p class="lab-label controls-label">In the lab</p>
<ul class="controls">
<li>S</li>
</ul>
<p class="toggles"><span>Can be shown</span> frames</p>
<div class="lab-note"><em>N</em></div>
<p class="lab-address">Live at <span>1-a/1.1-x.html#lab-1</span></p>
</div>
</figure>
</sim-lab>
)");
}

}  // namespace
}  // namespace mjcourse

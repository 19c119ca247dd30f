#include "page/blocks/lab_module.h"

#include <nlohmann/json.hpp>

#include "base/temporary_folder.h"
#include "page/page_fixture.h"

namespace mjcourse {
namespace {

using nlohmann::json;

class LabModuleTest : public PageWriterTest {
 protected:
  LabModuleTest() {
    result_.script_names = {"data", "model", "Math"};
    result_.camera = {10, 20, 3, {0, 1, 2}};
    result_.model = {"m.xml", {{"m.xml", "<mujoco/>"}}, {}};
  }

  // The module of a lab with these members.
  LabFiles module(const std::string& members, const std::string& name = "1.1-1") {
    PageWriter with = writer(R"(```lab simlab
{"title": "T", "model": "m", "alt": "A")" +
                             members + "}\n```\n");
    for (const Block& block : course_.lessons[0].blocks) {
      const auto* lab = std::get_if<Lab>(&block);
      if (lab == nullptr) continue;
      pass_scripts(*lab, result_);
      return write_lab_module(*lab, result_, name, with.context());
    }
    ADD_FAILURE() << "no lab";
    return {};
  }
  static std::string text(const LabFiles& files) { return files.written.at(files.module); }
  static json lab(const LabFiles& files) {
    const std::string all = text(files), head = "export const lab = ";
    EXPECT_TRUE(all.starts_with(head)) << all;
    return json::parse(all.substr(head.size(), all.find(";\nexport") - head.size()));
  }

  LabResult result_;
};

TEST_F(LabModuleTest, DescribesALab) {
  EXPECT_EQ(lab(module("")), json::parse(R"({
      "title": "T", "height": 300, "speed": 1,
      "camera": {"azimuth": 10, "elevation": 20, "distance": 3, "target": [0, 1, 2]},
      "model": {"name": "m.xml", "texts": {"m.xml": "<mujoco/>"}, "assets": {}},
      "toggles": [], "overlays": [], "controls": [], "readouts": [], "plots": [],
      "predict": null, "goal": null, "ghost": null, "editable": null})"));
}

TEST_F(LabModuleTest, HasFunctionsForScripts) {
  result_.overlays = {"frames", "tendons"};
  const LabFiles files = module(R"(, "speed": 0.5, "toggles": ["frames"],
      "overlays": {"frames": true, "contacts": false},
      "controls": [{"type": "button", "label": "B", "run": ["data.time = 1 // one", "f"]}],
      "readouts": [{"label": "R", "expr": "Math.PI", "digits": 5, "unit": "u"}],
      "plots": [{"ylabel": "y", "ymin": -1, "traces": [{"label": "t", "expr": "data.time"}]}])");
  const json found = lab(files);
  EXPECT_EQ(found["speed"], 0.5);
  EXPECT_EQ(found["toggles"], json({"frames"}));
  EXPECT_EQ(found["overlays"], json({"frames", "tendons"}));
  EXPECT_EQ(found["controls"], json::parse(R"([{"type": "button", "label": "B", "run": 0}])"));
  EXPECT_EQ(found["readouts"],
            json::parse(R"([{"label": "R", "value": 1, "digits": 5, "unit": "u"}])"));
  EXPECT_EQ(found["plots"], json::parse(R"([{"ylabel": "y", "window": 5, "ymin": -1, "ymax": null,
                                             "traces": [{"label": "t", "value": 2}]}])"));
  EXPECT_EQ(text(files).substr(text(files).find("\nexport") + 1), R"(export const scripts = [
({ data }) => { {
data.time = 1 // one
f
} },
({ Math }) => { return (
Math.PI
); },
({ data }) => { return (
data.time
); },
];
)");
}

TEST_F(LabModuleTest, HasEveryControl) {
  result_.keyframes = {0, 0, 0, 0, 7};
  const LabFiles files = module(R"(, "controls": [
      {"type": "slider", "label": "S", "bind": "data.time", "min": 0, "max": 4},
      {"type": "slider", "label": "V", "bind": "data.time", "min": 0, "max": 4, "step": 1,
       "value": 2, "digits": 0, "unit": "s"},
      {"type": "toggle", "label": "T", "on": "a", "off": "b", "value": true},
      {"type": "select", "label": "C", "options": [{"label": "x", "run": "c"},
                                                   {"label": "y", "run": "d"}]},
      {"type": "keyframe", "label": "K", "key": "home"}])");
  EXPECT_EQ(lab(files)["controls"], json::parse(R"([
      {"type": "slider", "label": "S", "bind": "data.time", "read": 0, "write": 1, "min": 0,
       "max": 4, "step": 0.02, "value": null, "digits": 2, "unit": ""},
      {"type": "slider", "label": "V", "bind": "data.time", "read": 2, "write": 3, "min": 0,
       "max": 4, "step": 1, "value": 2, "digits": 0, "unit": "s"},
      {"type": "toggle", "label": "T", "on": 4, "off": 5, "value": true},
      {"type": "select", "label": "C", "value": null, "options": [{"label": "x", "run": 6},
                                                                  {"label": "y", "run": 7}]},
      {"type": "keyframe", "label": "K", "key": 7}])"));
  EXPECT_NE(text(files).find("({ data, value }) => { (\ndata.time\n) = value; },"),
            std::string::npos);
}

TEST_F(LabModuleTest, HasWhatIsAskedOfItsReader) {
  const json found = lab(module(R"(,
      "predict": {"q": "*How?*", "value": "1", "seconds": 2, "tol": 0.5, "unit": "m"},
      "goal": {"text": "Do it.", "done": "2", "solution": {"run": "s"}},
      "ghost": {"label": "G", "run": "g"},
      "editable": {"tasks": [{"q": "?", "value": "3", "unit": "kg"}]})"));
  EXPECT_EQ(found["predict"], json::parse(R"({"question": "<p><em>How?</em></p>\n", "run": null,
      "value": 0, "seconds": 2, "tolerance": 0.5, "digits": 3, "unit": "m", "explanation": ""})"));
  EXPECT_EQ(found["goal"], json::parse(R"({"text": "<p>Do it.</p>\n", "done": 1})"));
  EXPECT_EQ(found["ghost"], json::parse(R"({"label": "G", "run": 2})"));
  EXPECT_EQ(found["editable"], json::parse(R"({"tasks": [
      {"question": "<p>?</p>\n", "value": 3, "tolerance": 0, "unit": "kg"}]})"));
}

// The page's policy forbids style attributes: they are rules of the page's stylesheet.
TEST_F(LabModuleTest, HasNoStylesInItsHtml) {
  results_.of_block[0] = FormulaResult{"<i style=\"top:1em\">x</i>"};
  const json found =
      lab(module(R"(, "goal": {"text": "$x$", "done": "2", "solution": {"run": "s"}})"));
  EXPECT_EQ(found["goal"]["text"], "<p><span class=\"math\"><i class=\"s0\">x</i></span></p>\n");
  EXPECT_EQ(styles_.sheet(), ".s0{top:1em}\n");
}

TEST_F(LabModuleTest, BearsAHashOfItsContent) {
  const LabFiles files = module("");
  EXPECT_EQ(files.module.size(), std::string("labs/1.1-1-1234567890.js").size());
  EXPECT_TRUE(files.module.starts_with("labs/1.1-1-")) << files.module;
  EXPECT_EQ(module("").module, files.module);
  EXPECT_NE(module(R"(, "speed": 2)").module, files.module);
  EXPECT_EQ(files.written.count("labs/1.1-1.rehearsal.json"), 1U);
}

TEST_F(LabModuleTest, NamesItsModelsFiles) {
  const TemporaryFolder folder;
  write_file(folder.path() / "wedge.obj", "v 0 0 0\n");
  result_.model.assets = {{"wedge.obj", folder.path() / "wedge.obj"}};
  const LabFiles files = module("");
  ASSERT_EQ(files.copied.size(), 1U);
  const auto& [path, file] = *files.copied.begin();
  EXPECT_TRUE(path.starts_with("models/wedge-") && path.ends_with(".obj")) << path;
  EXPECT_EQ(file, folder.path() / "wedge.obj");
  EXPECT_EQ(lab(files)["model"]["assets"], json({{"wedge.obj", "../" + path}}));
  // Of a model that lies in a folder.
  const LabFiles deeper = module("", "arm/scene-1");
  EXPECT_TRUE(deeper.module.starts_with("labs/arm/scene-1-")) << deeper.module;
  EXPECT_EQ(lab(deeper)["model"]["assets"], json({{"wedge.obj", "../../" + path}}));
}

}  // namespace
}  // namespace mjcourse

#include "evaluate/programs/snippets.h"

#include <gtest/gtest.h>

#include "evaluate/evaluation_of.h"

namespace mjcourse {
namespace {

std::string snippet(const std::string& code, const std::string& options = "model=ball") {
  return "```cpp snippet " + options + "\n" + code + "```\n";
}

std::string printed_by_snippets(const std::string& text) {
  return "```text\n" + text + "```\n";
}

TEST(Snippets, SeeTheirModelAndFreshData) {
  const EvaluationOf found(snippet("data->qpos[0] = 5;\nstd::printf(\"%d\\n\", model->nq);\n") +
                           printed_by_snippets("8\n") +
                           snippet("//| const double x = data->qpos[0];\n"
                                   "std::printf(\"%.1f\\n\", x);\n") +
                           printed_by_snippets("0.0\n"));
  EXPECT_EQ(found.mistakes(), "");
  EXPECT_EQ(found.tally().snippets, 2);
  EXPECT_EQ(found.tally().programs, 0);
  EXPECT_EQ(found.tally().outputs, 2);
}

TEST(Snippets, AreProgramsOfTheirOwnForAReader) {
  const EvaluationOf found(
      snippet("  //| const int n = 1;\n//| if (n > 0)\n  std::printf(\"%d\\n\", n);\n"));
  EXPECT_EQ(found.mistakes(), "");
  const ExampleResult& result = found.result<ExampleResult>();
  EXPECT_EQ(result.code.substr(result.code.find("\nvoid ")), R"(
void snippet([[maybe_unused]] mjModel* model, [[maybe_unused]] mjData* data) {
    const int n = 1;
  if (n > 0)
    std::printf("%d\n", n);
}

int main() {
  char error[1000] = "";
  mjModel* model = mj_loadXML(MJCOURSE_MODELS "/ball.xml", nullptr, error, sizeof error);
  if (model == nullptr) {
    std::fprintf(stderr, "%s\n", error);
    return 1;
  }
  mjData* data = mj_makeData(model);
  snippet(model, data);
  mj_deleteData(data);
  mj_deleteModel(model);
}
)");
  EXPECT_EQ(result.files, std::vector<std::string>{"models/ball.xml"});
}

TEST(Snippets, KeepTheirRawStringsToTheByte) {
  const EvaluationOf found(snippet("std::puts(R\"(a\nb)\");\n"));
  EXPECT_EQ(found.mistakes(), "");
  EXPECT_NE(found.result<ExampleResult>().code.find("\nstd::puts(R\"(a\nb)\");\n}"),
            std::string::npos);
}

TEST(Snippets, SeeAModelInAFolder) {
  const EvaluationOf found(
      snippet("std::printf(\"%d\\n\", model->nbody);\n", "model=robot/scene"),
      {{"models/robot/scene.xml", "<mujoco><include file=\"arm.xml\"/></mujoco>"},
       {"models/robot/arm.xml", "<mujoco><worldbody><body/><body/></worldbody></mujoco>"}});
  EXPECT_EQ(found.mistakes(), "");
  EXPECT_EQ(found.result<ExampleResult>().output, "3\n");
}

TEST(Snippets, HaveTheHelperHeader) {
  const EvaluationOf found(
      snippet("help(model);\n"),
      {{"examples/include/mjcourse/mjcourse.hpp",
        "#include <mujoco/mujoco.h>\n#include <cstdio>\nnamespace mjcourse {\n"
        "inline void help(const mjModel* m) { std::printf(\"%d\\n\", m->nv); }\n}\n"}});
  EXPECT_EQ(found.mistakes(), "");
  EXPECT_EQ(found.result<ExampleResult>().output, "7\n");
}

TEST(Snippets, AreBlamedAtTheirOwnLines) {
  EXPECT_EQ(
      evaluated_mistakes(snippet("model->nq;\n") + "\n> " + "```cpp snippet model=ball\n" +
                         "> //| int n = 1;\n>   n = lost;\n> ```\n"),
      R"(content/1-a/1.1-x.md:5:8: warning: expression result unused [-Wunused-value] [W-example-compile]
  5 | model->nq;
    |        ^~
content/1-a/1.1-x.md:10:9: error: use of undeclared identifier 'lost' [E-example-compile]
  10 | >   n = lost;
     |         ^~~~
)");
}

TEST(Snippets, CloseWhatTheyOpen) {
  const std::string open = "if (model->nq > 0) {\n", closed = "std::puts(\"a\");\n";
  EXPECT_EQ(
      evaluated_mistakes(snippet(closed) + snippet(open) + snippet(closed)),
      R"(content/1-a/1.1-x.md:7:1: error: this snippet leaves a brace or a parenthesis open [E-snippet-open]
  7 | ```cpp snippet model=ball
    | ^~~~~~~~~~~~~~~~~~~~~~~~~
  cure: close it; a line that begins with `//| ` is not shown
)");
  const EvaluationOf last(snippet(closed) + snippet(open));
  ASSERT_EQ(last.diagnostics().size(), 1u) << last.mistakes();
  EXPECT_EQ(last.diagnostics()[0].id, "E-snippet-open");
  EXPECT_EQ(last.diagnostics()[0].place.line, 7);
  EXPECT_EQ(evaluated_mistakes(snippet("}\n") + snippet(closed)),
            R"(content/1-a/1.1-x.md:6:1: error: extraneous closing brace ('}') [E-example-compile]
  6 | ```
    | ^
)");
}

TEST(Snippets, AreStoppedEachByItself) {
  EXPECT_EQ(
      evaluated_mistakes(
          snippet("throw std::runtime_error(\"lost\");\n") +
          snippet("mju_error(\"bad quaternion\");\n") + snippet("std::puts(\"fine\");\n") +
          snippet("for (volatile int i = 0; i == 0;) {\n}\n", "model=ball timeout=0.5")),
      R"(content/1-a/1.1-x.md:4:1: error: the snippet threw std::runtime_error: lost [E-example-throws]
  4 | ```cpp snippet model=ball
    | ^~~~~~~~~~~~~~~~~~~~~~~~~
  cure: catch it, or fix what it complains about
content/1-a/1.1-x.md:7:1: error: MuJoCo stopped the snippet: bad quaternion [E-example-mujoco]
  7 | ```cpp snippet model=ball
    | ^~~~~~~~~~~~~~~~~~~~~~~~~
content/1-a/1.1-x.md:13:1: error: the snippet still ran after 0.5 s, and was stopped [E-example-timeout]
  13 | ```cpp snippet model=ball timeout=0.5
     | ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
  cure: look for a loop without an end; a snippet that needs longer says `timeout=SECONDS`
)");
}

TEST(Snippets, NeedAModelThatIsThere) {
  const EvaluationOf found(snippet("std::puts(\"a\");\n", "model=bal"));
  EXPECT_EQ(
      found.mistakes(),
      R"(content/1-a/1.1-x.md:4:22: error: there is no model `bal` in models/ [E-model-unknown]
  4 | ```cpp snippet model=bal
    |                      ^~~
  cure: did you mean `ball`?
)");
  EXPECT_EQ(found.tally().snippets, 0);
}

}  // namespace
}  // namespace mjcourse

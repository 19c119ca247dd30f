#include "evaluate/programs/page_run.h"

#include <gtest/gtest.h>

#include "evaluate/evaluation_of.h"
#include "memory_store.h"
#include "toolchain/scripted_page.h"

namespace mjcourse {
namespace {

constexpr const char* kHello = "#include <cstdio>\nint main() { std::puts(\"hello\"); }\n";

std::string answer(const std::string& out, const std::string& end,
                   const std::string& records = "") {
  return R"({"ok": true, "diagnostics": [], "out": ")" + out + R"(", "err": "", "end": )" + end +
         R"(, "records": ")" + records + "\"}";
}

std::string exits(const std::string& out, int code = 0) {
  return answer(out, R"({"how": "exit", "code": )" + std::to_string(code) + "}");
}

EvaluationOf evaluated(const ScriptedPage& page, const std::string& code = kHello,
                       const std::string& options = "") {
  const std::string fence = "```cpp file=examples/a.cpp" + options + "\n" + code + "```\n";
  return EvaluationOf(fence, {{"examples/a.cpp", code}}, nullptr, page.folder());
}

PageRun page_run(const std::string& answer, const std::string& code = kHello,
                 const std::string& options = "") {
  return evaluated(ScriptedPage(answer), code, options).result<ExampleResult>().page.value();
}

TEST(PageRun, IsNoneWithoutACompiler) {
  const EvaluationOf found("```cpp file=examples/a.cpp\n```\n", {{"examples/a.cpp", kHello}});
  EXPECT_FALSE(found.result<ExampleResult>().page);
}

TEST(PageRun, KeepsNoTextThatIsTheSame) {
  const PageRun same = page_run(exits("hello\\n"));
  EXPECT_EQ(same.why_not + same.otherwise, "");
  EXPECT_FALSE(same.outputs);
  const PageRun other = page_run(exits("other\\n"));
  ASSERT_TRUE(other.outputs);
  EXPECT_EQ(other.outputs->native + other.outputs->page, "hello\nother\n");
}

TEST(PageRun, EndsAsItDidNatively) {
  const std::string fails = "int main() { return 70; }\n", expected = " expect=exit:70";
  EXPECT_EQ(page_run(exits("", 70), fails, expected).otherwise, "");
  EXPECT_EQ(page_run(exits("", 0), fails, expected).otherwise,
            "exits with code 0, and natively with 70");
  const std::string stopped = answer("", R"({"how": "error", "message": "no such body"})");
  EXPECT_EQ(page_run(stopped, fails, expected).otherwise, "");
  EXPECT_EQ(page_run(stopped).otherwise, "is stopped by MuJoCo: no such body");
  EXPECT_EQ(page_run(answer("", R"({"how": "uncaught", "message": "bad"})")).otherwise,
            "throws bad");
  EXPECT_EQ(page_run(answer("", R"({"how": "trap", "message": "bad"})")).otherwise,
            "ends with: bad");
}

TEST(PageRun, ReportsTheSame) {
  const std::string end = R"({"how": "exit", "code": 0})";
  EXPECT_EQ(page_run(answer("hello\\n", end, R"({\"result\": \"x\", \"value\": 1})")).otherwise,
            "reports otherwise: the result `x` is there alone");
}

TEST(PageRun, SaysWhyThereCanBeNone) {
  EXPECT_EQ(page_run(R"({"ok": false, "diagnostics": [{"severity": "note", "message": "x"},
                    {"severity": "error", "message": "no <epoll>\nthere"}]})")
                .why_not,
            "the page's compiler says: no <epoll>");
  EXPECT_EQ(page_run(answer("", R"({"how": "memory", "message": ""})")).why_not,
            "it takes more memory than a page has");
  EXPECT_EQ(
      page_run(answer("", R"({"how": "trap", "message": "a thread waits for another"})")).why_not,
      "a thread waits for another");
  EXPECT_EQ(page_run("", kHello, " native").why_not, "native only");
  EXPECT_EQ(page_run("", kHello, " native because=\"it measures\"").why_not, "it measures");
}

TEST(PageRun, IsAskedForOnce) {
  const ScriptedPage page(exits("hello\\n"));
  MemoryStore store;
  const auto evaluated = [&](const std::string& prose) {
    return EvaluationOf(prose + "```cpp file=examples/a.cpp\n```\n", {{"examples/a.cpp", kHello}},
                        &store, page.folder());
  };
  EXPECT_FALSE(evaluated("").result<ExampleResult>().page->outputs);
  page.answers(exits("other\\n"));
  EXPECT_FALSE(evaluated("Prose.\n\n").result<ExampleResult>().page->outputs);
}

TEST(PageRun, OfAProgramThatDrawsIsNotTried) {
  const std::string draws = "#include <GL/osmesa.h>\nint main() {}\n";
  EXPECT_EQ(page_run("", draws).why_not, "it draws, and the page's engine only simulates");
}

TEST(PageRun, HasTheFilesThatAReaderTakesAlong) {
  const ScriptedPage page;
  // The files of the question are what the compiler complains of.
  page.runs(R"sh(dd bs=8 count=1 2>/dev/null >size
dd bs=1M count=1 2>/dev/null | tr '"' "'" | grep -o "'[a-z./0-9]*':{'[a-z0-9]*'" | tr '\n' ' ' >files
answer=$(printf '{"ok":false,"diagnostics":[{"severity":"error","message":"%s"}]}' "$(cat files)")
printf "\\$(printf %03o ${#answer})\0\0\0\0\0\0\0%s" "$answer"
exec cat >/dev/null)sh");
  const std::string code =
      "#include <fstream>\n#include <cstdlib>\n#include <string>\n#include <mine.h>\n"
      "int main() { std::ifstream(std::getenv(\"MJCOURSE_MODELS\") + "
      "std::string(\"/ball.xml\")); }\n";
  const EvaluationOf found("```cpp file=examples/a.cpp\n```\n",
                           {{"examples/a.cpp", code}, {"examples/include/mine.h", "// \xFF\n"}},
                           nullptr, page.folder());
  EXPECT_EQ(found.result<ExampleResult>().page->why_not,
            "the page's compiler says: 'a.cpp':{'text' 'include/mine.h':{'base64' "
            "'models/ball.xml':{'text' ");
}

}  // namespace
}  // namespace mjcourse

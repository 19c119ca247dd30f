// What a lesson states, and what is said of each.
#include "evaluate/claims/claims.h"

#include <gtest/gtest.h>

#include "evaluate/claims/strict.h"
#include "evaluate/evaluation_of.h"
#include "toolchain/scripted_page.h"

namespace mjcourse {
namespace {

constexpr const char* kHello =
    "#include <cstdio>\nint main() { std::puts(\"ball.xml 1.50\"); }  // #region r\n";

// Each claim on a few lines, without its key.
std::string told(const Claims& claims) {
  std::string text;
  for (const Claim& claim : claims) {
    text += std::to_string(claim.place.line) + " " + name_of(claim.kind) + " " +
            name_of(claim.status) + ": " + claim.what + "\n";
    for (const std::string* part : {&claim.how, &claim.limits, &claim.reason}) {
      if (!part->empty()) text += "    " + *part + "\n";
    }
  }
  return text;
}

std::string told(const EvaluationOf& found) {
  return told(found.claims());
}

std::string told(const std::string& body, const std::map<std::string, std::string>& files = {}) {
  return told(EvaluationOf(body, files));
}

// The key of the last claim of a lesson.
std::string key(const std::string& body, const std::map<std::string, std::string>& files = {}) {
  const EvaluationOf found(body, files);
  return found.claims().back().key;
}

std::string quiz(const std::string& question) {
  return "```quiz\n{\"id\": \"q\", \"questions\": [" + question + "]}\n```\n";
}
std::string asked(const std::string& verify) {
  return quiz(
      "{\"kind\": \"numeric\", \"q\": \"How many is `nq`?\", \"answer\": 8, \"tol\": 0.5, "
      "\"explain\": \"x\"" +
      verify + "}");
}

TEST(Claims, OfAProgramAndItsOutput) {
  const EvaluationOf found(
      "```cpp file=examples/a.cpp args=\"x y\" timeout=5\n```\n\n"
      "```text\n[..] 1.51\n```\n\n"
      "```text output=a tol=0.1\nball.xml 1.6\n```\n",
      {{"examples/a.cpp", kHello}});
  EXPECT_EQ(found.mistakes(), "");
  EXPECT_EQ(told(found),
            "4 program proved: examples/a.cpp\n"
            "    compiled by " +
                found.versions().compiler +
                " without optimisation and run with x y; exit code 0\n"
                "    5 s, 1 MiB of output, no input, a folder of its own\n"
                "7 output proved: the output of a.cpp\n"
                "    compared with what a.cpp printed: 1 line, numbers to one unit in "
                "their last place\n"
                "    any text may stand for [..]\n"
                "11 output proved: the output of a.cpp\n"
                "    compared with what a.cpp printed: 1 line, numbers to within 0.1\n");
  EXPECT_EQ(found.versions().compiler.find("clang "), 0u) << found.versions().compiler;
  EXPECT_GT(found.claims()[0].seconds, found.claims()[0].run_seconds);
  EXPECT_GT(found.claims()[0].run_seconds, 0);
}

TEST(Claims, OfAProgramInThePage) {
  const ScriptedPage page(R"({"ok": true, "out": "ball.xml 1.50\n", "records": "",
                              "end": {"how": "exit", "code": 0}})");
  const std::map<std::string, std::string> files{{"examples/a.cpp", kHello}};
  const std::string fence = "```cpp file=examples/a.cpp";
  const EvaluationOf found(fence + "\n```\n", files, nullptr, page.folder());
  EXPECT_NE(told(found).find(
                "4 page proved: examples/a.cpp in the page\n"
                "    compiled as a reader's page does it and run on the page's engine; its output "
                "and its records are those of the native run\n"),
            std::string::npos)
      << told(found);
  EXPECT_EQ(found.tally().in_page, 1);
  const EvaluationOf native(fence + " native\n```\n", files, nullptr, page.folder());
  EXPECT_NE(told(native).find("4 page unchecked: examples/a.cpp in the page\n    native only\n"),
            std::string::npos)
      << told(native);
  EXPECT_EQ(native.tally().in_page, 0);
  EXPECT_EQ(native.tally().unchecked, 0);
  page.answers(R"({"ok": true, "out": "", "records": "", "end": {"how": "exit", "code": 0}})");
  const EvaluationOf other(fence + "\n```\n", files, nullptr, page.folder());
  EXPECT_NE(told(other).find("4 page failed: examples/a.cpp in the page\n"), std::string::npos);
}

TEST(Claims, OfAProgramThatMustNotCompile) {
  const EvaluationOf found("```cpp file=examples/a.cpp expect=compile-error\nint main( {\n```\n",
                           {{"examples/a.cpp", "int main( {\n"}});
  EXPECT_EQ(told(found), "4 program proved: examples/a.cpp\n    compiled by " +
                             found.versions().compiler +
                             ", which refuses it, as the lesson says\n");
}

TEST(Claims, OfARegionThatStandsForItsProgram) {
  const std::string code =
      "#include <cstdio>\nint main() {\n  // #region r\n  std::puts(\"1\");\n  // #endregion\n}\n";
  const std::string region = "```cpp file=examples/a.cpp#r\nstd::puts(\"1\");\n```\n";
  const EvaluationOf found(region + "\n" + region, {{"examples/a.cpp", code}});
  const std::string ran = "    compiled by " + found.versions().compiler +
                          " without optimisation and run; exit code 0\n"
                          "    10 s, 1 MiB of output, no input, a folder of its own\n";
  const std::string compared =
      "    compared with these lines of examples/a.cpp, which was compiled and run\n"
      "    indentation does not count\n";
  EXPECT_EQ(told(found), "4 program proved: examples/a.cpp\n" + ran +
                             "4 region proved: examples/a.cpp#r\n" + compared +
                             "8 region proved: examples/a.cpp#r\n" + compared);
  // What runs is what the fence shows, and yet the file has other lines.
  EXPECT_EQ(
      told("```cpp file=examples/a.cpp#r\nstd::puts(\"2\");\n```\n", {{"examples/a.cpp", code}}),
      "4 program proved: examples/a.cpp\n" + ran + "4 region failed: examples/a.cpp#r\n");
}

TEST(Claims, OfWhatFailedAndWhatRestsOnIt) {
  EXPECT_EQ(told("```cpp file=examples/a.cpp\nint main() { return 1; }\n```\n\n```text\n1\n```\n",
                 {{"examples/a.cpp", "int main() { return 1; }\n"}}),
            "4 program failed: examples/a.cpp\n"
            "8 output failed: the output of a.cpp\n"
            "    what it rests on failed\n");
  // The program runs, and yet the lesson shows another one.
  EXPECT_EQ(told("```cpp file=examples/a.cpp\nint main() {}\n```\n",
                 {{"examples/a.cpp", "int main() { }\n"}}),
            "4 program failed: examples/a.cpp\n");
}

TEST(Claims, OfSnippets) {
  const EvaluationOf found(
      "> ```cpp snippet model=ball\n> std::puts(\"1\");\n> ```\n>\n> ```text\n> 1\n> ```\n");
  EXPECT_EQ(told(found),
            "4 snippet proved: snippet: std::puts(\"1\");\n    compiled by " +
                found.versions().compiler +
                " as the body of a function, and run by itself on ball.xml in its initial state; "
                "exit code 0\n"
                "    10 s, 1 MiB of output, no input, a folder of its own\n"
                "8 output proved: the output of the snippet above it\n"
                "    compared with what the snippet above it printed: 1 line, numbers to one unit "
                "in their last place\n");
}

TEST(Claims, OfModels) {
  EXPECT_EQ(told("```xml model=ball\n<mujoco>\n…\n```\n\n```xml mjcf\n<mujoco/>\n```\n\n"
                 "```xml mjcf expect=error\n<mujcoo/>\n```\n"),
            "4 listing proved: a part of models/ball.xml\n"
            "    compared line by line with models/ball.xml, which MuJoCo 2.2.2 compiles\n"
            "    indentation and blank lines do not count\n"
            "9 listing proved: a model\n"
            "    compiled by MuJoCo 2.2.2\n"
            "13 listing proved: a model\n"
            "    compiled by MuJoCo 2.2.2, which refuses it, as the lesson says\n");
}

TEST(Claims, OfValuesAndFormulas) {
  const EvaluationOf found("`{ball} model.nq` $x +\ny$ `{ball} model.nqq` $\\alhpa$\n");
  const std::string katex = found.versions().katex;
  EXPECT_EQ(std::count(katex.begin(), katex.end(), '.'), 2) << katex;
  EXPECT_EQ(told(found),
            "4 value proved: model.nq of ball\n"
            "    computed from ball.xml in its initial state: 8\n"
            "4 formula proved: x + y\n"
            "    typeset by KaTeX " +
                katex +
                "\n"
                "    that it is TeX, and not that it is true\n"
                "5 value failed: model.nqq of ball\n"
                "5 formula failed: \\alhpa\n");
}

TEST(Claims, OfLabsAndTheirPictures) {
  EXPECT_EQ(
      told("```lab simlab\n{\"title\": \"T\", \"model\": \"ball\", \"alt\": \"A.\", \"controls\": ["
           "{\"type\": \"button\", \"label\": \"b\", \"run\": \"data.qvel[0] = 1\"}], "
           "\"readouts\": [{\"label\": \"r\", \"expr\": \"data.time\"}]}\n```\n"),
      "4 lab proved: the lab “T”\n"
      "    rehearsed: 2 runs of 2 s, 1 readout\n"
      "    each control in each of its values by itself, a slider at both ends\n"
      "4 picture proved: the picture of the lab “T”\n"
      "    drawn by MuJoCo 2.2.2\n");
  EXPECT_EQ(
      told("```lab simlab\n{\"title\": \"T\", \"model\": \"ball\", \"alt\": \"A.\", \"readouts\": ["
           "{\"label\": \"r\", \"expr\": \"data.tmie\"}]}\n```\n"),
      "4 lab failed: the lab “T”\n");
}

TEST(Claims, OfFigures) {
  EXPECT_EQ(told("```figure\n{\"model\": \"ball\", \"alt\": \"A ball.\", \"size\": [64, 40], "
                 "\"seconds\": 0.1}\n```\n"),
            "4 picture proved: a figure: A ball.\n"
            "    drawn by MuJoCo 2.2.2 after 0.1 s\n");
  EXPECT_EQ(told("```figure\n{\"model\": \"ball\", \"alt\": \"A ball.\", \"keyframe\": "
                 "\"home\"}\n```\n"),
            "4 picture failed: a figure: A ball.\n");
}

TEST(Claims, OfPlots) {
  // Writes by itself what the helper header would, which takes long to compile.
  const std::string code =
      "#include <cstdlib>\n#include <fstream>\nint main() {\n"
      "  std::ofstream(std::getenv(\"MJCOURSE_RECORDS\"))\n"
      "      << R\"({\"table\": \"e\", \"value\": [[\"t\", [0, 1]], [\"y\", [2, 3]]]})\" "
      "<< '\\n';\n}\n";
  const auto plot = [](const std::string& field) {
    return "```plot\n{\"data\": {\"name\": \"a/e\"}, \"caption\": \"c\", \"alt\": \"A line.\", "
           "\"mark\": \"line\", \"encoding\": {\"x\": {\"field\": \"t\", \"type\": "
           "\"quantitative\"}, \"y\": {\"field\": \"" +
           field + "\", \"type\": \"quantitative\"}}}\n```\n";
  };
  const std::string found =
      told(plot("y") + "\n" + plot("z") + "\n```cpp file=examples/a.cpp\n```\n",
           {{"examples/a.cpp", code}});
  EXPECT_EQ(found.substr(0, found.find("12 program")),
            "4 plot proved: a plot: A line.\n"
            "    drawn by Vega from 2 rows that a.cpp reported as “e”\n"
            "8 plot failed: a plot: A line.\n");
}

TEST(Claims, OfImages) {
  EXPECT_EQ(told("![A cart](a.svg \"drawn by hand\") ![Gone](b.svg)\n",
                 {{"content/1-a/a.svg",
                   "<svg xmlns='http://www.w3.org/2000/svg' width='3' height='2'/>"}}),
            "4 image cited: a.svg: A cart\n"
            "    drawn by hand\n"
            "4 image failed: b.svg: Gone\n");
}

TEST(Claims, OfTheGlossary) {
  const EvaluationOf found(
      "A [[cart]].\n",
      {{"content/glossary.md",
        "---\ntitle: Words\n---\n## Cart\n\nIt has `{ball} model.nv` of $n_v$.\n"}});
  EXPECT_EQ(found.mistakes(), "");
  EXPECT_TRUE(found.claims().empty());
  EXPECT_EQ(told(found.evaluation().glossary.claims),
            "6 value proved: model.nv of ball\n"
            "    computed from ball.xml in its initial state: 7\n"
            "6 formula proved: n_v\n"
            "    typeset by KaTeX " +
                found.versions().katex + "\n    that it is TeX, and not that it is true\n");
  EXPECT_EQ(found.evaluation().glossary.tally.values, 1);
}

TEST(Claims, OfAnswers) {
  EXPECT_EQ(told(asked(", \"verify\": [{\"model\": \"ball\", \"value\": \"model.nq\"}]")),
            "5 answer proved: question 1: How many is nq?\n"
            "    ball.xml was built: model.nq = 8\n"
            "    to within 0.5\n");
  EXPECT_EQ(told(asked(", \"verify\": [{\"because\": \"a matter of taste\"}]")),
            "5 answer asserted: question 1: How many is nq?\n"
            "    to within 0.5\n"
            "    a matter of taste\n");
  EXPECT_EQ(told(asked(", \"verify\": [{\"model\": \"ball\", \"value\": \"model.nbody\"}]")),
            "5 answer failed: question 1: How many is nq?\n");
  EXPECT_EQ(
      told(quiz("{\"kind\": \"mcq\", \"q\": \"Q\", \"options\": [\"a\", \"b\"], \"answer\": 1, "
                "\"explain\": \"x\", \"verify\": [{\"model\": \"ball\", "
                "\"options\": [\"1 > 2\", \"2 > 1\"]}]}")),
      "5 answer proved: question 1: Q\n"
      "    simulated with ball.xml: B holds, and no other\n");
}

TEST(Claims, OfEstablishedFactsAndCodeThatNobodyRuns) {
  EXPECT_EQ(
      told("> [!established] A *fact*\n> Text.\n>\n> Source: [A book](https://x.org), p. 3\n\n"
           "> [!established]\n> Text.\n\n> [!note] Nothing\n> claimed.\n\n"
           "```cpp unchecked because=\"needs a GPU\"\nx;\n```\n\n```sh unchecked\nls\n```\n"),
      "4 citation cited: A fact\n"
      "    A book, p. 3 <https://x.org>\n"
      "9 citation asserted: a fact\n"
      "15 code unchecked: cpp: x;\n"
      "    needs a GPU\n"
      "19 code unchecked: sh: ls\n");
}

TEST(Claims, KnowTheSameByItsKey) {
  const std::string value = "`{ball} model.nq`\n";
  EXPECT_EQ(key(value), key("Moved down.\n\n" + value));
  EXPECT_NE(key(value), key("`{ball} model.nv`\n"));
  EXPECT_NE(key(value), key("`{ball} model.nq:.1f`\n"));
  std::string heavier = kBall;
  heavier.replace(heavier.find("0.1"), 3, "0.2");
  EXPECT_NE(key(value), key(value, {{"models/ball.xml", heavier}}));
  EXPECT_EQ(key("$x$\n"), key("$x$\n", {{"models/ball.xml", heavier}}));
}

TEST(Claims, CoverInTheirKeysWhatAProgramWasMadeOf) {
  const std::string fence = "```cpp file=examples/a.cpp\n```\n";
  const std::map<std::string, std::string> files{{"examples/a.cpp", kHello}};
  const std::string first = key(fence, files);
  EXPECT_EQ(first, key(fence, files));
  EXPECT_NE(first, key("```cpp file=examples/a.cpp timeout=9\n```\n", files));
  EXPECT_NE(first, key(fence, {{"examples/a.cpp", std::string(kHello) + "// more\n"}}));
  std::map<std::string, std::string> more = files;
  more["examples/include/mjcourse/mjcourse.hpp"] = "#pragma once\n";
  EXPECT_NE(first, key(fence, more));
  more = files;
  more["models/other.xml"] = "<mujoco/>\n";  // which it does not name
  EXPECT_EQ(first, key(fence, more));
  more["models/ball.xml"] = "<mujoco/>\n";
  EXPECT_NE(first, key(fence, more));
}

TEST(Strict, MindsWhatHasNoReason) {
  const auto minded = [](const std::string& body) {
    return shown(unreasoned(EvaluationOf(body).claims()));
  };
  EXPECT_EQ(minded("$x$\n\n```sh unchecked because=\"no\"\nls\n```\n\n" +
                   asked(", \"verify\": [{\"because\": \"no\"}]")),
            "");
  EXPECT_EQ(
      minded("```sh unchecked\nls\n```\n"),
      R"(content/1-a/1.1-x.md:4:1: error: nobody runs this code, and nothing says why [E-strict-unchecked]
  4 | ```sh unchecked
    | ^~~~~~~~~~~~~~~
  cure: let the build run it; or say why it cannot: `unchecked because="…"`
)");
  EXPECT_EQ(
      minded("> [!established] F\n> Text.\n"),
      R"(content/1-a/1.1-x.md:4:5: error: nothing says where this established fact is from [E-strict-asserted]
  4 | > [!established] F
    |     ^~~~~~~~~~~
  cure: end the callout with a paragraph `Source: …`
)");
  EXPECT_EQ(EvaluationOf(asked("")).tally().answers_asserted, 1);
  EXPECT_NE(minded(asked("")).find("the answer of question 1 is only asserted"), std::string::npos);
}

}  // namespace
}  // namespace mjcourse

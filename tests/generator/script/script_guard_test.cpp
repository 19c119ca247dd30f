#include "script/script_guard.h"

#include <gtest/gtest.h>

#include "bundle.h"
#include "script/author_text.h"

namespace mjcourse {
namespace {

const std::vector<std::string> kScriptNames{"data", "model", "step", "key$", "own$"};

// What is run of `text`, or "id line:column+width message | cure".
std::string guarded(const std::string& text, ScriptKind kind = ScriptKind::script) {
  static ScriptGuard guard(bundle("guard"));
  const auto safe = guard.guard(text, kind, kScriptNames);
  if (safe) return safe->text;
  const ScriptError& error = safe.error();
  return error.id + " " + std::to_string(error.line) + ":" + std::to_string(error.column) + "+" +
         std::to_string(error.width) + " " + error.message +
         (error.cure.empty() ? "" : " | " + error.cure);
}

TEST(ScriptGuardTest, LeavesWhatItsTextTells) {
  EXPECT_EQ(guarded("const x = data.qpos[0]; step(2); // é"),
            "const x = data.qpos[0]; step(2); // é");
  EXPECT_EQ(guarded("[1, 2].map((x) => x + 1).length", ScriptKind::value),
            "[1, 2].map((x) => x + 1).length");
}

TEST(ScriptGuardTest, AsksWhatItsTextDoesNot) {
  EXPECT_EQ(guarded("for (let i = 0; i < 2; i++) data.qpos[i] = data.qvel[i + 1];"),
            "for (let i = 0; i < 2; i++) own$((data.qpos))/*$*/[key$((i))/*$*/] = "
            "data.qvel[key$((i + 1))/*$*/];");
  EXPECT_EQ(guarded("data.ctrl[0]", ScriptKind::value), "data.ctrl[0]");
  EXPECT_EQ(guarded("data.ctrl[0]", ScriptKind::assignment), "own$((data.ctrl))/*$*/[0]");
  EXPECT_EQ(without_guards("own$((data.ctrl))/*$*/[key$((i))/*$*/] = 1"), "data.ctrl[i] = 1");
}

TEST(ScriptGuardTest, KnowsWhereTheTextIsWithoutGuards) {
  const std::string text = "own$((data.ctrl))/*$*/[key$((i))/*$*/] = 1";
  const std::string own = without_guards(text);
  EXPECT_EQ(place_without_guards(text, 0), 0U);
  EXPECT_EQ(place_without_guards(text, text.find("data") + 5), own.find("ctrl"));
  for (const std::size_t within : {0U, 1U, 7U}) {
    const std::size_t at = text.find("))/*$*/]") + within;
    EXPECT_EQ(place_without_guards(text, at), own.find(']')) << within;
  }
  EXPECT_EQ(place_without_guards(text, 999), own.size());
}

TEST(ScriptGuardTest, RefusesAtItsPlace) {
  EXPECT_EQ(guarded("step(1);\nconst é = document.body;"),
            "E-script-name 2:11+8 `document` does not exist | known: é, data, model, step");
  EXPECT_EQ(guarded("stp()"), "E-script-name 1:1+3 `stp` does not exist | did you mean `step`?");
  EXPECT_EQ(guarded("step.constructor('return this')()"),
            "E-script-foreign 1:6+11 a lab's script cannot use `constructor`");
  EXPECT_EQ(guarded("import('https://a.example/x.js')"),
            "E-script-foreign 1:1+32 a lab's script cannot use `import`");
  EXPECT_EQ(guarded("const o = Object"),
            "E-script-foreign 1:11+6 a lab's script cannot use `Object` by itself | use "
            "`Object.entries`, `Object.fromEntries`, `Object.hasOwn`, `Object.is`, `Object.keys`, "
            "`Object.values`");
  EXPECT_EQ(guarded("Array = 1"),
            "E-script-value 1:1+5 `Array` cannot be assigned | it belongs to JavaScript");
  EXPECT_EQ(guarded("key$((1))"), "E-script-foreign 1:1+5 a script cannot hold `key$(`");
  EXPECT_EQ(guarded("a) = 1, (b", ScriptKind::assignment),
            "E-script-syntax 0:0+1 a closing bracket has no opening one | remove it, or open it");
}

TEST(ScriptGuardTest, RefusesWhereATextDoesNotParse) {
  EXPECT_EQ(guarded("const a = 1;\n}\nconst b = 2;"),
            "E-script-syntax 2:1+1 a closing bracket has no opening one | remove it, or open it");
  EXPECT_EQ(
      guarded("const a = 1;\nconst é = 2, a = 3;"),
      "E-script-syntax 2:14+1 Identifier 'a' has already been declared | choose another name");
  EXPECT_EQ(guarded("const s = 'abc;\nstep(1);"),
            "E-script-syntax 1:11+1 Unterminated string constant | look for a missing bracket, "
            "quote or operator just before this");
  EXPECT_EQ(
      guarded("if (1) {\n  step(1);"),
      "E-script-syntax 0:0+1 Unexpected token | look for a missing bracket, quote or operator "
      "just before this");
}

TEST(ScriptGuardTest, TellsWhatDefinitionsDeclare) {
  static ScriptGuard guard(bundle("guard"));
  const auto found = guard.guard("const a = 1, [b] = [2];\nfunction f(x) { return data.qpos[x]; }",
                                 ScriptKind::definitions, kScriptNames);
  EXPECT_EQ(found.value().text,
            "const a = 1, [b] = [2];\nfunction f(x) { return data.qpos[key$((x))/*$*/]; }");
  EXPECT_EQ(found->declared, (std::vector<std::string>{"a", "b", "f"}));
  const std::string refused =
      " `define` declares functions and constants, and does nothing else | begin with `const` or "
      "`function`; what runs belongs into a control's script";
  EXPECT_EQ(guarded("const a = 1;\nstep(1);", ScriptKind::definitions),
            "E-lab-define 2:1+8" + refused);
  EXPECT_EQ(guarded("let a = 1;", ScriptKind::definitions), "E-lab-define 1:1+10" + refused);
}

// "world callee(values)", as far as it is so.
std::string asked(const std::string& value, const std::string& run = "") {
  static ScriptGuard guard(bundle("guard"));
  const auto found = guard.ask(run, value, {"data", "model", "qpos", "Math", "mju_rotVecQuat"});
  if (!found) return "nothing";
  return std::string(found->world ? "world" : "") +
         (found->callee.empty() ? "" : " " + found->callee + "(" + found->values + ")");
}

TEST(ScriptGuardTest, TellsWhetherAnExpressionAsksTheWorld) {
  EXPECT_EQ(asked("data.qpos[0]"), "world");
  EXPECT_EQ(asked("[1, 2].map(i => qpos('a')[i])"), "world");
  EXPECT_EQ(asked("x.length", "const x = [...model.qpos0];"), "world");
  EXPECT_EQ(asked("9.81 * Math.sin(0.5)", "const unused = data.qpos[0];"), "");
  EXPECT_EQ(asked("({model: 1}).model"), "");
  EXPECT_EQ(asked("`${data.time}` === '0'"), "world");
  EXPECT_EQ(asked("mju_rotVecQuat(a, [1, 0, 0], b)", "const a = [], b = [1, 0, 0, 0];"), "");
  EXPECT_EQ(asked("1 +"), "nothing");
}

TEST(ScriptGuardTest, TellsWhatAFunctionOfTheAuthorsIsAskedAbout) {
  const std::string run = "const near = (a, b) => a === data.qpos[b];";
  EXPECT_EQ(asked("near([1, 2], 0 )", run), "world near([1, 2], 0)");
  EXPECT_EQ(asked("near(1, 0) && near(2, 0)", run), "world");
  EXPECT_EQ(asked("qpos('a')", run), "world");
  EXPECT_EQ(asked("near()", run), "world");
}

// A mistake that is found while guarded text runs is shown in the author's.
TEST(ScriptGuardTest, IsNotSeenInMessages) {
  const AuthorText text("own$((data.a))/*$*/[0] = data.a");
  EXPECT_EQ(text.lines().text(), "data.a[0] = data.a");
  Exception exception;
  exception.column = 11;  // of the first dot, in the text that is run
  exception.tokens = {"data.a"};
  ScriptError error;
  text.point_at(exception, 1, error);
  EXPECT_EQ(error.column, 1);
}

}  // namespace
}  // namespace mjcourse

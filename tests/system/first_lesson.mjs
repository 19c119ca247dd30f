// The guide's first chapter, step by step, as a newcomer follows it in this course: its commands, the
// lesson that they begin, the same lesson by hand, and the wrong answer that it tells to try.
//
//   node tests/system/first_lesson.mjs MJCOURSE COURSE

import { spawnSync } from "node:child_process";
import { cpSync, existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const [mjcourse, course] = process.argv.slice(2);
const chapter = readFileSync(
  join(course, "content/guide/A.1-a-lesson-in-fifteen-minutes.md"),
  "utf8",
);
const folder = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
const copy = join(folder, "course");

const failures = [];
const expect = (good, what) => good || failures.push(what);

function run(args) {
  const { status, stdout, stderr } = spawnSync(mjcourse, args, { encoding: "utf8", cwd: copy });
  return { status, said: stdout + stderr };
}

function check(what, expected) {
  const { status, said } = run(["check"]);
  const mistakes = said.split("\n").filter((line) => / (error|warning): /.test(line));
  expect(status === (expected === undefined ? 0 : 1), `${what}: check exits with ${status}`);
  const right = expected === undefined ? mistakes.length === 0 : mistakes.join().includes(expected);
  expect(right, `${what}: check says ${mistakes.join("; ") || "nothing"}`);
}

// `./mjcourse new model two_rods   # models/two_rods.xml`
const commands = [...chapter.matchAll(/^\.\/mjcourse ((?:new|init) [^#\n]*)/gm)].map(([, line]) =>
  [...line.matchAll(/"([^"]*)"|(\S+)/g)].map(([, quoted, word]) => quoted ?? word),
);
// The parts of a lesson that the chapter shows, in their fences of five.
const demos = [...chapter.matchAll(/^````demo\n([^]*?)^````$/gm)].map(([, text]) => text);
const program = demos.find((text) => text.includes("```cpp")) ?? "";
const quiz = (demos.find((text) => text.includes("```quiz")) ?? "").replace("A.1-first", "mine");

try {
  for (const part of ["content", "examples", "models"]) {
    cpSync(join(course, part), join(copy, part), { recursive: true });
  }
  expect(commands.length === 6, `the chapter has ${commands.length} commands that begin something`);
  for (const command of commands) {
    const { status, said } = run(command);
    expect(status === 0, `\`${command.join(" ")}\` exits with ${status}: ${said}`);
  }
  const lesson = /Or make `([^`]*)` by hand/.exec(chapter)?.[1] ?? "";
  const path = join(copy, lesson);
  expect(existsSync(path), `the commands make no \`${lesson}\``);
  expect(existsSync(join(folder, "my-course/content/course.yaml")), "there is no course beside it");
  check("what the commands begin");

  writeFileSync(path, `---\ntitle: A pendulum\n---\n\n${program}\n${quiz}`);
  check("the lesson by hand");

  const wrong = quiz.replace('"answer": 8', '"answer": 7');
  expect(wrong !== quiz, "the chapter's question has another answer");
  writeFileSync(path, `---\ntitle: A pendulum\n---\n\n${program}\n${wrong}`);
  check("7 instead", "the answer is given as 7, but the build finds 8 [E-quiz-answer]");
} finally {
  rmSync(folder, { recursive: true, force: true });
}
for (const failure of failures) console.error(failure);
console.log(`${failures.length} problems`);
process.exit(failures.length === 0 ? 0 : 1);

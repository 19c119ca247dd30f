// A class is graded into a folder: what was judged is kept when the work is stopped, strays are told
// and end nothing, and each student gets a letter.
//
//   node tests/system/grade_class.mjs MJCOURSE

import { spawn, spawnSync } from "node:child_process";
import {
  cpSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  symlinkSync,
  truncateSync,
  utimesSync,
  writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";

const mjcourse = resolve(process.argv[2]);
const course = join(import.meta.dirname, "../courses/exercise/right");
const folder = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
const solution = readFileSync(join(course, "examples/fall.cpp"), "utf8");
let failed = 0;

function expect(good, what) {
  if (good) return;
  ++failed;
  console.error(what);
}

function expectText(is, should, what) {
  expect(is === should, `${what} is\n${is}\nand should be\n${should}`);
}

const program = (code) =>
  solution.replace(/(#region answer\n)[^]*?(\n {2}\/\/ #endregion)/, (_, a, b) => a + code + b);

function handIn(name, code, file = "fall.cpp") {
  mkdirSync(join(folder, name), { recursive: true });
  const path = join(folder, name, file);
  writeFileSync(path, program(code));
  utimesSync(path, new Date("2026-11-20T12:00:00Z"), new Date("2026-11-20T12:00:00Z"));
}

const right = "  return 9.81 * t * t / 2;";
handIn("ann", right);
handIn("bob", "  return 9.81 * t / 2;");
handIn("-dash", `${right}  // mine`);
handIn("eva maria", "  return 0 +;");
handIn("late", `${right}  // late`);
utimesSync(join(folder, "late/fall.cpp"), 1e9, new Date("2026-11-20T14:05:00Z"));
handIn("near", right, "my_fall.cpp");
mkdirSync(join(folder, "nothing"));
symlinkSync("ann", join(folder, "zoe"));
writeFileSync(join(folder, "readme.txt"), "");
for (let i = 0; i < 6; ++i) handIn(`own-${i}`, `  return 9.81 * t * t / 2 + ${i}e-15;`);

const words = ["grade", ...readdirSync(folder).sort(), "--against", course, "--out", "results"];
const options = { cwd: folder, encoding: "utf8" };
const verdicts = join(folder, "results/verdicts");
const count = () => (existsSync(verdicts) ? readdirSync(verdicts).length : 0);

// It is killed in the middle of the work.
const first = spawn(mjcourse, [...words, "--jobs", "1"], { cwd: folder, stdio: "ignore" });
const ended = new Promise((end) => first.on("exit", (code, signal) => end(signal)));
while (count() < 3 && first.exitCode === null) await new Promise((wait) => setTimeout(wait, 20));
first.kill("SIGKILL");
expect((await ended) === "SIGKILL", "it was done before it was killed");
// Half a verdict, as a kill in the middle of its writing leaves it, is judged again.
const isWhole = (name) => {
  try {
    return Boolean(JSON.parse(readFileSync(join(verdicts, name), "utf8")));
  } catch {
    return false;
  }
};
const [half, ...kept] = readdirSync(verdicts).filter(isWhole);
truncateSync(join(verdicts, half), 20);
const takenUp =
  kept.length === 1
    ? "1 verdict of an earlier run is"
    : `${kept.length} verdicts of an earlier run are`;

const due = ["--due", "2026-11-20T12:00Z"];
const { status, stderr } = spawnSync(mjcourse, [...words, ...due], options);
expect(status === 0, `it ends with ${status}: ${stderr}`);
const seed = readFileSync(join(folder, "results/seed"), "utf8").trim();
expect(readdirSync(verdicts).length === 11, `${count()} verdicts`);
const shown = (text) =>
  text
    .replace(/^\d+ of \d+ texts judged, \d+ s to go\n/gm, "")
    .replace(`are in ${join(folder, "results")}`, "are in RESULTS");
expectText(
  shown(stderr),
  `note: readme.txt is no folder, and left out
note: near: my_fall.cpp has the name of no exercise: is it fall.cpp?
note: nothing: the folder is empty, or cannot be read
note: ${takenUp} taken up again
note: tables, and a letter for each student, are in RESULTS
note: the inputs of checks were drawn from --seed ${seed}
`,
  "what it says",
);
expectText(
  readFileSync(join(folder, "results/students.csv"), "utf8").replaceAll("\r", ""),
  `student,points,of,fall,own_word,late,missing,remark
'-dash,4,4,4,0,,,
ann,4,4,4,0,,,
bob,2,4,2,0,,,
eva maria,0,4,0,0,,,fall: expected expression in line 7
late,4,4,4,0,fall: 2 h 5 min late,,
near,0,4,0,0,,fall,
nothing,0,4,0,0,,fall,
own-0,4,4,4,0,,,
own-1,4,4,4,0,,,
own-2,4,4,4,0,,,
own-3,4,4,4,0,,,
own-4,4,4,4,0,,,
own-5,4,4,4,0,,,
zoe,0,4,0,0,,fall,"it is a link, and may lead to another's"
`,
  "the table of students",
);
expectText(
  readFileSync(join(folder, "results/letters/bob.md"), "utf8"),
  `# bob

2 of 4 points.

## Falling: 2 of 4 points

\`fall.cpp\`, lesson 1.1.

- ✓ it falls 4.9 m in the first second (2 points)
- ✗ twice the time is four times the way (1 point)  
  it is 9.81, and should be 19.62 ± 1e\\-09: off by 9.8

Checks that the page does not show:

- ✗ it falls 5 cm in 0.1 s (1 point)
`,
  "a letter",
);
expect(readdirSync(join(folder, "results/letters")).length === 14, "letters are missing");

// In another course the hidden program has a number for what is 1 in the shown one. A letter does not
// tell it, and what may have been short of time is judged twice and not kept.
const other = join(folder, "other course");
cpSync(course, other, { recursive: true });
const edit = (path, from, to) => {
  const text = readFileSync(join(other, path), "utf8");
  expect(text.includes(from), `${path} has no ${from}`);
  writeFileSync(join(other, path), text.replace(from, to));
};
edit("examples/fall.cpp", "double fallen", "constexpr long kScale = 1;\n\ndouble fallen");
edit(
  "examples/fall_hidden.cpp",
  "double fallen",
  "constexpr long kScale = 723400;\n\ndouble fallen",
);
edit("content/1-basics/1.1-lesson.md", "hidden=", "timeout=5 hidden=");
handIn(
  "peek",
  `  struct Known { using secret = int; };
  std::conditional_t<kScale == 1, Known, std::integral_constant<long, kScale>>::secret zero = 0;
  return 9.81 * t * t / 2 + zero;`,
);
handIn("endless", "  for (volatile int i = 0;; i = 1) {}");
const peeking = spawnSync(
  mjcourse,
  ["grade", "peek", "endless", "--against", other, "--out", "others"],
  options,
);
expect(
  readFileSync(join(folder, "others/grades.json"), "utf8").includes("723400>"),
  `the teacher hears no compiler: ${peeking.stdout}${peeking.stderr}`,
);
expectText(
  readFileSync(join(folder, "others/letters/peek.md"), "utf8"),
  `# peek

3 of 4 points.

## Falling: 3 of 4 points

\`fall.cpp\`, lesson 1.1.

- ✓ it falls 4.9 m in the first second (2 points)
- ✓ twice the time is four times the way (1 point)

Checks that the page does not show, with which the program did not compile:

- ✗ it falls 5 cm in 0.1 s (1 point)
`,
  "a letter on a hidden program",
);
expect(
  peeking.stderr.includes(
    "note: 1 text may have been short of time or memory, and is judged once more, alone\n",
  ) && readdirSync(join(folder, "others/verdicts")).length === 1,
  `a verdict of a timeout is kept: ${peeking.stderr}`,
);

// All is known now; what was changed is judged again.
handIn("bob", `${right}  // bob`);
const before = readFileSync(join(folder, "results/checks.csv"), "utf8");
const again = spawnSync(mjcourse, [...words, "--format", "csv"], options);
expect(
  again.stderr.includes("note: 10 verdicts of an earlier run are taken up again\n"),
  again.stderr,
);
expect(
  again.stdout !== before &&
    again.stdout.includes("bob,1.1,fall,it falls 5 cm in 0.1 s,yes,no,yes,1,1,no,"),
  again.stdout,
);

// A link in the folder of the results leads nowhere.
rmSync(join(folder, "results/letters"), { recursive: true });
mkdirSync(join(folder, "elsewhere"));
symlinkSync("../elsewhere", join(folder, "results/letters"));
const linked = spawnSync(mjcourse, words, options);
expect(linked.status === 1 && readdirSync(join(folder, "elsewhere")).length === 0, linked.stderr);
rmSync(folder, { recursive: true });
console.log(`${words.length} words, ${failed} problems`);
process.exitCode = failed > 0 ? 1 : 0;

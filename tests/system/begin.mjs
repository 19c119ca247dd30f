// A course is begun and goes on: what `init` and `new` write holds at once, also by --strict, and
// nothing that was there is touched.
//
//   node --test tests/system/begin.mjs     the generator is named by the environment: MJCOURSE

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import {
  existsSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { after, test } from "node:test";

const mjcourse = resolve(process.env.MJCOURSE ?? "build/release/generator/mjcourse");
let called = ""; // by which name, as the launcher says it
const folder = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
after(() => rmSync(folder, { recursive: true }));

// What it says, as [exit code, stdout, stderr].
function runIn(cwd, ...words) {
  const { status, stdout, stderr } = spawnSync(mjcourse, words, {
    cwd,
    encoding: "utf8",
    env: { ...process.env, MJCOURSE_CALLED: called },
  });
  return [status, stdout, stderr];
}
const run = (...words) => runIn(folder, ...words);
const read = (path) => readFileSync(join(folder, path), "utf8");

// Clean, and no word about a warning; gives the lines of the lessons.
function check() {
  const [status, stdout, stderr] = run("check", "--strict", "--course", "rigid-bodies");
  assert.equal(stderr, "");
  assert.equal(status, 0);
  return stdout.split("\n").filter((line) => line.startsWith("ok "));
}

test("init begins a course", () => {
  const [status, stdout, stderr] = run("init", "rigid-bodies");
  assert.equal(stderr, "");
  assert.equal(status, 0);
  assert.equal(
    stdout,
    `wrote .github/workflows/course.yml
wrote .github/actions/mjcourse/action.yml
wrote README.md
wrote .gitignore
wrote content/1-first-steps/1.1-a-pendulum.md
wrote content/course.yaml
wrote models/pendulum.xml
wrote examples/l1_1_a_pendulum.cpp
wrote examples/CMakeLists.txt
wrote examples/include/mjcourse/mjcourse.hpp
wrote examples/include/mjcourse/handlers.cpp
now: \`mjcourse check --course rigid-bodies\`, and read its README.md
`,
  );
  assert.match(read("rigid-bodies/README.md"), /^# Rigid bodies\n/);
  assert.match(read("rigid-bodies/content/course.yaml"), /^title: "Rigid bodies"$/m);
  assert.deepEqual(check(), [
    "ok    1.1  A pendulum: 1 program run, 1 in the page, 1 output compared, 2 values computed, 1 answer proved, 1 lab rehearsed, 1 picture drawn, 2 formulas set",
  ]);
});

test("new adds to it", () => {
  const before = read("rigid-bodies/content/course.yaml");
  const course = ["--course", "rigid-bodies"];
  assert.deepEqual(run("new", "level", "2-dynamics", "Dynamics: how things move", ...course), [
    0,
    'added to content/course.yaml\nits first lesson: `mjcourse new lesson 2-dynamics "TITLE"`\n',
    "",
  ]);
  assert.deepEqual(run("new", "lesson", "2-dynamics", 'Forces, "torques" & more', ...course), [
    0,
    `wrote content/2-dynamics/2.1-forces-torques-more.md
wrote examples/l2_1_forces_torques_more.cpp
wrote models/forces_torques_more.xml
added to content/course.yaml
it is a draft: \`mjcourse check\` proves it, and the site does not have it until its line \`draft: true\` is gone
`,
    "",
  ]);
  assert.deepEqual(run("new", "lesson", "1.2-two-rods", ...course)[0], 0);
  assert.deepEqual(run("new", "model", "one_more", ...course)[0], 0);
  assert.deepEqual(run("new", "example", "one_more", ...course)[0], 0);
  assert.deepEqual(run("new", "exercise", "weigh", "pendulum", ...course), [
    0,
    `wrote examples/weigh.cpp
a lesson asks for it with an empty fence \`cpp exercise file=examples/weigh.cpp#answer\` in an \`[!exercise]\`, and \`mjcourse check\` proves its starter, its solution and its wrong variants
`,
    "",
  ]);
  const lesson = "rigid-bodies/content/1-first-steps/1.1-a-pendulum.md";
  writeFileSync(
    join(folder, lesson),
    `${read(lesson)}\n\`\`\`cpp exercise file=examples/weigh.cpp#answer\n\`\`\`\n`,
  );
  assert.equal(
    read("rigid-bodies/content/course.yaml"),
    before +
      `      - 1.2-two-rods
  - folder: 2-dynamics
    title: "Dynamics: how things move"
    lessons: [2.1-forces-torques-more]
`,
  );
  assert.match(read("rigid-bodies/examples/one_more.cpp"), /load_model\("one_more"\)/);
  const lessons = check();
  assert.equal(lessons.length, 3);
  assert.match(lessons[0], /1\.1 {2}A pendulum: 2 programs run, 2 in the page, 1 exercise tried, /);
  assert.match(lessons[1], /1\.2 {2}Two rods: 1 program run, .*; a draft, not in the site$/);
  assert.match(lessons[2], /2\.1 {2}Forces, "torques" & more: 1 program run, /);
});

test("what is there stays", () => {
  const course = ["--course", "rigid-bodies"];
  const before = read("rigid-bodies/content/course.yaml");
  assert.deepEqual(run("new", "model", "pendulum", ...course), [
    1,
    "",
    "mjcourse: models/pendulum.xml is there already, so nothing was written\n" +
      "  cure: choose another name, or move that file away\n",
  ]);
  writeFileSync(join(folder, "rigid-bodies/models/fall.xml"), "mine\n");
  assert.equal(run("new", "lesson", "2-dynamics/fall", ...course)[0], 1);
  assert.equal(read("rigid-bodies/models/fall.xml"), "mine\n");
  assert.equal(existsSync(join(folder, "rigid-bodies/examples/l2_2_fall.cpp")), false);
  assert.equal(read("rigid-bodies/content/course.yaml"), before);
  assert.deepEqual(run("init", "rigid-bodies"), [
    1,
    "",
    "mjcourse: rigid-bodies is not empty: it has .github\n" +
      "  cure: name a new or an empty folder; `mjcourse new` adds to a course\n",
  ]);
});

test("what there is to type begins as the reader typed it", () => {
  called = "../here/mjcourse";
  assert.match(run("init", "called")[1], /^now: `\.\.\/here\/mjcourse check --course called`/m);
  const lesson = join(folder, "called/content/1-first-steps/1.1-a-pendulum.md");
  writeFileSync(lesson, readFileSync(lesson, "utf8").replace("[-0.12]", "[-0.19]"));
  assert.match(
    run("check", "--course", "called")[2],
    /cure: if the program is right, `\.\.\/here\/mjcourse accept` writes its lines here\n/,
  );
  called = "";
});

test("init takes a new repository, and no file", () => {
  mkdirSync(join(folder, "empty/.git"), { recursive: true });
  assert.equal(run("init", "empty/", 'A "course": 2')[0], 0);
  assert.match(read("empty/content/course.yaml"), /^title: "A \\"course\\": 2"$/m);
  assert.deepEqual(run("init", "empty/README.md"), [
    1,
    "",
    "mjcourse: empty/README.md is not a folder\n  cure: name a new or empty one\n",
  ]);
  assert.deepEqual(run("init"), [
    2,
    "",
    'mjcourse: init needs a folder\n  cure: as in `mjcourse init my-course "My course"`\n',
  ]);
  assert.deepEqual(run("new", "model", "x", "--course", "nowhere"), [
    1,
    "",
    "mjcourse: there is no course here: content/course.yaml: No such file or directory\n" +
      "  cure: name its folder with --course DIR, or begin one: `mjcourse init DIR`\n",
  ]);
});

test("init follows no link of a checkout", () => {
  mkdirSync(join(folder, "repository/.git"), { recursive: true });
  mkdirSync(join(folder, "elsewhere"));
  const inside = join(folder, "repository");
  symlinkSync(join(folder, "elsewhere"), join(inside, "link"));
  for (const named of ["link", "link/deep"]) {
    assert.deepEqual(runIn(inside, "init", named), [
      1,
      "",
      `mjcourse: ${join(inside, "link")} is a link, so nothing is written there\n` +
        "  cure: name a folder elsewhere\n",
    ]);
  }
  assert.deepEqual(readdirSync(join(folder, "elsewhere")), []);
  // A link of the user's.
  symlinkSync(join(folder, "elsewhere"), join(folder, "mine"));
  assert.equal(run("init", "mine")[0], 0);
});

// The scripts of a workflow's or an action's steps, by their names.
function stepsOf(workflow) {
  const steps = new Map();
  let name = "";
  for (const [, named, block, line] of workflow.matchAll(
    /^ +- name: (.*)$|^ +run: \|\n((?: {8}.*\n|\n)+)|^ +run: (?!\|)(.+)$/gm,
  )) {
    if (named !== undefined) name = named;
    else steps.set(name, block?.replaceAll(/^ {8}/gm, "") ?? line);
  }
  return steps;
}

test("its workflow asks for the tool, and is told where that is", () => {
  const workflow = stepsOf(read("rigid-bodies/.github/workflows/course.yml"));
  const steps = stepsOf(read("rigid-bodies/.github/actions/mjcourse/action.yml"));
  assert.equal(workflow.size, 4);
  assert.equal(steps.size, 3);
  for (const [name, script] of [...workflow, ...steps]) {
    const parsed = spawnSync("bash", ["-n"], { input: script, encoding: "utf8" });
    assert.equal(parsed.stderr, "", name);
  }
  const output = join(folder, "output");
  const find = (env) =>
    spawnSync("bash", ["-e", "-c", steps.get("Find out which mjcourse")], {
      env: { PATH: process.env.PATH, GITHUB_OUTPUT: output, ...env },
      encoding: "utf8",
    });
  const asked = find({});
  assert.equal(asked.status, 1);
  assert.match(asked.stdout, /^::error file=\.github\/workflows\/course\.yml::where is mjcourse\?/);
  assert.equal(find({ MJCOURSE_DEB: "file:///x.deb" }).status, 0);
  assert.equal(readFileSync(output, "utf8"), "version=file:///x.deb\n");
});

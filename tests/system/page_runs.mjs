// Programs are run once more as a reader's page does it: the real compiler and engine, on a course of
// two programs. What was found is kept, a changed program is run again, a program that no page runs
// takes the compiler out of the site, and without the compiler the check says so and the site is made.
//
//   node tests/system/page_runs.mjs MJCOURSE ASSETS

import { spawnSync } from "node:child_process";
import {
  cpSync,
  existsSync,
  globSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";

const [mjcourse, assets] = process.argv.slice(2);
if (!existsSync(join(assets, "cpp/version"))) {
  console.log("the compiler of the page was not built");
  process.exit(77); // skipped
}
const home = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
const course = join(home, "course");
const failures = [];
function expect(good, what) {
  if (!good) failures.push(what);
}

function write(path, text) {
  mkdirSync(dirname(join(course, path)), { recursive: true });
  writeFileSync(join(course, path), text);
}

// The program reads a model, is given arguments, reports, and ends with a code of its own.
function writeProgram(name, word, options = "") {
  const code = `#include <mjcourse/mjcourse.hpp>

int main(int count, char** words) {
  const mjcourse::Model model = mjcourse::load_model("ball");
  const mjcourse::Data data = mjcourse::make_data(model);
  mj_step(model, data);
  std::printf("${word} %s %.3f\\n", words[count - 1], data->qpos[2]);
  mjcourse::result("height", data->qpos[2]);
  return 3;
}
`;
  write(`examples/${name}.cpp`, code);
  return `\`\`\`cpp file=examples/${name}.cpp args="one two" expect=exit:3${options}\n\`\`\`\n`;
}

function writeLesson(...fences) {
  write("content/1-a/1.1-x.md", `---\ntitle: X\n---\n\n${fences.join("\n")}`);
}

function run(command, words = [], environment = {}) {
  const store = ["--course", course, "--store", join(home, "store")];
  const { status, stdout, stderr } = spawnSync(mjcourse, [command, ...store, ...words], {
    encoding: "utf8",
    env: { ...process.env, ...environment },
  });
  console.log(stderr + stdout);
  return { status, said: stderr + stdout };
}

function build(environment) {
  const { status, said } = run("build", ["--out", join(home, "site")], environment);
  const page = status === 0 ? readFileSync(join(home, "site/1-a/1.1-x.html"), "utf8") : "";
  const compiler = globSync("assets/llvm-*", { cwd: join(home, "site") }).length;
  return { status, said, page, compiler };
}

// Why no page runs the programs of the tiny course for that.
function reasons() {
  const tiny = join(import.meta.dirname, "../courses/page/cannot");
  const { stdout } = spawnSync(mjcourse, ["check", "--format=json", "--course", tiny], {
    encoding: "utf8",
  });
  const claims = JSON.parse(stdout).lessons.flatMap((lesson) => lesson.claims);
  return claims.filter(({ kind }) => kind === "page").map(({ reason }) => reason);
}

// The assets as where the compiler could not be made.
function assetsWithout() {
  const folder = join(home, "assets");
  cpSync(assets, folder, { recursive: true, filter: (path) => path !== join(assets, "cpp") });
  return folder;
}

try {
  write("content/course.yaml", "title: T\nlevels: [{folder: 1-a, title: A, lessons: [1.1-x]}]\n");
  write(
    "models/ball.xml",
    '<mujoco><worldbody><body pos="0 0 1"><freejoint/><geom size="0.1"/></body></worldbody></mujoco>\n',
  );
  writeLesson(writeProgram("a", "a"), writeProgram("b", "b"));
  const first = build();
  expect(first.status === 0, "the course does not hold");
  expect(first.said.includes("2 programs run, 2 in the page"), "two are not run in the page");
  expect(first.page.includes("data-program="), "no program can be run in its page");
  expect(first.compiler === 1, "the site has no compiler");

  writeLesson(writeProgram("a", "a"), writeProgram("b", "changed"));
  const changed = run("check");
  expect(changed.said.includes("2 programs run, 2 in the page"), "the changed one is not run");

  // Where Debian's clang makes the objects, it does so within the sandbox, too; and is held against the
  // page's own compiler there.
  if (existsSync(join(assets, "cpp/native/probe.o"))) {
    const compare = { MJCOURSE_COMPARE_ALL_OBJECTS: "1" };
    writeLesson(writeProgram("a", "compared"));
    expect(run("check", [], compare).status === 0, "the native compiler is not used in a check");
    const other = join(home, "other-assets");
    cpSync(assets, other, { recursive: true });
    const header = join(other, "cpp/native/root/usr/include/c++/v1/any");
    writeFileSync(header, "int other;\n", { flag: "a" });
    writeLesson(writeProgram("a", "different"));
    const program = join(course, "examples/a.cpp");
    writeFileSync(program, `#include <any>\n${readFileSync(program, "utf8")}`);
    const differs = run("check", [], { ...compare, MJCOURSE_ASSETS: other });
    expect(
      differs.status === 3 || differs.said.includes("E-internal"),
      "another object is believed",
    );
  }

  writeLesson(writeProgram("a", "a", " native"));
  const native = build();
  expect(native.said.includes("1 program run"), "the native one is not run");
  expect(!native.said.includes("in the page"), "a native program is run in the page");
  expect(native.page.includes("native only"), "the page does not say why it runs nothing");
  expect(native.compiler === 0, "the site has a compiler for nothing");

  writeLesson(writeProgram("a", "a"));
  const without = build({ MJCOURSE_ASSETS: assetsWithout() });
  expect(without.status === 0, "without the compiler there is no site");
  expect(without.said.includes("page: programs were run natively alone"), "nobody says so");
  expect(!without.page.includes("data-program="), "a page offers what it has not");

  const expected = [
    "it measures this machine",
    "native only",
    "the page's compiler says: 'sys/epoll.h' file not found",
    "a thread waits for another, and a page runs one after the other",
  ];
  expect(String(reasons()) === String(expected), `other reasons: ${reasons().join("; ")}`);
} finally {
  rmSync(home, { recursive: true });
}
for (const failure of failures) console.error(failure);
process.exit(failures.length === 0 ? 0 : 1);

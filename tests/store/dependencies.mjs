// Whatever a result depends on makes it anew when it changes, and nothing else does: the text, a
// header, the helper header, a model, a file that a model includes, flags, the compiler, versions.
// `explain` says beforehand what is kept, and what has changed.
//
//   node tests/store/dependencies.mjs MJCOURSE ASSETS

import { chmodSync, cpSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { change, cleanUp, course, home, run, store, worked, write } from "./harness.mjs";
import { withPageHalves } from "./page_halves.mjs";

const [mjcourse, assets] = process.argv.slice(2);

const one = `#include <mjcourse/mjcourse.hpp>
#include <mujoco/mujoco.h>

#include <cstdio>
#include <cstdlib>
#include <string>

int main() {
  const std::string name = std::string(std::getenv("MJCOURSE_MODELS")) + "/" + kModel + ".xml";
  char error[500] = "";
  mjModel* model = mj_loadXML(name.c_str(), nullptr, error, sizeof error);
  if (model == nullptr) return 1;
  std::printf("nq = %d\\n", model->nq);
  mj_deleteModel(model);
}
`;
const two = `#include <other.hpp>

#include <cstdio>

int main() {
  std::printf("%d\\n", kOther);
}
`;
const lesson = "content/1-a/1.1-b.md";

function writeCourse() {
  write(
    "content/course.yaml",
    "title: T\nlevels:\n  - {folder: 1-a, title: A, lessons: [1.1-b]}\n",
  );
  write(
    "models/a.xml",
    "<mujoco><worldbody><body><freejoint/><geom size='1'/></body></worldbody></mujoco>\n",
  );
  write("models/b.xml", "<mujoco><include file='parts/part.xml'/></mujoco>\n");
  write("models/parts/part.xml", "<mujoco><worldbody><geom size='1'/></worldbody></mujoco>\n");
  write(
    "examples/include/mjcourse/mjcourse.hpp",
    '#pragma once\ninline const char* const kModel = "a";\n',
  );
  write("examples/include/other.hpp", "#pragma once\ninline const int kOther = 7;\n");
  write("examples/one.cpp", one);
  write("examples/two.cpp", two);
  const readouts = [{ label: "z", expr: "data.qpos[2]" }];
  const lab = { title: "L", alt: "A ball.", model: "a", readouts };
  write(
    lesson,
    `---
title: B
---

A formula, $x$. Numbers: \`{a} model.nq\`, \`{b} model.ngeom\`.

\`\`\`cpp file=examples/one.cpp
${one}\`\`\`

\`\`\`text
nq = 7
\`\`\`

\`\`\`cpp file=examples/two.cpp
${two}\`\`\`

\`\`\`lab simlab
${JSON.stringify(lab)}
\`\`\`
`,
  );
}

const all = {
  one: "compile and run one",
  two: "compile and run two",
  a: "compute model.nq of a",
  b: "compute model.ngeom of b",
  lab: 'rehearse the lab "L"',
  picture: "draw the model a",
  formula: "set the formulas of 1.1",
};

const tasksOf = (names) =>
  withPageHalves(
    names.map((name) => all[name]),
    mjcourse,
  );

const failures = [];
// After what was changed: these tasks are worked out, and these lines `explain` says of them.
function expect(what, names, lines = [], environment = {}) {
  const explained = run(
    mjcourse,
    ["explain", "--course", course, "--store", store],
    environment,
  ).stdout;
  for (const line of lines) {
    if (!new RegExp(line, "m").test(explained)) {
      failures.push(`${what}: explain does not say ${line}:\n${explained}`);
    }
  }
  const kept = (explained.match(/: kept$/gm) ?? []).length;
  const expected = tasksOf(names).sort();
  if (kept !== tasksOf(Object.keys(all)).length - expected.length) {
    failures.push(`${what}: explain calls ${kept} kept:\n${explained}`);
  }
  for (const name of expected) {
    if (!explained.includes(`${name}: to be done`)) failures.push(`${what}: explain keeps ${name}`);
  }
  const { anew, notes } = worked(mjcourse, environment);
  if (anew.join("; ") !== expected.join("; ")) {
    failures.push(`${what}: worked out [${anew.join("; ")}], not [${expected.join("; ")}]`);
  }
  if (notes !== "") failures.push(`${what}: ${notes}`);
}

// Another compiler by its words, and the same by what it does.
function renamedCompiler() {
  const folder = join(home, "bin");
  mkdirSync(folder);
  const script = `#!/bin/sh
if [ "$1" = --version ]; then echo "Debian clang version 16.0.99"; exit; fi
exec /usr/bin/clang++-16 "$@"
`;
  writeFileSync(join(folder, "clang++-16"), script);
  chmodSync(join(folder, "clang++-16"), 0o755);
  return { PATH: `${folder}:${process.env.PATH}` };
}

function otherScripts() {
  const copy = join(home, "assets");
  cpSync(assets, copy, { recursive: true });
  const world = join(copy, "script", "world.js");
  writeFileSync(world, readFileSync(world, "utf8") + "\n// newer\n");
  return { MJCOURSE_ASSETS: copy };
}

try {
  writeCourse();
  const names = Object.keys(all);
  expect("the first time", names, ["was never evaluated here"]);
  expect("nothing", []);
  change(lesson, "A formula", "Some prose, a line more.\n\nA formula");
  expect("prose", []);
  change(lesson, "$x$", "$y$");
  expect("the text of a formula", ["formula"], ["^  text changed: [0-9a-f]{8} → [0-9a-f]{8}$"]);
  change(lesson, '{"title":"L"', '{ "title":"L"');
  expect("the text of a lab", ["lab"], ["^  text changed"]);
  for (const path of [lesson, "examples/two.cpp"])
    change(
      path,
      '#include <cstdio>\n\nint main() {\n  std::printf("%d',
      '#include <cstdio>\n\n// More.\nint main() {\n  std::printf("%d',
    );
  expect("the text of a program", ["two"]);
  change("models/a.xml", "</mujoco>", "<!-- newer --></mujoco>");
  expect(
    "a model",
    ["one", "a", "lab", "picture"],
    ["^  models/a.xml changed: [0-9a-f]{8} → [0-9a-f]{8}$"],
  );
  change("models/parts/part.xml", "</mujoco>", "<!-- newer --></mujoco>");
  expect("a file that a model includes", ["b"], ["^  models/parts/part.xml changed"]);
  change("examples/include/other.hpp", "pragma once", "pragma once\n// newer");
  expect("a header", ["two"], ["^  examples/include/other.hpp changed"]);
  change("examples/include/mjcourse/mjcourse.hpp", "pragma once", "pragma once\n// newer");
  expect("the helper header", ["one"], ["^  examples/include/mjcourse/mjcourse.hpp changed"]);
  write("examples/include/mjcourse/third.hpp", "#pragma once\n");
  expect("a header of a name that nobody read", []);
  write("examples/include/stdlib.h", "#include_next <stdlib.h>\n");
  const hides = "^  headers in examples/include changed: .*hpp → .*hpp, stdlib.h$";
  expect("a header that hides one of the system's", ["one"], [hides]);
  write("examples/include/mjcourse/other.hpp", "#pragma once\n");
  expect("a header that may hide another", ["two"], ["^  headers in examples/include changed"]);
  for (const path of [lesson, "examples/two.cpp"])
    change(path, "// More.", '#if __has_include("fourth.hpp")\n#endif');
  expect("the text of a program that asks for a header", ["two"]);
  write("examples/include/fourth.hpp", "#pragma once\n");
  expect("the header that it asks for", ["two"], ["^  examples/include changed"]);
  change(lesson, "file=examples/two.cpp", "file=examples/two.cpp optimize");
  expect("a flag", ["two"], ["^  flags changed: -O0 .* → -O2 "]);
  expect(
    "the compiler",
    ["one", "two"],
    ["^  compiler changed: .* → .*16\\.0\\.99"],
    renamedCompiler(),
  );
  expect("the compiler that was before", []);
  expect(
    "the scripts' version",
    ["a", "b", "lab", "picture"],
    ["^  script/world.js changed"],
    otherScripts(),
  );
  // A library more is another set of libraries.
  const library = { LD_PRELOAD: "libutil.so.1" };
  expect("the libraries' versions", names, ["^  libraries changed"], library);
  const rounding = { GLIBC_TUNABLES: "glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2" };
  const { anew } = worked(mjcourse, rounding);
  if (anew.length !== 0) failures.push(`another rounding of the user's has ${anew} made anew`);
} finally {
  cleanUp();
}
for (const failure of failures) console.error(failure);
console.log(`${failures.length} problems`);
process.exitCode = failures.length > 0 ? 1 : 0;

// A course that moves keeps its results, and its site does not change: what is kept names no place on
// this disk. Its old folder is gone then, so that a program that still asks for it finds nothing.
//
//   node tests/store/moved.mjs MJCOURSE

import { spawnSync } from "node:child_process";
import { mkdirSync, renameSync } from "node:fs";
import { dirname, join } from "node:path";

import { cleanUp, course, home, worked, write } from "./harness.mjs";
import { withPageHalves } from "./page_halves.mjs";

const mjcourse = process.argv[2];

write("content/course.yaml", "title: T\nlevels:\n  - {folder: 1-a, title: A, lessons: [1.1-b]}\n");
write(
  "models/wedge.xml",
  `<mujoco>
  <asset><mesh name="wedge" file="parts/wedge.obj"/></asset>
  <worldbody>
    <body pos="0 0 1"><freejoint/><geom type="mesh" mesh="wedge"/></body>
  </worldbody>
</mujoco>
`,
);
write(
  "models/parts/wedge.obj",
  "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n",
);
write(
  "content/1-a/1.1-b.md",
  `---
title: B
---

\`\`\`lab simlab
{
  "title": "A wedge",
  "model": "wedge",
  "alt": "A wedge in the air",
  "controls": [{"type": "button", "label": "Kick", "run": "data.qvel[0] = 1"}]
}
\`\`\`

\`\`\`cpp snippet model=wedge
std::cout << model->nv << '\\n';
\`\`\`

\`\`\`text
6
\`\`\`
`,
);

const elsewhere = join(home, "some", "where", "else");
const build = (folder, name) =>
  worked(mjcourse, {}, folder, ["build", "--out", join(home, name)]).anew.join("; ");

const failures = [];
try {
  const first = build(course, "before");
  const tasks = withPageHalves(
    ["compile and run the snippets of 1.1", "draw the model wedge", 'rehearse the lab "A wedge"'],
    mjcourse,
  ).join("; ");
  if (first !== tasks) failures.push(`the first build works out [${first}], not [${tasks}]`);

  mkdirSync(dirname(elsewhere), { recursive: true });
  renameSync(course, elsewhere);
  const second = build(elsewhere, "after");
  if (second !== "") failures.push(`moved, it works out [${second}] anew`);
  const { status, stdout } = spawnSync("diff", ["-rq", join(home, "before"), join(home, "after")]);
  if (status !== 0) failures.push(`moved, it has another site:\n${stdout}`);

  // As an author builds it, from within.
  const within = spawnSync(mjcourse, ["build"], { cwd: elsewhere, encoding: "utf8" });
  if (within.status !== 0) failures.push(`from within, it does not build:\n${within.stderr}`);
} catch (error) {
  failures.push(error.message);
} finally {
  cleanUp();
}
for (const failure of failures) console.error(failure);
console.log(`${failures.length} problems`);
process.exitCode = failures.length === 0 ? 0 : 1;

// Several machines that each do a share of a course: together they do all of it and nothing twice, say
// what one machine says, and leave a build nothing to do.
//
//   node tests/store/shards.mjs MJCOURSE

import { spawnSync } from "node:child_process";
import { cpSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

import { change, cleanUp, course, home, run, write } from "./harness.mjs";
import { withPageHalves } from "./page_halves.mjs";
import { nginx } from "./servers.mjs";

const [mjcourse] = process.argv.slice(2);
const exercise = join(dirname(fileURLToPath(import.meta.url)), "../courses/exercise/right");
const failures = [];
function expect(good, what) {
  if (!good) failures.push(what);
}
const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);

function program(name, number) {
  write(
    `examples/${name}.cpp`,
    `// Reports by itself what the helper header would, which takes long to compile.
#include <cstdlib>
#include <fstream>
#include <iostream>

int main() {
  // #region number
  const double number = ${number};
  // #endregion
  std::ofstream file(std::getenv("MJCOURSE_RECORDS"));
  file << "{\\"result\\": \\"number\\", \\"value\\": " << number << "}\\n";
  file << "{\\"table\\": \\"t\\", \\"value\\": [[\\"time\\", [0, 1]], [\\"y\\", [0, " << number << "]]]}\\n";
  std::cout << number << '\\n';
}
`,
  );
}

const plot = (name) => `\`\`\`plot
{"data": {"name": "${name}/t"}, "caption": "It grows.", "alt": "A line that grows.", "mark": "line",
 "encoding": {"x": {"field": "time", "type": "quantitative"}, "y": {"field": "y", "type": "quantitative"}}}
\`\`\`
`;

const whole = (name, output) => `\`\`\`cpp file=examples/${name}.cpp
\`\`\`

\`\`\`text
${output}
\`\`\`
`;

cpSync(join(exercise, "examples"), join(course, "examples"), { recursive: true });
write(
  "content/course.yaml",
  "title: T\nlevels:\n  - {folder: 1-a, title: A, lessons: [1.1-a, 1.2-b, 1.3-c]}\n",
);
for (const [name, number] of [
  ["one", 1],
  ["two", 2],
  ["three", 3],
  ["four", 4],
]) {
  program(name, number);
}
write(
  "content/1-a/1.1-a.md",
  `---
title: A
---

It is \`{one} number :.0f\`, and \`{three} number :.0f\` elsewhere; $x$.

${whole("one", "1")}
${plot("one")}
\`\`\`cpp file=examples/two.cpp#number
\`\`\`
`,
);
write(
  "content/1-a/1.2-b.md",
  `---
title: B
---

${whole("two", "2")}
${whole("three", "3")}
\`\`\`quiz
{"id": "q", "questions": [
  {"kind": "numeric", "q": "Which number?", "answer": 4, "tol": 0,
   "verify": [{"example": "four", "value": "number"}]}]}
\`\`\`
`,
);
const [, lesson] = readFileSync(join(exercise, "content/1-basics/1.1-lesson.md"), "utf8").split(
  "title: An exercise\n---\n",
);
write(
  "content/1-a/1.3-c.md",
  `---
title: C
---

${whole("four", "4")}
${plot("two")}
Nobody runs this:

\`\`\`cpp unchecked
none();
\`\`\`
${lesson}`,
);

// A machine has a place of its own for the course and for its store.
let machines = 0;
function machine() {
  const folder = join(home, `machine-${++machines}`);
  const place = join(folder, "x".repeat(machines), "course");
  cpSync(course, place, { recursive: true });
  return { folder, place, store: join(folder, "store") };
}

function there(where, command, server, ...more) {
  const trace = join(where.folder, "trace.json");
  const url = server ? ["--store-url", server.url] : [];
  const words = [
    "--course",
    where.place,
    "--store",
    where.store,
    "--trace",
    trace,
    ...url,
    ...more,
  ];
  const ran = run(mjcourse, [command, ...words]);
  const { traceEvents } = JSON.parse(readFileSync(trace, "utf8"));
  const tasks = traceEvents
    .map((event) => ({ name: event.name, kind: event.cat }))
    .filter(({ name }) => !name.startsWith("compile once"));
  return { ...ran, tasks };
}

const names = (tasks) => tasks.map((task) => task.name).sort();
const worked = (tasks) => names(tasks.filter((task) => task.kind === "worked"));
const messages = (ran) => JSON.parse(ran.stdout).diagnostics.map((one) => JSON.stringify(one));

function shardsOf(count, server, ...more) {
  return Array.from({ length: count }, (_, i) =>
    there(machine(), "check", server, "--shard", `${i + 1}/${count}`, ...more),
  );
}

const server = await nginx(join(home, "server"));
try {
  const alone = machine();
  const all = there(alone, "build", undefined, "--out", join(alone.folder, "site"));
  expect(all.status === 0, `the course is wrong: ${all.stderr}`);

  for (const [count, state] of [
    [3, "cold"],
    [2, "warm"],
  ]) {
    const shards = shardsOf(count, server);
    for (const [i, { status, stdout, stderr, tasks }] of shards.entries()) {
      expect(status === 0, `shard ${i + 1} of ${count} ends with ${status}: ${stderr}`);
      const line = `shard ${i + 1} of ${count}: ${tasks.length} of ${all.tasks.length} tasks, by division `;
      expect(stdout.includes(line), `"${line}" is not said: ${stdout}`);
      expect(tasks.length > 0, `${state}: shard ${i + 1} of ${count} has no task`);
    }
    const divisions = shards.map(({ stdout }) => /by division ([0-9a-f]{8})$/m.exec(stdout)?.[1]);
    expect(new Set(divisions).size === 1, `${state}: the divisions are ${divisions}`);
    const done = shards.flatMap(({ tasks }) => tasks);
    expect(same(names(done), names(all.tasks)), `${state}: the shards did ${names(done)}`);
    const anew = worked(done);
    const expected = state === "cold" ? worked(all.tasks) : [];
    expect(same(anew, expected), `${state}: the shards worked on ${anew}, not ${expected}`);
    const last = machine();
    const build = there(last, "build", server, "--out", join(last.folder, "site"));
    expect(same(worked(build.tasks), []), `${state}: the build works on ${worked(build.tasks)}`);
    const compared = spawnSync("diff", [
      "-rq",
      join(alone.folder, "site"),
      join(last.folder, "site"),
    ]);
    expect(compared.status === 0, `${state}: another site\n${compared.stdout}`);
  }

  // Which machine runs a program does not depend on another's text, and what quotes it follows.
  change("examples/three.cpp", "number = 3", "number = 5 - 2");
  const edited = shardsOf(3, server);
  const busy = edited.filter(({ tasks }) => worked(tasks).length > 0);
  const halves = withPageHalves(["compile and run three"], mjcourse);
  const done = busy.flatMap(({ tasks }) => worked(tasks)).sort();
  expect(same(done, halves), `for an edited program, the shards do ${done}`);

  // Every message comes once, with the words of one machine.
  change("content/1-a/1.1-a.md", "{three} number", "{thre} number");
  change("content/1-a/1.1-a.md", "two.cpp#number", "two.cpp#numbre");
  change("content/1-a/1.2-b.md", "\n2\n", "\n7\n");
  change("content/1-a/1.2-b.md", '"answer": 4', '"answer": 5');
  change("content/1-a/1.3-c.md", "Nobody runs this:", "Nobody runs this [thing](model:none):");
  change("examples/one.cpp", "number << ", "nmber << ");
  const told = there(machine(), "check", undefined, "--format", "json");
  const wrong = shardsOf(3, server, "--format", "json");
  const said = wrong.flatMap(messages).sort();
  expect(told.status === 1 && messages(told).length >= 6, `one machine says ${told.stdout}`);
  expect(
    same(said, messages(told).sort()),
    `the shards say\n${said.join("\n")}\nnot\n${messages(told).sort().join("\n")}`,
  );
  for (const { status, stdout } of wrong) {
    const right = JSON.parse(stdout).diagnostics.length > 0 ? 1 : 0;
    expect(status === right, `a shard ends with ${status}, and says ${stdout}`);
  }
  const report = run(mjcourse, [
    "check",
    "--course",
    course,
    "--shard",
    "1/2",
    "--report",
    join(home, "report"),
  ]);
  expect(
    report.status === 2 &&
      report.stderr ===
        "mjcourse: a report tells of the whole course, and a shard knows its share alone\n" +
          "leave out --report here, and write it in the run that comes last, without --shard\n",
    `--shard with --report: ${report.stderr}`,
  );
} finally {
  await server.stop();
  cleanUp();
}
for (const failure of failures) console.error(failure);
console.log(`${failures.length} problems`);
process.exitCode = failures.length > 0 ? 1 : 0;

// The promise of the whole project, on the real course: change one number of a program, in the
// lesson and in its file alike, and the check fails at the lines that are no longer true. `accept`
// then changes these lines and no others.
//
//   node tests/system/changed_program.mjs MJCOURSE COURSE

import { spawnSync } from "node:child_process";
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const [mjcourse, course] = process.argv.slice(2);
const spin = "0.1, 0, 0, 0, 0, 2.0;";
const faster = "0.1, 0, 0, 0, 0, 3.0;";
const files = [
  "content/1-state/1.2-generalized-coordinates.md",
  "examples/l1_2_generalized_coordinates.cpp",
];
const expected = [
  " - free joint, true qvel           : [0.1 0.  0.  0.  0.  2. ]",
  " + free joint, true qvel           : [0.1 0.  0.  0.  0.  3. ]",
  " - mj_differentiatePos(dt, q0, q1)  : [0.1 0.  0.  0.  0.  2. ]",
  " + mj_differentiatePos(dt, q0, q1)  : [0.1 0.  0.  0.  0.  3. ]",
  " - naive (q1 - q0) / dt, 7 numbers  : [ 0.1     0.      0.     -0.025   0.      0.      0.9996]",
  " + naive (q1 - q0) / dt, 7 numbers  : [",
];

const copy = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
const failures = [];
function expect(good, what) {
  if (!good) failures.push(what);
}

try {
  for (const part of ["content", "examples", "models"]) {
    cpSync(join(course, part), join(copy, part), { recursive: true });
  }
  for (const file of files) {
    const text = readFileSync(join(copy, file), "utf8");
    expect(text.split(spin).length === 2, `${file} does not hold \`${spin}\` once`);
    writeFileSync(join(copy, file), text.replace(spin, faster));
  }
  const { status, stderr } = spawnSync(mjcourse, ["check", "--course", copy], {
    encoding: "utf8",
  });
  console.log(stderr);
  expect(status === 1, `the exit code is ${status}, not 1`);
  const errors = stderr.split("\n").filter((line) => line.includes(" error: "));
  const lesson = files[0].replaceAll(".", "\\.");
  const form = new RegExp(`^${lesson}:\\d+:1: error: .* \\[E-output-differs\\]$`);
  expect(errors.length === 1 && form.test(errors[0]), "not just one error, of a differing output");
  for (const line of expected) expect(stderr.includes(line), `nothing says: ${line}`);
  expect(!/[-+] (nq|after)/.test(stderr), "lines that are still true are named as well");
  const lines = () => readFileSync(join(copy, files[0]), "utf8").split("\n");
  const accept = () => spawnSync(mjcourse, ["accept", "--course", copy], { encoding: "utf8" });
  const before = lines();
  const accepted = accept();
  console.log(accepted.stdout);
  expect(accepted.status === 0, `accept exits with code ${accepted.status}`);
  const after = lines();
  expect(after.length === before.length, "accept changes the number of lines");
  const changed = before.flatMap((line, i) =>
    line === after[i] ? [] : [`- ${line}`, `+ ${after[i]}`],
  );
  expect(changed.length === expected.length, `accept changes other lines: ${changed.join("\n")}`);
  for (const [i, line] of expected.entries()) {
    expect(changed[i]?.startsWith(line.trim()), `accept writes no line: ${line}`);
  }
  const again = accept();
  expect(again.stdout === "nothing to accept\n", `accepting again says: ${again.stdout}`);
  expect(lines().join("\n") === after.join("\n"), "accepting again changes the lesson");
} finally {
  rmSync(copy, { recursive: true });
}
for (const failure of failures) console.error(failure);
process.exitCode = failures.length > 0 ? 1 : 0;

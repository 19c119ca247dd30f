// Runs the tiny courses beside this file and compares what `mjcourse check` says of each, to the
// letter, with its expected.txt.
//
//   node tests/courses/run.mjs              all of them
//   node tests/courses/run.mjs lab quiz/    those whose name holds one of these
//   UPDATE_EXPECTED=1 node tests/courses/run.mjs
//
// The generator is the release build's; the environment's MJCOURSE names another, and
// MJCOURSE_WITHOUT a case that this one cannot stand: under the sanitizers, which need all memory,
// no model is tried out. Where the compiler of the page was not built, no program runs there, and the
// cases of page/ are left out.

import { execFile, spawnSync } from "node:child_process";
import { existsSync, globSync, readFileSync, writeFileSync } from "node:fs";
import { availableParallelism } from "node:os";
import { dirname, join, resolve } from "node:path";

const here = import.meta.dirname;
const mjcourse = resolve(process.env.MJCOURSE ?? "build/release/generator/mjcourse");
if (!existsSync(mjcourse)) throw new Error(`there is no generator at ${mjcourse}`);
const without = process.env.MJCOURSE_WITHOUT;
const inPage = existsSync(join(dirname(mjcourse), "../assets/cpp/version"));
const update = process.env.UPDATE_EXPECTED === "1";

// "feature/case", for each folder of that depth that holds a course or what is expected of it.
function findCases(wanted) {
  const found = globSync("*/*/{content,expected.txt}", { cwd: here }).map((path) => dirname(path));
  const names = [...new Set(found)]
    .filter((name) => name !== without && (inPage || !name.startsWith("page/")))
    .sort();
  return wanted.length === 0
    ? names
    : names.filter((name) => wanted.some((part) => name.includes(part)));
}

// What a case has in its file `arguments`, word by word.
function moreArguments(name) {
  const file = join(here, name, "arguments");
  return existsSync(file) ? readFileSync(file, "utf8").split(/\s+/).filter(Boolean) : [];
}

// stderr, stdout and the exit code; the time it took, which is never the same, as "N.N s", and
// without the sandbox, which is another on another machine.
function check(name) {
  return new Promise((resolved) => {
    const process = execFile(
      mjcourse,
      ["check", "--course", join(here, name), ...moreArguments(name)],
      (error, stdout, stderr) => {
        const exit = error?.signal ?? process.exitCode;
        const summary = stdout
          .replace(/\d+\.\d s$/m, "N.N s")
          .replace(/^(sandbox[:,]|page:) .*\n/gm, "");
        resolved(`${stderr}${summary}exit ${exit}\n`);
      },
    );
  });
}

function difference(expected, actual) {
  const labels = ["--label", "expected", "--label", "actual"];
  return spawnSync("diff", ["-u", ...labels, expected, "-"], {
    input: actual,
  }).stdout.toString();
}

// What is expected here.
function stated(file) {
  const text = readFileSync(file, "utf8");
  return inPage ? text : text.replace(/, \d+ in the page\b/g, "");
}

async function runCase(name) {
  const file = join(here, name, "expected.txt");
  const actual = await check(name);
  if (update) writeFileSync(file, actual);
  if (!existsSync(file)) {
    return `there is no expected.txt; UPDATE_EXPECTED=1 writes this:\n${actual}`;
  }
  return stated(file) === actual ? "" : difference(file, actual);
}

// Runs every case, as many at once as there are cores; gives what is wrong with each.
async function runAll(names) {
  const waiting = [...names];
  const failures = new Map();
  const worker = async () => {
    for (let name = waiting.shift(); name !== undefined; name = waiting.shift()) {
      const failure = await runCase(name);
      if (failure !== "") failures.set(name, failure);
    }
  };
  await Promise.all(Array.from({ length: availableParallelism() }, worker));
  return failures;
}

const names = findCases(process.argv.slice(2));
const failures = await runAll(names);
for (const name of names.filter((name) => failures.has(name))) {
  console.log(`FAILED ${name}\n${failures.get(name)}`);
}
console.log(`${names.length - failures.size} passed, ${failures.size} failed`);
process.exitCode = failures.size > 0 || names.length === 0 ? 1 : 0;

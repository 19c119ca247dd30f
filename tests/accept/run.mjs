// Runs `mjcourse accept` on copies of the tiny courses beside this file, and compares what it says
// with expected.txt and what it leaves with after/, to the byte.
//
//   node tests/accept/run.mjs             all of them
//   node tests/accept/run.mjs quote       those whose name holds one of these
//   UPDATE_EXPECTED=1 node tests/accept/run.mjs
//
// A case is a folder: before/ is the course, arguments.txt (one a line) what stands behind `accept`,
// expected.txt what it says: stdout, stderr and the exit code, and all of it once more for a second
// run, which must change nothing. after/ holds those files alone that are not as in before/. Pictures
// come out a little different on another processor: of a PNG the head, its size, must be as in
// after/; that it shows the right thing, the second run says.

import { spawnSync } from "node:child_process";
import {
  cpSync,
  existsSync,
  globSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  rmSync,
  statSync,
  writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";

const here = import.meta.dirname;
const mjcourse = resolve(process.env.MJCOURSE ?? "build/release/generator/mjcourse");
if (!existsSync(mjcourse)) throw new Error(`there is no generator at ${mjcourse}`);
const update = process.env.UPDATE_EXPECTED === "1";

// The bytes of every file below `folder`, hidden ones as well, by their paths.
function readTree(folder) {
  const files = new Map();
  for (const path of globSync("**/{*,.*}", { cwd: folder }).sort()) {
    const full = join(folder, path);
    if (statSync(full).isFile()) files.set(path, readFileSync(full, "latin1"));
  }
  return files;
}

function changes(before, after) {
  const changed = new Map();
  for (const [path, bytes] of after) if (before.get(path) !== bytes) changed.set(path, bytes);
  for (const path of before.keys()) if (!after.has(path)) changed.set(path, "it is gone");
  return changed;
}

// Of a PNG what every processor agrees on: its signature and first chunk.
function comparable(files) {
  const head = ([path, bytes]) => [path, path.endsWith(".png") ? bytes.slice(0, 33) : bytes];
  return new Map([...files].map(head));
}

function accept(course, words) {
  const { stdout, stderr, status } = spawnSync(mjcourse, ["accept", ...words, "--course", course], {
    encoding: "utf8",
  });
  const said = `${stdout}${stderr === "" ? "" : `stderr:\n${stderr}`}exit ${status}\n`;
  return said
    .replaceAll(`${course}/`, "")
    .replaceAll(course, "COURSE")
    .replace(/\.png \([\d.]+ (kB|bytes)\)/g, ".png (N kB)");
}

function difference(expected, actual, what) {
  const labels = ["--label", `expected ${what}`, "--label", `actual ${what}`];
  return spawnSync("diff", ["-u", ...labels, expected, "-"], {
    input: actual,
  }).stdout.toString();
}

// What is wrong with the case, as text.
function runCase(name) {
  const folder = join(here, name);
  const course = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
  try {
    cpSync(join(folder, "before"), course, { recursive: true });
    const before = readTree(course);
    const file = join(folder, "arguments.txt");
    const words = existsSync(file) ? readFileSync(file, "utf8").split("\n").filter(Boolean) : [];
    const first = accept(course, words);
    const after = readTree(course);
    const second = accept(course, words);
    const said = `${first}\nand again\n${second}`;
    const changed = changes(before, after);
    if (update) save(folder, said, changed);
    const again = changes(after, readTree(course));
    const wrong = [...again.keys()].map((path) => `the second run changes ${path}\n`);
    const expected = join(folder, "expected.txt");
    if (!existsSync(expected))
      return `there is no expected.txt; UPDATE_EXPECTED=1 writes this:\n${said}`;
    if (readFileSync(expected, "utf8") !== said) wrong.push(difference(expected, said, "words"));
    const wanted = existsSync(join(folder, "after")) ? readTree(join(folder, "after")) : new Map();
    for (const path of changes(comparable(wanted), comparable(changed)).keys()) {
      wrong.push(
        `${path} is not as in after/: ${JSON.stringify(changed.get(path) ?? "unchanged")}\n`,
      );
    }
    return wrong.join("");
  } finally {
    rmSync(course, { recursive: true });
  }
}

function save(folder, said, changed) {
  writeFileSync(join(folder, "expected.txt"), said);
  rmSync(join(folder, "after"), { recursive: true, force: true });
  for (const [path, bytes] of changed) {
    const file = join(folder, "after", path);
    mkdirSync(dirname(file), { recursive: true });
    writeFileSync(file, bytes, "latin1");
  }
}

const wanted = process.argv.slice(2);
const names = globSync("*/before", { cwd: here })
  .map((path) => dirname(path))
  .filter((name) => wanted.length === 0 || wanted.some((part) => name.includes(part)))
  .sort();
let failed = 0;
for (const name of names) {
  const wrong = runCase(name);
  if (wrong === "") continue;
  console.log(`FAILED ${name}\n${wrong}`);
  ++failed;
}
console.log(`${names.length - failed} passed, ${failed} failed`);
process.exitCode = failed > 0 || names.length === 0 ? 1 : 0;

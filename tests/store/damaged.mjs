// A store that holds anything, each entry under its right hash: what is no answer to the question is
// made anew, and nothing ends the check.
//
//   node tests/store/damaged.mjs MJCOURSE COURSE

import { spawnSync } from "node:child_process";
import { globSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";

import { readSealed, sealOnDisk } from "./sealed.mjs";

const [mjcourse, course] = process.argv.slice(2).map((path) => resolve(path));
const home = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
const store = join(home, "store");

function check() {
  const words = ["check", "--course", course, "--store", store];
  const { status, stdout, stderr } = spawnSync(mjcourse, words, { encoding: "utf8" });
  return `${stderr}${stdout.replace(/\d+\.\d s$/m, "N s")}exit ${status}`;
}

// Writes `bytes` as the content of the entry in `file`.
function write(file, bytes) {
  const { name, origin } = readSealed(file);
  writeFileSync(file, Buffer.concat([Buffer.from(sealOnDisk(name, bytes, origin)), bytes]));
}

const content = (file) => readSealed(file).bytes;
// What an answer begins with, which is its question.
const question = (bytes) => bytes.subarray(0, bytes.indexOf("\n") + 1);
const isAnswer = (bytes) => bytes.includes("\n");

// Each gives what stands in the place of an entry, of which `others` are there too.
const damages = {
  "nothing is left": () => Buffer.alloc(0),
  "the answer is none": (bytes) => question(bytes),
  "the answer is of another question": (bytes, others) => {
    const other = others.find((one) => isAnswer(one) && one.length !== bytes.length) ?? bytes;
    return Buffer.concat([question(bytes), other.subarray(question(other).length)]);
  },
  "the entry is of another question": (bytes, others) => others.at(-1),
  "the end is missing": (bytes) => bytes.subarray(0, Math.floor(bytes.length * 0.9)),
  "a byte differs": (bytes) => {
    const changed = Buffer.from(bytes);
    if (isAnswer(bytes)) changed[question(bytes).length + 3] ^= 0x41;
    return changed;
  },
  "an empty map": (bytes) => Buffer.concat([question(bytes), Buffer.from([0xa0])]),
  "JSON of another form": () => Buffer.from('[{"a": [1, null]}, 5]'),
  "lists of numbers": () => Buffer.from("[[1, 2], [3]]"),
  "a deep list": () => Buffer.from("[".repeat(100_000) + "]".repeat(100_000)),
};

const failures = [];
try {
  const first = check();
  for (const [name, damage] of Object.entries(damages)) {
    const files = globSync(join(store, "ac", "*", "*"));
    const all = files.map(content);
    files.forEach((file, index) => {
      write(file, damage(all[index], all.toSpliced(index, 1)));
    });
    const said = check();
    if (said !== first) failures.push(`${name}:\n${said}\nand before:\n${first}`);
    console.log(`${name}: ${files.length} entries`);
    if (files.length < 10) failures.push(`the store has but ${files.length} entries`);
  }
} finally {
  rmSync(home, { recursive: true });
}
for (const failure of failures) console.error(failure);
process.exitCode = failures.length > 0 ? 1 : 0;

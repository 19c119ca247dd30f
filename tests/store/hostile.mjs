// A store into which somebody else puts what no store writes, or which somebody keeps locked: checks
// and prunings end all the same, and say what they met.
//
//   node tests/store/hostile.mjs MJCOURSE

import { spawn } from "node:child_process";
import { globSync, lstatSync, mkdirSync, rmSync, utimesSync } from "node:fs";
import { join } from "node:path";

import { cleanUp, course, home, run, store, write } from "./harness.mjs";

const mjcourse = process.argv[2];
const deep = 300; // folders in each other
const few = 200; // files that a program here has open at most

write("content/course.yaml", "title: T\nlevels:\n  - {folder: 1-a, title: A, lessons: [1.1-b]}\n");
const program = `#include <iostream>

int main() { std::cout << 6 << '\\n'; }
`;
write("examples/six.cpp", program);
write(
  "content/1-a/1.1-b.md",
  `---
title: B
---

\`\`\`cpp file=examples/six.cpp
${program}\`\`\`

\`\`\`text
6
\`\`\`
`,
);

const failures = [];
function expect(what, found, wanted) {
  if (found !== wanted) failures.push(`${what}:\n${found}instead of\n${wanted}`);
}

const limited = (words) =>
  run("sh", ["-c", `ulimit -Sn ${few}; exec "$@"`, "sh", mjcourse, ...words]);
const check = () => limited(["check", "--course", course, "--store", store]);
const prune = (keep) => limited(["store", "prune", "--keep", keep, "--store", store]);
const results = () =>
  globSync("ac/??/*", { cwd: store })
    .map((path) => join(store, path))
    .filter((path) => lstatSync(path).isFile());

function makeDeep(folder) {
  mkdirSync(folder, { recursive: true });
  const before = process.cwd();
  process.chdir(folder);
  for (let i = 0; i < deep; ++i) {
    mkdirSync("d");
    process.chdir("d");
  }
  process.chdir(before);
}

// Holds the lock of the store until it is killed, or for longer than anything here waits. Resolves once it has it.
function holder(kind) {
  const child = spawn(
    "flock",
    [kind, join(store, "lock"), "sh", "-c", "echo got; exec sleep 100"],
    {
      detached: true, // with its own child
      stdio: ["ignore", "pipe", "ignore"],
    },
  );
  const free = () => process.kill(-child.pid);
  return new Promise((resolve) => child.stdout.once("data", () => resolve(free)));
}

// The process is another one each time, and some kernels do not say it.
const withoutHolder = (text) =>
  text.replaceAll(/process \d+ \(flock\)|another process/g, "SOMEBODY");

try {
  const first = check();
  expect("the first check", first.stderr + first.status, "0");

  // A time that is to come, far and near, of a result and of the last pruning.
  for (const seconds of [2 ** 40, Date.now() / 1000 + 10 ** 6]) {
    check();
    for (const path of [...results(), join(store, "pruned")]) utimesSync(path, seconds, seconds);
    const { stdout, stderr, status } = prune("0");
    expect(`pruning what is used in ${seconds}`, stderr + status, "0");
    expect(
      "what is left",
      stdout.replace(/^.*; /, ""),
      "kept 0 results and 0 prepared headers (0 bytes)\n",
    );
  }

  // Entries that are many folders in each other.
  check();
  const entries = results();
  for (const path of entries) {
    rmSync(path);
    makeDeep(path);
  }
  const damaged = check();
  for (const line of damaged.stderr.trimEnd().split("\n")) {
    if (!/^note: the store's entry \w+\/[0-9a-f]{64} was damaged; it is made again$/.test(line)) {
      failures.push(`a check of deep entries says ${line}`);
    }
  }
  expect("the check of deep entries", String(damaged.status), "0");
  expect("the check after that", check().stderr, "");
  expect("an entry that was deep", String(results().length), String(entries.length));

  // Once a day, and when it is asked for.
  makeDeep(join(store, "ac/aa"));
  utimesSync(join(store, "pruned"), 0, 0);
  const foreign = `note: no store has written ${join(store, "ac/aa/d")}, so it stays; remove it where it is nobody's\n`;
  expect("the pruning of each day", check().stderr, foreign);
  expect("a check after it", check().stderr, "");
  const pruned = prune("1GB");
  expect("a pruning that is asked for", pruned.stderr + pruned.status, `${foreign}0`);

  const lock = join(store, "lock");
  let free = await holder("-x");
  const waiting = `note: waiting for ${lock}, which SOMEBODY holds`;
  const locked = check();
  expect(
    "a check of a locked store",
    withoutHolder(locked.stderr) + locked.status,
    `${waiting}\nnote: the store is read and not written: SOMEBODY holds ${lock}; end it, or use another store\n0`,
  );
  expect(
    "it is read",
    locked.stdout.replace(/\d+\.\d s$/m, "N s"),
    check().stdout.replace(/\d+\.\d s$/m, "N s"),
  );

  // It waits until the lock is let go, which is after its word.
  const asked = spawn(mjcourse, ["store", "prune", "--keep", "0", "--store", store]);
  let said = "";
  asked.stderr.on("data", (data) => {
    said += data;
    if (free) free();
    free = null;
  });
  const end = await new Promise((resolve) => asked.on("close", resolve));
  expect(
    "a pruning of a locked store",
    withoutHolder(said) + end,
    `${waiting}; end it, or interrupt this\n${foreign}0`,
  );

  // The pruning of each day waits for nobody, but not for ever without a word.
  free = await holder("-s");
  for (const [days, words] of [
    [2, ""],
    [20, `note: the store was not pruned for 20 days, as SOMEBODY holds ${lock}\n`],
  ]) {
    const time = Date.now() / 1000 - days * 24 * 3600 - 60;
    utimesSync(join(store, "pruned"), time, time);
    expect(`a store that is used for ${days} days`, withoutHolder(check().stderr), words);
  }
  free();
} catch (error) {
  failures.push(String(error.stack));
}
// Deeper than Node removes.
run("rm", ["-rf", home]);
cleanUp();
if (failures.length > 0) {
  console.error(failures.join("\n"));
  process.exit(1);
}

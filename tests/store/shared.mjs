// A store that is used by two builds at once, is damaged, or is pruned, gives the same site as one
// that is new.
//
//   node tests/store/shared.mjs MJCOURSE COURSE

import { spawn, spawnSync } from "node:child_process";
import { globSync, readFileSync, statSync, truncateSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { cleanUp, home, run, store } from "./harness.mjs";

const [mjcourse, course] = process.argv.slice(2);
const failures = [];
function expect(good, what) {
  if (!good) failures.push(what);
}

function words(name, kept = store) {
  return ["build", "--course", course, "--store", kept, "--out", join(home, name)];
}

function expectSame(name, what) {
  const compared = spawnSync("diff", ["-rq", join(home, "new"), join(home, name)]);
  expect(compared.status === 0, `${what}: another site\n${compared.stdout}`);
}

function buildAtOnce(names) {
  return Promise.all(
    names.map(
      (name) =>
        new Promise((resolve) => {
          spawn(mjcourse, words(name), { stdio: "ignore" }).on("exit", resolve);
        }),
    ),
  );
}

const entries = () =>
  globSync("{ac,cas}/**", { cwd: store })
    .map((path) => join(store, path))
    .filter((path) => statSync(path).isFile());

try {
  expect(run(mjcourse, words("new", join(home, "alone"))).status === 0, "the first build fails");

  const ends = await buildAtOnce(["one", "two"]);
  expect(
    ends.every((end) => end === 0),
    `two builds at once end with ${ends}`,
  );
  expectSame("one", "one of two builds at once");
  expectSame("two", "the other of two builds at once");

  // Half of the entries lose their ends, the other half have one byte changed.
  for (const [i, path] of entries().entries()) {
    const bytes = readFileSync(path);
    if (i % 2 === 0) truncateSync(path, Math.floor(bytes.length / 2));
    bytes[Math.floor(bytes.length / 3)] ^= 1;
    if (i % 2 === 1) writeFileSync(path, bytes);
  }
  const mended = run(mjcourse, words("mended"));
  expect(mended.status === 0, `a build from a damaged store fails: ${mended.stderr}`);
  expect(
    /^note: the store's entry (?:ac|list|here)\/[0-9a-f]{64} was damaged; it is made again$/m.test(
      mended.stderr,
    ),
    "no note of the damage",
  );
  expectSame("mended", "a damaged store");
  const again = run(mjcourse, words("again"));
  expect(again.stderr === "", `a mended store is still damaged: ${again.stderr}`);
  expectSame("again", "a mended store");

  const size = () => entries().reduce((sum, path) => sum + statSync(path).size, 0);
  const half = Math.floor(size() / 2);
  const pruned = run(mjcourse, ["store", "prune", "--keep", String(half), "--store", store]);
  expect(
    /^forgot \d+ results and \d+ prepared headers? \([\d.]+ [kM]B\); kept \d+ results? and \d+ prepared headers? \([\d.]+ [kM]B\)\n$/.test(
      pruned.stdout,
    ),
    `pruning says ${pruned.stdout}${pruned.stderr}`,
  );
  expect(size() <= half && size() > 0, `${size()} bytes are left of ${2 * half}`);
  expect(run(mjcourse, words("pruned")).status === 0, "a build from a pruned store fails");
  expectSame("pruned", "a pruned store");
} finally {
  cleanUp();
}
for (const failure of failures) console.error(failure);
console.log(`${failures.length} problems`);
process.exitCode = failures.length > 0 ? 1 : 0;

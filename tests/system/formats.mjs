// What `check --format NAME` prints for other tools, of a course with mistakes and of this one: the
// documents agree with each other, and SARIF with its types, which are made of its schema.
//
//   node tests/system/formats.mjs MJCOURSE COURSE

import { spawnSync } from "node:child_process";
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";

const mjcourse = resolve(process.argv[2]);
const clean = resolve(process.argv[3]);
const broken = join(import.meta.dirname, "../courses/together/several-mistakes");
const site = join(import.meta.dirname, "../../site");
const failures = [];

function expect(good, what) {
  if (!good) failures.push(what);
}

function check(course, format, exit) {
  const ran = spawnSync(mjcourse, ["check", "--course", course, `--format=${format}`], {
    encoding: "utf8",
    maxBuffer: 2 ** 26,
  });
  expect(ran.status === exit, `${format} of ${course} exits with ${ran.status}:\n${ran.stderr}`);
  expect(/\d errors?, \d+\.\d s\n/.test(ran.stderr), `${format}: stderr has no summary`);
  return ran.stdout;
}

// The messages of tsc about a file that says that `log` is a SARIF log.
function typeErrors(log) {
  const cache = join(site, "node_modules/.cache");
  mkdirSync(cache, { recursive: true });
  const folder = mkdtempSync(join(cache, "sarif-"));
  try {
    const file = join(folder, "log.ts");
    writeFileSync(file, `import type { Log } from "sarif";\nexport const log: Log = ${log};\n`);
    const tsc = join(site, "node_modules/typescript/bin/tsc");
    const flags = ["--noEmit", "--strict", "--exactOptionalPropertyTypes", "--target", "es2022"];
    const resolving = ["--module", "preserve", "--types", "sarif", "--ignoreConfig"];
    const ran = spawnSync(process.execPath, [tsc, ...flags, ...resolving, file], {
      cwd: site,
      encoding: "utf8",
    });
    return ran.stdout;
  } finally {
    rmSync(folder, { recursive: true });
  }
}

const mistakes = JSON.parse(check(broken, "json", 1)).diagnostics;
expect(mistakes.length > 3, `only ${mistakes.length} mistakes`);

const sarif = check(broken, "sarif", 1);
const results = JSON.parse(sarif).runs[0].results;
expect(
  results.map(({ ruleId }) => ruleId).join() === mistakes.map(({ id }) => id).join(),
  `SARIF has other results:\n${sarif}`,
);
expect(typeErrors(sarif) === "", `SARIF: ${typeErrors(sarif)}`);
const wrong = sarif.replace('"level": "error"', '"level": "bad"');
expect(typeErrors(wrong).includes('"bad"'), "a wrong SARIF log would pass");

const annotations = check(broken, "github", 1).trimEnd().split("\n");
expect(annotations.length === mistakes.length, `GitHub:\n${annotations.join("\n")}`);
expect(
  annotations.every((line) => /^::(error|warning) file=[^,]+,(line=\d+,)?.*::.+$/.test(line)),
  `GitHub:\n${annotations.join("\n")}`,
);

const errors = mistakes.filter(({ severity }) => severity === "error");
const junit = check(broken, "junit", 1);
const failed = [...junit.matchAll(/<failure type="([^"]+)"/g)].map(([, id]) => id);
expect(
  failed.toSorted().join() ===
    errors
      .map(({ id }) => id)
      .toSorted()
      .join(),
  `JUnit:\n${junit}`,
);

const full = JSON.parse(check(clean, "json", 0));
expect(full.diagnostics.length === 0 && full.counts.proved > 100, "JSON of the clean course");
const empty = full.lessons.filter((lesson) => lesson.claims.length === 0);
expect(empty.length === 0, `JSON has no claims of ${empty.map(({ number }) => number).join()}`);
const cases = check(clean, "junit", 0).match(/<testcase /g).length;
const claims = full.lessons.flatMap((lesson) => lesson.claims).length;
expect(cases === claims, `JUnit has ${cases} cases of ${claims} claims`);
expect(check(clean, "github", 0) === "", "GitHub of the clean course");
expect(typeErrors(check(clean, "sarif", 0)) === "", "SARIF of the clean course");

for (const failure of failures) console.log(failure);
console.log(failures.length === 0 ? "1 passed, 0 failed" : "0 passed, 1 failed");
process.exitCode = failures.length === 0 ? 0 : 1;

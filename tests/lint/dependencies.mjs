// CONTRIBUTING's tables name every package that the project installs, and no other; and the lock file
// names packages, not the registry that some machine took them from.
//
//   node tests/lint/dependencies.mjs

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

const read = (name) => readFileSync(new URL(`../../${name}`, import.meta.url), "utf8");

// The names in the first column of the tables that begin with `| HEADING | why |`.
function tableOf(heading) {
  const [, table] = read("CONTRIBUTING.md").split(`| ${heading} | why |\n|---|---|\n`);
  const rows = table.split("\n\n")[0].trim().split("\n");
  return rows.flatMap((row) => row.split("|")[1].split(",")).map((name) => name.trim());
}

test("CONTRIBUTING's table has the Debian packages of packages.txt", () => {
  const installed = read("packages.txt")
    .split("\n")
    .filter((line) => /^[a-z]/.test(line))
    .flatMap((line) => line.split(/ unless | if /)[0].split(" or "));
  assert.deepEqual(tableOf("package").sort(), installed.sort());
});

test("CONTRIBUTING's table has the npm packages of site/package.json", () => {
  const { dependencies, devDependencies } = JSON.parse(read("site/package.json"));
  const installed = Object.keys({ ...dependencies, ...devDependencies });
  assert.deepEqual(tableOf("npm package").sort(), installed.sort());
});

test("the lock file names no registry", () => {
  assert.doesNotMatch(read("site/package-lock.json"), /"resolved"/);
});

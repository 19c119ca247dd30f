// SECURITY.md names a test for each of its claims, and each of these tests is there.
//
//   node tests/lint/security.mjs

import assert from "node:assert/strict";
import { existsSync, globSync, readFileSync } from "node:fs";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const root = fileURLToPath(new URL("../../", import.meta.url));
const page = readFileSync(`${root}SECURITY.md`, "utf8");
const quoted = [...page.matchAll(/`([^`\n]+)`/g)].map(([, text]) => text);

// "SandboxTest.StartsNoProcess", and for each suite "SandboxTest.*".
const unitTests = new Set(
  globSync("tests/generator/**/*_test.cpp", { cwd: root }).flatMap((file) => {
    const text = readFileSync(root + file, "utf8");
    const names = text.matchAll(/^TEST(?:_[FP])?\(\s*(\w+),\s*(\w+)\s*\)/gm);
    return [...names].flatMap(([, suite, name]) => [`${suite}.${name}`, `${suite}.*`]);
  }),
);

test("each unit test that is named is there", () => {
  const named = quoted.filter((text) => /^[A-Z]\w+\.(\*|[A-Z]\w+)$/.test(text));
  assert.notEqual(named.length, 0);
  assert.deepEqual(
    named.filter((name) => !unitTests.has(name)),
    [],
  );
});

test("each file that is named is there", () => {
  const named = quoted.filter((text) => /^(generator|site|tests)\/\S+$/.test(text));
  assert.notEqual(named.length, 0);
  assert.deepEqual(
    named.filter((file) => !existsSync(root + file)),
    [],
  );
});

test("each section that claims something names a test", () => {
  const sections = page.split(/^## /m).slice(1);
  const claims = (section) => !/^(What a change can bring|What is fuzzed)/.test(section);
  const untested = sections.filter(
    (section) => claims(section) && !/\*(Tests?:|Fails otherwise)|\| test \|/.test(section),
  );
  assert.deepEqual(
    untested.map((section) => section.split("\n")[0]),
    [],
  );
});

// Which numbers of a reader are right, in a question and in a lab. The generator is held against the
// same table, by tests/generator/lesson/json/tolerance_test.cpp.
//
//   node --test tests/site/near.mjs

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { isNear } from "../../site/browser/client/quiz/near.ts";

const table = JSON.parse(readFileSync(new URL("../near.json", import.meta.url), "utf8"));

for (const { given, right, tolerance, near } of table) {
  test(`${given} is ${near ? "" : "not "}within ${tolerance} of ${right}`, () => {
    assert.equal(isNear(given, right, tolerance), near);
  });
}

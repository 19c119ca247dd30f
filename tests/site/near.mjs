// Which numbers of a reader are right.
//
//   node --test tests/site/near.mjs

import assert from "node:assert/strict";
import { test } from "node:test";

import { isNear } from "../../site/client/quiz/near.ts";

test("a tolerance is met at its end, whatever binary makes of decimals", () => {
  assert.ok(isNear(1.1, 1, 0.1));
  assert.ok(isNear(0.9, 1, 0.1));
  assert.ok(!isNear(1.11, 1, 0.1));
  assert.ok(isNear(31, 30, 1));
});

test("without one, only rounding is allowed for", () => {
  assert.ok(isNear(0.1 + 0.2, 0.3, 0));
  assert.ok(!isNear(0.3000001, 0.3, 0));
});

test("a small answer is as exact as any other", () => {
  assert.ok(isNear(1.6e-19, 1.6e-19, 0));
  assert.ok(!isNear(5e-19, 1.6e-19, 0));
  assert.ok(!isNear(0, 1.6e-19, 0));
});

test("a whole number is right to its last digit", () => {
  assert.ok(isNear(1000000000001, 1000000000001, 0));
  assert.ok(!isNear(1000000000002, 1000000000001, 0));
});

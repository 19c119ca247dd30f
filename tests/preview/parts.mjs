// What of a page stays when a newer one comes: as much as possible, in its order.

import assert from "node:assert/strict";
import { test } from "node:test";

import { commonPairs } from "../../site/browser/preview/parts.ts";

const pairs = (before, after) => commonPairs([...before], [...after]);

test("what is the same stays as a whole", () => {
  assert.deepEqual(pairs("abc", "abc"), [
    [0, 0],
    [1, 1],
    [2, 2],
  ]);
  assert.deepEqual(pairs("", ""), []);
});

test("one part that changed leaves those around it", () => {
  assert.deepEqual(pairs("abc", "aXc"), [
    [0, 0],
    [2, 2],
  ]);
});

test("parts that come or go move the others", () => {
  assert.deepEqual(pairs("abc", "abXc"), [
    [0, 0],
    [1, 1],
    [2, 3],
  ]);
  assert.deepEqual(pairs("abc", "c"), [[2, 0]]);
  assert.deepEqual(pairs("", "ab"), []);
});

test("parts that are equal are not taken twice", () => {
  assert.deepEqual(pairs("aa", "aaa"), [
    [0, 0],
    [1, 1],
  ]);
});

test("of several ways the one that keeps most", () => {
  const kept = pairs("xabcdey", "zcabdexw").map(([i]) => "xabcdey"[i]);
  assert.equal(kept.join(""), "abde");
});

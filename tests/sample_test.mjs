// Every share comes, together they are all, and what chose one chooses it again.
//
//   node --test tests/sample_test.mjs

import assert from "node:assert/strict";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";

import { commitOf, sampleOf } from "./sample.mjs";

const names = Array.from({ length: 400 }, (_, i) => `program-${i}`);
const chosen = (environment) => {
  const sample = sampleOf(8, { environment });
  return names.filter((name) => sample.has(name));
};

test("commits choose all shares, each about an eighth, and none twice", () => {
  const seen = new Map();
  for (let commit = 0; commit < 100; ++commit) {
    const environment = { MJCOURSE_SAMPLE: `commit-${commit}` };
    const { share } = sampleOf(8, { environment });
    const some = chosen(environment);
    assert.ok(some.length > 25 && some.length < 80, `${some.length} of 400`);
    assert.deepEqual(seen.get(share) ?? some, some);
    seen.set(share, some);
  }
  assert.deepEqual([...seen.keys()].sort(), [0, 1, 2, 3, 4, 5, 6, 7]);
  assert.deepEqual([...seen.values()].flat().sort(), names.toSorted());
});

test("the long mode takes all, unless a commit is asked for", () => {
  assert.deepEqual(chosen({ MJCOURSE_LONG: "1" }), names);
  assert.deepEqual(chosen({ MJCOURSE_SAMPLE: "all" }), names);
  assert.notDeepEqual(chosen({ MJCOURSE_SAMPLE: "a", MJCOURSE_LONG: "1" }), names);
});

test("without git there is no commit", () => {
  const folder = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
  assert.equal(commitOf(folder), "");
  rmSync(folder, { recursive: true });
});

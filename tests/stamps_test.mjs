// A stamp stays while somebody asks for it, and goes after two months in which nobody did.
//
//   node --test tests/stamps_test.mjs

import assert from "node:assert/strict";
import { mkdtempSync, rmSync, utimesSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";

import { Stamps } from "./stamps.mjs";

const cache = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
after(() => rmSync(cache, { recursive: true }));
process.env.XDG_CACHE_HOME = cache;

function age(stamp, days) {
  const then = new Date(Date.now() - days * 24 * 3600 * 1000);
  utimesSync(join(cache, "mjcourse/trial", stamp), then, then);
}

test("what was put there is there, until nobody has asked for it in two months", () => {
  const stamps = new Stamps("trial");
  for (const stamp of ["asked", "forgotten"]) stamps.put(stamp, `of ${stamp}`);
  assert.equal(stamps.get("asked"), "of asked");
  assert.equal(stamps.get("never"), undefined);
  for (const stamp of ["asked", "forgotten"]) age(stamp, 59);
  assert.ok(new Stamps("trial").has("asked")); // a day before its time, which begins anew
  age("forgotten", 61);
  const later = new Stamps("trial");
  assert.deepEqual(
    ["asked", "forgotten"].map((stamp) => later.has(stamp)),
    [true, false],
  );
});

test("asking for a stamp keeps it", () => {
  const stamps = new Stamps("trial");
  stamps.put("old", "");
  age("old", 61);
  assert.ok(stamps.has("old"));
  assert.ok(new Stamps("trial").has("old"));
});

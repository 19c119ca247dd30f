// What a reader waits for before a lab starts: node --test tests/engine/size.mjs

import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { brotliCompressSync } from "node:zlib";

import { built } from "./harness.mjs";

const compressed = (file) => brotliCompressSync(readFileSync(path.join(built, file))).length;

test("the engine with its glue is at most 450 KB, compressed", (t) => {
  const sizes = ["engine.wasm", "engine.mjs"].map(compressed);
  t.diagnostic(`brotli: ${sizes.join(" + ")} bytes`);
  assert.ok(sizes[0] + sizes[1] <= 450_000);
});

test("the licence of each library is beside it", () => {
  const pinned = readFileSync(
    new URL("../../site/browser/engine/sources.txt", import.meta.url),
    "utf8",
  );
  const packages = pinned.match(/^[a-z]\w+/gm);
  assert.equal(packages.length, 6);
  for (const name of packages)
    assert.ok(existsSync(path.join(built, "licenses", `${name}.txt`)), name);
});

// What a lab fetches, and what it says when that does not arrive.
//
//   node --test tests/site/lab/run-resources.mjs

import assert from "node:assert/strict";
import { test } from "node:test";

import { lab } from "./run-harness.mjs";

const said = (what) => ({
  name: "Unreachable",
  message: `${what} could not be loaded. Check your connection, then reload the page.`,
});

test("the engine is asked for once, and again after it failed", async () => {
  const address = { glue: "file:///nowhere/engine.mjs", wasm: "file:///nowhere/engine.wasm" };
  const [first, second] = [lab.openEngine(address), lab.openEngine(address)];
  assert.equal(first, second);
  await assert.rejects(first, said("The simulator"));
  const third = lab.openEngine(address);
  assert.notEqual(first, third);
  await assert.rejects(third, said("The simulator"));
});

test("a lab that is not there", async () => {
  await assert.rejects(lab.loadModule("file:///nowhere/1.2-1.js"), said("The lab"));
});

test("the files of a model", async (t) => {
  const asked = [];
  t.mock.method(globalThis, "fetch", (url) => {
    asked.push(url.href);
    const status = url.href.includes("missing") ? 404 : 200;
    return Promise.resolve(new Response(Uint8Array.of(1, 2, 3), { status }));
  });
  const model = (address) => ({
    name: "arm.xml",
    texts: { "arm.xml": "<mujoco/>" },
    assets: { "arm.stl": address },
  });
  const module = "https://course.example/some/labs/1.2-1-HASH.js";
  assert.deepEqual(await lab.fetchFiles(module, model("../models/arm-HASH.stl")), {
    "arm.xml": "<mujoco/>",
    "arm.stl": Uint8Array.of(1, 2, 3),
  });
  assert.deepEqual(asked, ["https://course.example/some/models/arm-HASH.stl"]);
  await assert.rejects(
    lab.fetchFiles(module, model("../missing.stl")),
    said("A part of the model"),
  );
});

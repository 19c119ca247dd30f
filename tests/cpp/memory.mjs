// How the page's compiler takes its memory: node --test tests/cpp/memory.mjs

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { WASI } from "node:wasi";

import { withLargerSteps } from "../../site/bundle/allocation-step.mjs";
import { cpp } from "./runner.mjs";

test("it takes 4 MiB at a time", () => {
  const wasi = new WASI({ version: "preview1", args: ["clang", "--version"], returnOnExit: true });
  const program = new WebAssembly.Module(readFileSync(path.join(cpp, "llvm.wasm")));
  const instance = new WebAssembly.Instance(program, wasi.getImportObject());
  const { memory } = instance.exports;
  const before = memory.buffer.byteLength;
  wasi.start(instance);
  const taken = memory.buffer.byteLength - before;
  assert.equal(taken, 4 << 20);
});

test("another allocator is not changed unseen", () => {
  assert.throws(() => withLargerSteps(Buffer.from("a program of another compiler")), {
    message:
      "the compiler for the page (@yowasp/clang) has another allocator than " +
      "site/bundle/allocation-step.mjs knows; look there whether it still takes memory in small steps",
  });
});

// How the page's compiler takes its memory: node --test tests/cpp/memory.mjs

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { WASI } from "node:wasi";

import { withLargerSteps } from "../../site/bundle/allocation-step.mjs";
import { withImportedMemory } from "../../site/bundle/imported-memory.mjs";
import { cpp, helpers, Runner } from "./runner.mjs";

const pageSize = 64 << 10;

// By how many bytes `clang --version` makes a memory of 384 pages grow, up to `heapEnd` of which is its
// heap's.
function growth(program, heapEnd) {
  const wasi = new WASI({ version: "preview1", args: ["clang", "--version"], returnOnExit: true });
  const memory = new WebAssembly.Memory({ initial: 384 });
  const imports = { ...wasi.getImportObject(), env: { memory } };
  const instance = new WebAssembly.Instance(program, imports);
  instance.exports.heap_end.value = heapEnd * pageSize;
  wasi.start(instance);
  return memory.buffer.byteLength - 384 * pageSize;
}

test("it uses the heap that it is given, and takes 4 MiB more at a time", () => {
  const program = new WebAssembly.Module(readFileSync(path.join(cpp, "llvm.wasm")));
  const itsOwnPages = 278; // full of constants
  assert.equal(growth(program, itsOwnPages), 4 << 20);
  assert.equal(growth(program, 384), 0);
});

test("another allocator is not changed unseen", () => {
  assert.throws(() => withLargerSteps(Buffer.from("a program of another compiler")), {
    message:
      "the compiler for the page (@yowasp/clang) has another allocator than " +
      "site/bundle/allocation-step.mjs knows; look there whether it still takes memory in small steps",
  });
  const empty = Buffer.from([0x00, 0x61, 0x73, 0x6d, 0x01, 0x00, 0x00, 0x00]);
  const oneMemory = Buffer.from([0x05, 0x03, 0x01, 0x00, 0x01]);
  for (const program of [empty, Buffer.concat([empty, oneMemory])]) {
    assert.throws(() => withImportedMemory(program), {
      message:
        "the compiler for the page (@yowasp/clang) takes its memory otherwise than " +
        "site/bundle/imported-memory.mjs knows; look there how its allocator finds the end of it",
    });
  }
});

const programs = {
  small: "int main() { return 1; }\n",
  wrong: "int main() { return none; }\n",
  large: `#include <mjcourse/mjcourse.hpp>
int main() {
  Eigen::MatrixXd a = Eigen::MatrixXd::Random(4, 4);
  return int(a.fullPivLu().rank() + a.eigenvalues().size());
}
`,
  plain:
    "#include <map>\n#include <string>\nint main() { return std::map<std::string, int>()[{}]; }\n",
};

// The modules of programs that one process compiles in this order.
async function modulesOf(names) {
  const runner = new Runner();
  const modules = [];
  for (const name of names) {
    const files = { ...helpers, "p.cpp": programs[name] };
    modules.push((await runner.ask("p.cpp", files)).module);
  }
  runner.close();
  return modules;
}

test("what was compiled before in its memory changes no byte", async () => {
  const [small, wrong, large, plain] = await modulesOf(["small", "wrong", "large", "plain"]);
  assert.equal(wrong, null);
  const others = await modulesOf(["plain", "large", "small", "large", "wrong", "plain", "small"]);
  assert.deepEqual(others, [plain, large, small, large, null, plain, small]);
});

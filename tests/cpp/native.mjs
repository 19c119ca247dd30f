// Debian's clang in the place of the page's compiler, and what happens where it cannot be that:
// node --test tests/cpp/native.mjs

import assert from "node:assert/strict";
import { cpSync, existsSync, mkdtempSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, test } from "node:test";

import { cpp, Runner } from "./runner.mjs";

// tests/CMakeLists.txt knows these words.
if (!existsSync(path.join(cpp, "native/probe.o"))) {
  console.log("there is no native compiler for the page's programs");
  process.exit();
}

const home = mkdtempSync(path.join(tmpdir(), "mjcourse-test-"));
after(() => rmSync(home, { recursive: true }));

// The compiler's folder, with another native/ in it.
function withNative(name, change) {
  const folder = path.join(home, name);
  cpSync(path.join(cpp, "native"), path.join(folder, "native"), { recursive: true });
  for (const file of ["llvm.wasm", "cpp.pack", "header.pch"]) {
    symlinkSync(path.join(cpp, file), path.join(folder, file));
  }
  change(path.join(folder, "native"));
  return folder;
}

const program = `#include "mjcourse/mjcourse.hpp"
#include <Eigen/Dense>
#include <cstdio>
int main(int, char** words) {
  const Eigen::Vector3d x(1, 2, 2);
  std::printf("%s %g\\n", words[0], x.norm());
  return 3;
}
`;

// What comes of it in a process with these options, but for the time that it took.
async function compiled(text, options = [], folder = cpp) {
  const runner = new Runner(folder, options);
  try {
    const answer = await runner.ask("p.cpp", { "p.cpp": text });
    delete answer.seconds;
    return answer;
  } finally {
    runner.close();
  }
}

const nowhere = withNative("nowhere", (native) => rmSync(native, { recursive: true }));

test("a module is the same to the byte as the page's own compiler makes it", async () => {
  const native = await compiled(program);
  const own = await compiled(program, [], nowhere);
  assert.ok(native.ok);
  assert.equal(native.module, own.module);
});

test("what is said of a program is said by the page's own compiler", async () => {
  const warned = "int main() { int unused; }\n";
  const wrong = "int main() { return none; }\n";
  for (const text of [warned, wrong]) {
    const native = await compiled(text);
    const own = await compiled(text, [], nowhere);
    assert.deepEqual(native, own);
    assert.equal(native.diagnostics.length, 1);
  }
});

test("a compiler that makes another probe is not used", async () => {
  const other = withNative("other", (native) => {
    writeFileSync(path.join(native, "probe.cpp"), "int main() { return 1; }\n");
    // With it, no program would compile.
    rmSync(path.join(native, "root/usr"), { recursive: true });
  });
  assert.ok((await compiled(program, [], other)).ok);
});

test("where all are compared, another object ends the process", async () => {
  const other = withNative("wrong", (native) => {
    // None of the precompiled header's.
    const header = path.join(native, "root/usr/include/c++/v1/any");
    writeFileSync(header, "int other;\n", { flag: "a" });
  });
  const text = "#include <any>\nint main() {}\n";
  const compare = ["--compare-all"];
  assert.ok((await compiled(text, compare)).ok);
  assert.equal((await compiled(text, compare, other)).exited, 1);
});

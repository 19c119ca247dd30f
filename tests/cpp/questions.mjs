// What the build asks of the page's compiler one by one: node --test tests/cpp/questions.mjs

import assert from "node:assert/strict";
import { after, test } from "node:test";

import { Runner } from "./runner.mjs";

const runner = new Runner();
after(() => runner.close());

const compile = (files) => runner.ask("p.cpp", files, { kind: "compile" });
const run = (module, files = {}, more = {}) =>
  runner.ask("p.cpp", files, { kind: "run", module, ...more });

test("a program is compiled, and its module run with other models and arguments", async () => {
  const files = {
    "p.cpp": `#include <cstdio>
#include <fstream>
#include <string>
int main(int, char** argv) {
  std::string line;
  std::getline(std::ifstream("/models/a.txt"), line);
  std::printf("%s %s\\n", argv[1], line.c_str());
  std::ofstream("/records") << "{}";
  return 3;
}
`,
  };
  const { seconds, module, ...compiled } = await compile(files);
  assert.deepEqual(compiled, { ok: true, diagnostics: [] });
  assert.ok(seconds.compile > 0 && seconds.link > 0);
  assert.match(module, /^[0-9a-f]{64}$/);
  for (const word of ["one", "two"]) {
    const { seconds: ran, ...rest } = await run(
      module,
      { "models/a.txt": `${word}s` },
      { arguments: [word] },
    );
    assert.deepEqual(rest, {
      ...{ out: `${word} ${word}s\n`, err: "", records: "{}" },
      ...{ end: { how: "exit", code: 3 }, offsets: [] },
    });
    assert.ok(ran.run > 0);
  }
});

test("what does not compile has no module", async () => {
  const { ok, module, diagnostics } = await compile({ "p.cpp": "int main() { return none; }\n" });
  assert.deepEqual({ ok, module }, { ok: false, module: null });
  assert.equal(diagnostics[0].message, "use of undeclared identifier 'none'");
});

test("an end is placed in the program that is asked of, though others share its module", async () => {
  const lines = ["int main(int argc, char**) {", "return 1 / (argc - 1);", "}", ""];
  const files = { "p.cpp": lines.join("\n") };
  const commented = { "p.cpp": `// which is so\n${lines.join("\n")}` };
  const { module } = await compile(files);
  assert.equal((await compile(commented)).module, module);
  const { end, offsets } = await run(module);
  assert.deepEqual(end, { how: "trap", message: "divide by zero" });
  const placed = (of) => runner.ask("p.cpp", of, { kind: "place", end, offsets });
  assert.deepEqual(await placed(files), { end: { ...end, line: 2 } });
  assert.deepEqual(await placed(commented), { end: { ...end, line: 3 } });
});

test("an end for want of a main is told when it is placed", async () => {
  const files = { "p.cpp": "int x;\n" };
  const { end, offsets } = await run((await compile(files)).module);
  const placed = await runner.ask("p.cpp", files, { kind: "place", end, offsets });
  const message = "it has no main(), where a program begins";
  assert.deepEqual(placed, { end: { how: "trap", message } });
});

test("the last four modules are kept", async () => {
  const returns = async (code) =>
    (await compile({ "p.cpp": `int main() { return ${code}; }\n` })).module;
  const modules = [];
  for (const code of [1, 2, 3, 4]) modules.push(await returns(code));
  await run(modules[0]);
  modules.push(await returns(5));
  const codes = [];
  for (const module of modules) codes.push((await run(module)).end?.code);
  assert.deepEqual(codes, [1, undefined, 3, 4, 5]);
  assert.deepEqual(await run(modules[1]), { unknownModule: true });
});

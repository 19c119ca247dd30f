// What the page's compiler says of programs, and which headers it takes:
// node --test tests/cpp/compiles.mjs

import assert from "node:assert/strict";
import { after, test } from "node:test";

import { helpers, Runner } from "./runner.mjs";

const runner = new Runner();
after(() => runner.close());

async function diagnosticsOf(program, files = helpers) {
  const { ok, end, diagnostics } = await runner.ask("a/p.cpp", { ...files, "a/p.cpp": program });
  return { ok, end, diagnostics };
}

test("an error has its place", async () => {
  const { ok, end, diagnostics } = await diagnosticsOf("int main() {\n  return añil + none;\n}\n");
  assert.equal(ok, false);
  assert.equal(end, null);
  assert.deepEqual(diagnostics, [
    {
      file: "a/p.cpp",
      ...{ line: 2, column: 10, endLine: 2, endColumn: 15 },
      severity: "error",
      message: "use of undeclared identifier 'añil'",
    },
    {
      file: "a/p.cpp",
      ...{ line: 2, column: 18, endLine: 2, endColumn: 22 },
      severity: "error",
      message: "use of undeclared identifier 'none'",
    },
  ]);
});

test("a warning keeps nobody from running", async () => {
  const { ok, end, diagnostics } = await diagnosticsOf("int main() { int unused; }\n");
  assert.equal(ok, true);
  assert.deepEqual(end, { how: "exit", code: 0 });
  assert.deepEqual(
    diagnostics.map(({ severity, message }) => `${severity}: ${message}`),
    ["warning: unused variable 'unused' [-Wunused-variable]"],
  );
});

test("what is defined nowhere is named, and what draws says why", async () => {
  const { ok, diagnostics } = await diagnosticsOf(
    "#include <mujoco/mujoco.h>\nvoid f(int);\n" +
      "int main() { f(1); mjrContext c; mjr_defaultContext(&c); }\n",
  );
  assert.equal(ok, false);
  assert.deepEqual(
    diagnostics.map(({ line, message }) => `${line}: ${message}`),
    [
      "0: f(int) is declared and used, but defined nowhere",
      "0: mjr_defaultContext: a page has no OpenGL to draw with",
    ],
  );
});

test("a line that the program says is of another file is told with that file's name", async () => {
  const { ok, diagnostics } = await diagnosticsOf(
    'int main() {\n#line 5 "a.y"\n  return none;\n}\n',
  );
  assert.equal(ok, false);
  assert.deepEqual(
    diagnostics.map(({ file, line, message }) => `${file}:${line}: ${message}`),
    ["a.y:5: use of undeclared identifier 'none'"],
  );
});

test("a program's own header comes before the pack's, with the sources beside it", async () => {
  const files = {
    "a/include/mjcourse/mjcourse.hpp": "#pragma once\n#define OWN 5\nint other();\n",
    "a/include/mjcourse/handlers.cpp": "int handled = 1;\n",
    "a/other.cpp": "int other() { return 2; }\n",
  };
  const program = "#include <mjcourse/mjcourse.hpp>\nint main() { return OWN + other(); }\n";
  assert.deepEqual((await diagnosticsOf(program, files)).end, { how: "exit", code: 7 });
});

test("a solver that was compiled before has the name that it would have", async () => {
  const program = `#include <Eigen/Dense>
using namespace Eigen;
LDLT<MatrixXd> a;
LDLT<Matrix<double, 6, 6>> b;
PartialPivLU<MatrixXcd> c;
int main() { return a.none + b.none + c.none; }
`;
  const { diagnostics } = await diagnosticsOf(program);
  assert.deepEqual(
    diagnostics.map(({ message }) => message),
    [
      "no member named 'none' in 'Eigen::LDLT<Eigen::Matrix<double, -1, -1>>'",
      "no member named 'none' in 'Eigen::LDLT<Eigen::Matrix<double, 6, 6>>'",
      "no member named 'none' in 'Eigen::PartialPivLU<Eigen::Matrix<std::complex<double>, -1, -1>>'",
    ],
  );
});

test("a macro before an include is heeded", async () => {
  const program =
    "#define EIGEN_STACK_ALLOCATION_LIMIT 7\n#include <Eigen/Core>\n" +
    "int main() { return EIGEN_STACK_ALLOCATION_LIMIT; }\n";
  assert.deepEqual((await diagnosticsOf(program)).end, { how: "exit", code: 7 });
});

test("Eigen's solvers, compiled once, print what they print when a program compiles them", async () => {
  const program = `#include <Eigen/Dense>
#include <cstdio>
int main() {
  Eigen::MatrixXd a(3, 3);
  a << 4, 1, 0.1, 1, 3, 0.2, 0.1, 0.2, 2;
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(3, 0.1, 0.7);
  const Eigen::VectorXd x = a.ldlt().solve(b), y = a.householderQr().solve(b), z = a.inverse() * b;
  for (int i = 0; i < 3; ++i) std::printf("%a %a %a\\n", x[i], y[i], z[i]);
}
`;
  const run = (text) => runner.ask("p.cpp", { "p.cpp": text });
  const once = await run(program);
  const itself = await run(`#define BEFORE_INCLUDES\n${program}`);
  assert.deepEqual([once.end, once.diagnostics], [{ how: "exit", code: 0 }, []]);
  assert.match(once.out, /^(-?0x1\S+ -?0x1\S+ -?0x1\S+\n){3}$/);
  assert.equal(once.out, itself.out);
});

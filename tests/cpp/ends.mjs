// How a reader's program ends in the page, and what it leaves: node --test tests/cpp/ends.mjs

import assert from "node:assert/strict";
import { after, test } from "node:test";

import { helpers, Runner } from "./runner.mjs";

const runner = new Runner();
after(() => runner.close());

const head = `
#include <mjcourse/mjcourse.hpp>
#include <array>
#include <atomic>
#include <cassert>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <fcntl.h>
#include <unistd.h>
#include <wasi/api.h>
using namespace mjcourse;
`;

// Where the body of main begins.
const firstLine = head.split("\n").length + 2;

// Runs a program with this main.
async function run(body, files = {}, more = {}) {
  const program = `${head}int main(int argc, char** argv) {\n(void)argc; (void)argv;\n${body}\n}\n`;
  const answer = await runner.ask("p.cpp", { ...helpers, ...files, "p.cpp": program }, more);
  assert.deepEqual(
    answer.diagnostics.filter(({ severity }) => severity === "error"),
    [],
  );
  return answer;
}

// With the line of the body, from 1, for that of the program.
async function endOf(body) {
  const { end } = await run(body);
  const { line, ...rest } = end;
  return line === undefined ? rest : { ...rest, line: line - firstLine + 1 };
}

test("it says what it prints, and with which code it ends", async () => {
  const { out, err, end } = await run(
    `std::puts(argv[1]); std::fputs("é\\n", stderr); return 3;`,
    {},
    { arguments: ["two words"] },
  );
  assert.deepEqual(
    { out, err, end },
    { out: "two words\n", err: "é\n", end: { how: "exit", code: 3 } },
  );
});

test("it loads a model, and records what it found", async () => {
  const model = `<mujoco><worldbody><body><joint/><geom size="1"/></body></worldbody></mujoco>`;
  const { out, records } = await run(
    `const Model m = load_model("top"); const Data d = make_data(m);
     mj_step(m, d); std::printf("%d %g\\n", m->nv, d->time); result("time", d->time);`,
    { "models/top.xml": model },
  );
  assert.equal(out, "1 0.002\n");
  assert.equal(records, '{"result": "time", "value": 0.002}\n');
});

test("MuJoCo's callbacks, variables and files are the program's", async () => {
  const { out } = await run(`
    mjcb_control = [](const mjModel*, mjData* data) { data->ctrl[0] = 2; };
    const Model m = load_model_xml("<mujoco><worldbody><body><joint name='j'/><geom size='1'/></body>"
        "</worldbody><actuator><motor joint='j'/></actuator></mujoco>");
    const Data d = make_data(m);
    mj_step(m, d);
    std::printf("%g %s\\n", d->ctrl[0], mjDISABLESTRING[0]);
    mj_saveModel(m, "top.mjb", nullptr, 0);
    mjModel* again = mj_loadModel("top.mjb", nullptr);
    std::printf("%d\\n", again->nu);`);
  assert.equal(out, "2 Constraint\n1\n");
});

test("an exception is caught, and one that is not says what it was", async () => {
  const { out } = await run(`
    try { load_model("none"); } catch (const std::exception& error) { std::puts(error.what()); }
    try { (void)new char[2000000000]; } catch (const std::bad_alloc&) { std::puts("no room"); }`);
  assert.equal(out, "no model 'none': /models/none.xml is not there\nno room\n");
  assert.deepEqual(await endOf(`\nthrow std::runtime_error("so it is");`), {
    how: "uncaught",
    message: "std::runtime_error: so it is",
    line: 2,
  });
});

test("MuJoCo's error ends it with what MuJoCo said", async () => {
  assert.deepEqual(await endOf(`\n\nmju_error_s("no %s", "air");`), {
    how: "error",
    message: "no air",
    line: 3,
  });
});

const unreachable = "a null pointer was followed, or a function ended without its return";

test("a trap says which", async () => {
  const endings = {
    [`volatile int none = 0; std::printf("%d", 1 / none);`]: "divide by zero",
    [`*(volatile int*)0xfffffff0 = 1;`]: "memory access out of bounds",
    [`mjData* none = nullptr; none->time = argc;`]: unreachable,
    [`std::vector<int>* none = nullptr; return int(none->size());`]: unreachable,
    [`std::printf("%d", [](int n) -> int { if (n > 5) return 1; }(argc));`]: unreachable,
    [`std::abort();`]: "it called abort()",
    [`assert(argc == 5);`]: `Assertion failed: argc == 5 (p.cpp: main: ${firstLine})`,
  };
  for (const [body, message] of Object.entries(endings)) {
    assert.deepEqual(await endOf(body), { how: "trap", message, line: 1 });
  }
});

test("an end has the line of the program's own that called for it", async () => {
  const called = "const auto at = [](int i) {\nreturn std::array<int, 1>().at(i);\n};\n\nat(1);";
  const { how, line } = await endOf(called);
  assert.deepEqual({ how, line }, { how: "uncaught", line: 2 });
  assert.equal((await endOf(`\n\nload_model("none");`)).line, 3, "the header's lines are not its");
  const caught = "try {\nthrow 1;\n} catch (int) {\n}\n";
  assert.equal((await endOf(`${caught}std::abort();`)).line, 5);
  assert.equal((await endOf(`${caught}return 1;`)).line, undefined, "it returned");
});

test("what has no main, and what no linker can take, says so", async () => {
  const none = await runner.ask("p.cpp", { "p.cpp": "int x;\n" });
  assert.deepEqual(none.end, { how: "trap", message: "it has no main(), where a program begins" });
  const written = await runner.ask("p.cpp", {
    "include/begin.hpp": "int main() { return 0; }\n",
    "p.cpp": '#include "begin.hpp"\n',
  });
  assert.deepEqual(written.end, { how: "exit", code: 0 });
  const large = "static char big[3000000000u];\nint main() { return big[7]; }\n";
  const { ok, diagnostics } = await runner.ask("p.cpp", { "p.cpp": large });
  assert.equal(ok, false);
  assert.match(diagnostics[0].message, /crashed on this program|too large|memory/);
});

test("what the C++ library throws is caught, too", async () => {
  const { out } = await run(`
    try { (void)std::stoi("x"); } catch (const std::invalid_argument& e) { std::puts(e.what()); }
    try { (void)std::stod("1e999"); } catch (const std::out_of_range& e) { std::puts(e.what()); }
    try { std::string().at(1); } catch (const std::logic_error&) { std::puts("at"); }`);
  assert.equal(out, "stoi: no conversion\nstod: out of range\nat\n");
});

test("it may fill neither stack, memory nor page", async () => {
  const endings = {
    [`std::function<int(int)> f = [&](int n) { return n + f(n + 1); }; return f(0);`]:
      "stack-overflow",
    [`std::vector<double> all; for (;;) all.resize(all.size() + 100000000);`]: "memory",
    [`static double large[3000000]; large[argc] = 1; return large[0] > 1;`]: "memory",
    [`for (;;) std::puts("again and again");`]: "output",
  };
  for (const [body, how] of Object.entries(endings))
    assert.equal((await endOf(body)).how, how, body);
});

test("a file is as large as natively, and no larger", async () => {
  const full = { how: "trap", message: "it wrote a file of more than 32 MiB", line: 3 };
  const open = `std::FILE* f = std::fopen("f", "w");\nstd::fseek(f, (32 << 20) - 1, SEEK_SET);\n`;
  assert.deepEqual(await endOf(`${open}std::fputc(1, f); std::fclose(f);`), {
    how: "exit",
    code: 0,
  });
  assert.deepEqual(await endOf(`${open}std::fputs("12", f); std::fclose(f);`), full);
  const cut = "\n\nftruncate(fileno(f), 4000000000ll);";
  const { end } = await run(`std::FILE* f = std::fopen("f", "w");${cut}`);
  assert.deepEqual([end.how, end.message], [full.how, full.message]);
});

test("a call with a place that nothing can have gives its error", async () => {
  const { out, end } = await run(
    `const int f = open("f", O_CREAT | O_RDWR, 0666);
     char text[] = "1";
     __wasi_ciovec_t from{reinterpret_cast<const uint8_t*>(text), 1};
     __wasi_iovec_t into{reinterpret_cast<uint8_t*>(text), 1};
     const auto place = static_cast<__wasi_filesize_t>(-5);
     __wasi_size_t done = 0;
     std::printf("%d ", __wasi_fd_pwrite(f, &from, 1, place, &done) == __WASI_ERRNO_INVAL);
     std::printf("%d ", __wasi_fd_pread(f, &into, 1, place, &done) == __WASI_ERRNO_INVAL);
     std::printf("%d", __wasi_fd_filestat_set_size(f, place) == __WASI_ERRNO_INVAL);`,
  );
  assert.deepEqual({ out, end }, { out: "1 1 1", end: { how: "exit", code: 0 } });
});

test("an import that the page does not have is told by its name", async () => {
  const program = `__attribute__((import_module("env"), import_name("eval"))) extern "C" int foreign(int);
int main() { return foreign(1); }
`;
  const { end } = await runner.ask("p.cpp", { "p.cpp": program });
  const message = "it imports “eval” of “env”, which a page does not have";
  assert.deepEqual(end, { how: "trap", message });
  const module = program.replace('"env"', '"other"');
  const other = await runner.ask("p.cpp", { "p.cpp": module });
  assert.equal(other.end.message, "it imports “eval” of “other”, which a page does not have");
});

test("a template without end is told, and the compiler compiles the next program", async () => {
  const program = "template <int N> struct X { X<N + 1> a; };\nX<0> x;\nint main() {}\n";
  const { ok, diagnostics } = await runner.ask("p.cpp", { "p.cpp": program });
  assert.equal(ok, false);
  assert.equal(
    diagnostics.at(-1).message,
    "this program is nested too deeply for the compiler: does a template name itself without end?",
  );
  assert.deepEqual(await endOf("return 3;"), { how: "exit", code: 3 });
});

test("threads run one after the other, and none may wait", async () => {
  const { out } = await run(`
    int sum = 0;
    std::vector<std::thread> all;
    for (int i = 1; i < 4; ++i) all.emplace_back([i, &sum] { sum += i; });
    for (std::thread& one : all) one.join();
    std::printf("%d\\n", sum);`);
  assert.equal(out, "6\n");

  const message = "a thread waits for another, and a page runs one after the other";
  const waits = `std::mutex m; std::condition_variable told; bool go = false;
    std::thread([&] { std::unique_lock lock(m); told.wait(lock, [&] { return go; }); }).join();`;
  const spins = `std::atomic<bool> go = false;
    std::thread([&] { while (!go) std::this_thread::yield(); }).join();`;
  for (const body of [waits, spins]) {
    const { how, message: said, line } = await endOf(body);
    assert.deepEqual({ how, said, line }, { how: "trap", said: message, line: 2 });
  }
});

test("sleeping takes no time, but moves the clock", async () => {
  const began = performance.now();
  const { out } = await run(`
    const auto before = std::chrono::steady_clock::now();
    std::this_thread::sleep_for(std::chrono::hours(1));
    std::printf("%d\\n", std::chrono::steady_clock::now() - before >= std::chrono::hours(1));`);
  assert.equal(out, "1\n");
  assert.ok(performance.now() - began < 600_000);
});

test("what one program leaves, no other finds", async () => {
  const body = `
    static int runs = 0;
    std::ifstream before("left");
    std::printf("%d %d\\n", ++runs, before.good());
    std::ofstream("left") << 1;`;
  assert.equal((await run(body)).out, "1 0\n");
  assert.equal((await run(body)).out, "1 0\n");
});

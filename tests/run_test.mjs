// What tests/run.mjs says while ctest runs, to the letter but for measured times, of a folder with a few
// tests that do nothing.
//
//   node --test tests/run_test.mjs

import assert from "node:assert/strict";
import { spawn, spawnSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, beforeEach, test } from "node:test";

const runner = join(import.meta.dirname, "run.mjs");
const folder = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
after(() => rmSync(folder, { recursive: true }));

// Each after the other, so that their order is known; `fresh` has never been timed.
beforeEach(() => {
  mkdirSync(join(folder, "Testing/Temporary"), { recursive: true });
  writeFileSync(
    join(folder, "Testing/Temporary/CTestCostData.txt"),
    "brief 2 80\nlong 1 600\n---\n",
  );
  writeFileSync(
    join(folder, "CTestTestfile.cmake"),
    `add_test(brief "true")
add_test(fresh "sleep" "0.7")
add_test(long "sleep" "1.5")
add_test(wrong "sh" "-c" "sleep 1.2; echo 50% tests passed; exit 1")
add_test(left_out "sh" "-c" "sleep 0.6; exit 77")
add_test(broken "echo" "one")
add_test(looks "sh" "-c" "cd $MJCOURSE_PROGRESS; echo 0 8 >looks; sleep 1.5; echo 5 8 240 >looks; sleep 1.5")
set_tests_properties(fresh PROPERTIES DEPENDS brief)
set_tests_properties(long PROPERTIES DEPENDS fresh)
set_tests_properties(wrong PROPERTIES DEPENDS long)
set_tests_properties(left_out PROPERTIES DEPENDS wrong SKIP_RETURN_CODE 77)
set_tests_properties(broken PROPERTIES DEPENDS left_out PASS_REGULAR_EXPRESSION "two")
`,
  );
});

const words = (...more) => [runner, "--test-dir", folder, "--parallel", "2", ...more];
const withoutTimes = (text) =>
  text.replaceAll(folder, "FOLDER").replace(/ +\d+\.\d\d sec/g, " T sec");

// What it says, as [exit code, stdout, stderr].
function run(...more) {
  const { status, stdout, stderr } = spawnSync(process.execPath, words(...more), {
    encoding: "utf8",
  });
  return [status, withoutTimes(stdout), stderr];
}

// Not in a chroot without /dev/pts.
const hasTerminals = spawnSync("script", ["-qec", "true", "/dev/null"]).status === 0;
const atTerminal = { skip: hasTerminals ? false : "there are no pseudo-terminals" };

// What it says on a terminal, with a word for what clears its last line.
function onTerminal(...more) {
  const command = [process.execPath, ...words(...more)].map((word) => `'${word}'`).join(" ");
  const { stdout } = spawnSync("script", ["-qec", command, "/dev/null"], { encoding: "utf8" });
  return withoutTimes(stdout).replaceAll("\r\x1b[K", "\nCLEARED:").replaceAll("\r\n", "\n");
}

test("in a log, each test that has ended says how long the rest took", () => {
  const [status, stdout, stderr] = run("-R", "brief|fresh|long");
  assert.equal(stderr, "");
  assert.equal(
    stdout,
    `0/3 tests; about 10 min left, and 1 test never timed
Internal ctest changing into directory: FOLDER
Test project FOLDER
    Start 1: brief
1/3 Test #1: brief ............................   Passed T sec; about 10 min left, and 1 test never timed
    Start 2: fresh
2/3 Test #2: fresh ............................   Passed T sec; about 10 min left
    Start 3: long
3/3 Test #3: long .............................   Passed T sec

The slowest tests:
 T sec  long
 T sec  fresh
 T sec  brief

Total Test time (real) = T sec

100% tests passed, 0 tests failed out of 3
`,
  );
  assert.equal(status, 0);
});

test("a test that looks at many files says how far it is", () => {
  const [status, stdout, stderr] = run("-R", "looks|brief");
  assert.equal(stderr, "");
  const lines = stdout.split("\n");
  assert.deepEqual(lines.filter((line) => /left/.test(line)).map(withoutTimes), [
    "0/2 tests; about 80 s left, and 1 test never timed",
    "1/2 Test #1: brief ............................   Passed T sec; 1 test left, never timed",
    "looks 0/8 files; 1 test left, never timed",
    "looks 5/8 files; about 4 min left",
  ]);
  assert.equal(status, 0);
});

test("on a terminal it says so, too", atTerminal, () => {
  assert.match(
    onTerminal("-R", "looks"),
    /CLEARED:0\/1 tests; about 4 min left; looks 5\/8 files\n/,
  );
});

test("what failed, what was skipped and ctest's exit code stay as they are", () => {
  const [status, stdout, stderr] = run("--output-on-failure", "-R", "wrong|left_out|broken");
  assert.equal(stderr, "Errors while running CTest\n");
  assert.equal(
    stdout,
    `0/3 tests; 3 tests left, never timed
Internal ctest changing into directory: FOLDER
Test project FOLDER
    Start 4: wrong
1/3 Test #4: wrong ............................***Failed T sec; 2 tests left, never timed
50% tests passed

    Start 5: left_out
2/3 Test #5: left_out .........................***Skipped T sec; 1 test left, never timed
    Start 6: broken
3/3 Test #6: broken ...........................***Failed  Required regular expression not found. Regex=[two
] T sec
one


The slowest tests:
 T sec  wrong
 T sec  left_out
 T sec  broken

Total Test time (real) = T sec

The following tests did not run:
\t  5 - left_out (Skipped)

The following tests FAILED:
\t  4 - wrong (Failed)
\t  6 - broken (Failed)

33% tests passed, 2 tests failed out of 3
`,
  );
  assert.equal(status, 8);
});

test("what only lists is ctest's alone", () => {
  const listed = `Internal ctest changing into directory: FOLDER
Test project FOLDER
  Test #1: brief
  Test #3: long

Total Tests: 2
`;
  assert.deepEqual(run("-N", "-R", "brief|long"), [0, listed, ""]);
});

test("on a terminal there is one line that changes", atTerminal, () => {
  assert.equal(
    onTerminal("-R", "brief|long"),
    `
CLEARED:0/2 tests; about 10 min left
CLEARED:Internal ctest changing into directory: FOLDER
0/2 tests; about 10 min left
CLEARED:Test project FOLDER
0/2 tests; about 10 min left
CLEARED:    Start 3: long
0/2 tests; about 10 min left
CLEARED:    Start 1: brief
0/2 tests; about 10 min left
CLEARED:1/2 Test #1: brief ............................   Passed T sec
1/2 tests; about 10 min left
CLEARED:2/2 Test #3: long .............................   Passed T sec

CLEARED:

CLEARED:The slowest tests:
 T sec  long
 T sec  brief

Total Test time (real) = T sec

CLEARED:
100% tests passed, 0 tests failed out of 2
`,
  );
});

test("lint says how many files it has to look at, and how long that will take", () => {
  const script = `import { lookAt } from ${JSON.stringify(join(import.meta.dirname, "lint/look.mjs"))};
    import { readFileSync } from "node:fs";
    const told = [];
    const look = (i) => () => {
      told.push(readFileSync("${folder}/looks", "utf8").split(" ").length);
      return i === 20 ? "wrong" : "";
    };
    const stamps = { name: "looks", pace: undefined, has: (stamp) => stamp === "good", put() {} };
    const task = (stamp, i) => ({ name: "x.cpp", stamp, look: look(i) });
    await lookAt(stamps, [task("good", 0), ...Array.from({ length: 40 }, (_, i) => task("new", i))]);
    console.log(told[0], told.at(-1), stamps.pace > 0);`;
  const { stdout } = spawnSync(process.execPath, ["--input-type=module", "--eval", script], {
    env: { ...process.env, MJCOURSE_PROGRESS: folder },
    encoding: "utf8",
  });
  assert.equal(stdout, "wrong41 checks, 40 done anew, complaints in 1\n2 3 true\n");
  assert.equal(readFileSync(join(folder, "looks"), "utf8"), "40 40 0\n");
});

test("only where all passed, a file says when, for the launcher", () => {
  const file = join(folder, "cache/passed");
  const runs = (...more) =>
    spawnSync(process.execPath, words(...more), { env: { ...process.env, MJCOURSE_PASSED: file } });
  assert.notEqual(runs("-R", "brief|broken").status, 0);
  assert.ok(!existsSync(file));
  assert.equal(runs("-R", "brief").status, 0);
  assert.match(readFileSync(file, "utf8"), /^on \d{4}-\d\d-\d\d at .*\n$/);
});

test("a signal ends both", async () => {
  const running = spawn(process.execPath, words("-R", "long"));
  running.stdout.once("data", () => running.kill("SIGINT"));
  const signal = await new Promise((resolved) => running.on("close", (_, by) => resolved(by)));
  assert.equal(signal, "SIGINT");
});

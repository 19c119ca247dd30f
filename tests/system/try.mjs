// A reader works on an exercise in a terminal: what `try` writes builds by itself and says what holds;
// it judges after each save, until all checks hold, and never touches what the reader wrote.
//
//   node --test tests/system/try.mjs     the generator is named by the environment: MJCOURSE

import assert from "node:assert/strict";
import { execFileSync, spawn, spawnSync } from "node:child_process";
import {
  existsSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { after, test } from "node:test";

const mjcourse = resolve(process.env.MJCOURSE ?? "build/release/generator/mjcourse");
const course = join(import.meta.dirname, "../courses/exercise/right");
const folder = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
after(() => rmSync(folder, { recursive: true }));
const program = join(folder, "fall/fall.cpp");
const solved = "  return 9.81 * t * t / 2;";

const words = (...more) => ["try", "--course", course, ...more];
const run = (...more) =>
  spawnSync(mjcourse, words(...more), {
    cwd: folder,
    encoding: "utf8",
    env: process.env,
  });
const write = (code) =>
  writeFileSync(
    program,
    readFileSync(program, "utf8").replace(
      /(#region answer\n)[^]*?(\n {2}\/\/ #endregion)/,
      (_, begin, end) => begin + code + end,
    ),
  );

const head = `fall, lesson 1.1: Falling
write what stands between \`// #region answer\` and \`// #endregion\` in
  ${program}

`;

test("it writes the starter, and says what fails", () => {
  const { status, stdout, stderr } = run("1.1", "--once");
  assert.equal(stderr, "");
  assert.equal(
    stdout,
    `${head}  [ ] it falls 4.9 m in the first second
      its speed is 9.8 m/s at the end only
      it is 0, and should be 4.905 ± 1e-09: off by 4.9
  [ ] twice the time is four times the way
      it was not reached
0 of 2 checks hold

`,
  );
  assert.equal(status, 1);
  const text = readFileSync(program, "utf8");
  assert.match(text, /return 0; {2}\/\/ t = 1 s: 4\.9 m/);
  assert.doesNotMatch(text, /#starter|#wrong|9\.81 \* t/);
});

test("what it writes builds by itself, and says at its end what holds", () => {
  const inside = { cwd: join(folder, "fall"), encoding: "utf8" };
  execFileSync("cmake", ["-S", ".", "-B", "build"], inside);
  execFileSync("cmake", ["--build", "build"], inside);
  const { stdout, stderr } = spawnSync("build/fall", inside);
  assert.equal(stdout, "");
  assert.equal(
    stderr,
    `[ ] it falls 4.9 m in the first second
    its speed is 9.8 m/s at the end only
    it is 0, and should be 4.905 ± 1e-09: off by 4.9
`,
  );
});

test("it shows the compiler's words at the reader's line", () => {
  write("  return undeclared;");
  const { status, stderr } = run("1.1", "--once");
  assert.equal(
    stderr,
    `${program}:7:10: error: use of undeclared identifier 'undeclared' [E-example-compile]
  7 |   return undeclared;
    |          ^~~~~~~~~~

`,
  );
  assert.equal(status, 1);
});

test("it keeps what is there, and knows what is solved", () => {
  write(solved);
  writeFileSync(program, `// mine\n${readFileSync(program, "utf8")}`);
  const { status, stdout } = run("1.1", "fall", "--once");
  assert.equal(
    stdout,
    `${head}note: what you changed outside of the region does not count here
  [x] it falls 4.9 m in the first second
  [x] twice the time is four times the way
2 of 2 checks hold: solved
`,
  );
  assert.equal(status, 0);
  assert.match(readFileSync(program, "utf8"), /^\/\/ mine\n/);
});

test("it judges after each save, and ends once all checks hold", async () => {
  const child = spawn(mjcourse, words("1.1", "--out", "other/place"), {
    cwd: folder,
  });
  let said = "";
  child.stdout.setEncoding("utf8").on("data", (text) => (said += text));
  const ended = new Promise((tell) => child.on("exit", tell));
  const says = async (text) => {
    while (!said.includes(text)) await new Promise((tell) => setTimeout(tell, 50));
    said = "";
  };
  const other = join(folder, "other/place/fall.cpp");
  const save = (code) =>
    writeFileSync(other, readFileSync(other, "utf8").replace(/ {2}return .*/, code));
  await says("the next save is judged again (Ctrl-C ends it)");
  save("  return 9.81 * t / 2;");
  await says("1 of 2 checks holds");
  writeFileSync(other, "int main() {}\n");
  await says("fall.cpp has no region `answer`");
  writeFileSync(other, readFileSync(program));
  await says("2 of 2 checks hold: solved");
  assert.equal(await ended, 0);
});

test("it writes nothing where a link leads", () => {
  const elsewhere = join(folder, "elsewhere");
  const here = join(folder, "here");
  for (const made of [elsewhere, here]) mkdirSync(made);
  const refused = (cwd, ...more) => {
    const came = spawnSync(mjcourse, words("1.1", ...more), {
      cwd,
      encoding: "utf8",
    });
    return `${came.status}: ${came.stderr}`;
  };
  const said = (link) =>
    `1: mjcourse: ${link} is a link, so nothing is written there\n` +
    "  cure: remove it, or name another folder: `--out DIR`\n";
  symlinkSync(elsewhere, join(here, "fall"));
  assert.equal(refused(here), said(join(here, "fall")));
  mkdirSync(join(here, "mine/real"), { recursive: true });
  symlinkSync("real", join(here, "mine/include"));
  assert.equal(refused(here, "--out", "mine"), said(join(here, "mine/include")));
  // Of the reader's files: one that leads elsewhere, one that leads nowhere, and a folder of theirs.
  const tried = [
    ["file", "fall.cpp", join(elsewhere, "fall.cpp")],
    ["folder", "include", elsewhere],
    ["note", "README.txt", join(elsewhere, "none")],
  ];
  for (const [out, link, target] of tried) {
    mkdirSync(join(here, out, link, ".."), { recursive: true });
    symlinkSync(target, join(here, out, link));
    const before = readdirSync(join(here, out), { recursive: true });
    assert.equal(refused(here, "--out", out, "--once"), said(join(here, out, link)));
    assert.deepEqual(readdirSync(join(here, out), { recursive: true }), before);
  }
  assert.deepEqual(readdirSync(elsewhere), []);
  assert.deepEqual(readdirSync(join(here, "mine/real")), []);
  // One that the reader has named.
  symlinkSync(elsewhere, join(here, "named"));
  assert.match(refused(here, "--out", "named", "--once"), /^1: $/);
  assert.ok(existsSync(join(elsewhere, "fall.cpp")));
});

test("it says which exercises there are", () => {
  const refused = (...more) => {
    const { status, stderr } = run(...more);
    return `${status}: ${stderr}`;
  };
  assert.equal(
    refused("1.1", "fal"),
    "2: mjcourse: lesson 1.1 has no exercise fal\n  cure: did you mean `fall`?\n",
  );
  assert.equal(
    refused("1.7"),
    "2: mjcourse: there is no lesson 1.7; did you mean `1.1`?\n  cure: as in `mjcourse try 1.1 l1_1_sensors`\n",
  );
  assert.equal(
    refused(),
    "2: mjcourse: try takes a lesson and the name of an exercise\n  cure: as in `mjcourse try 1.1 l1_1_sensors`\n",
  );
  assert.ok(!existsSync(join(folder, "fal")));
});

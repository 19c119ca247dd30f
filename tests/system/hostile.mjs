// Courses that mean harm (tests/courses/hostile/): each says what it should, and nothing of them
// survives: no process, and no file. As we are, and where we are root, as an ordinary user as well;
// and with Landlock as older kernels have it, down to none, where nothing is run.
//
//   node tests/system/hostile.mjs MJCOURSE
//
// MJCOURSE_WITHOUT is as for tests/courses/run.mjs.

import { spawnSync } from "node:child_process";
import {
  chmodSync,
  cpSync,
  existsSync,
  globSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  readlinkSync,
  rmSync,
  statSync,
  writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";

const mjcourse = resolve(process.argv[2]);
const courses = join(import.meta.dirname, "../courses", "hostile");
const ordinary = 54321; // a user who has nothing
const outside = "/var/tmp/mjcourse-was-here"; // what a program tries to write
const victim = "/var/tmp/mjcourse-victim"; // the folder that one has shaders lent into

const without = process.env.MJCOURSE_WITHOUT;

const failures = [];
const expect = (good, what) => good || failures.push(what);

// Processes whose program or working directory lies in `folder`.
function processesIn(folder) {
  return globSync("/proc/[0-9]*").filter((process) => {
    const places = ["exe", "cwd"].map((link) => {
      try {
        return readlinkSync(join(process, link));
      } catch {
        return ""; // it has ended, or is a zombie
      }
    });
    return places.some((place) => place.startsWith(folder));
  });
}

// `landlock` is the newest ABI that the generator may see; undefined for the kernel's own.
function run(name, user, home, landlock) {
  const who =
    (user === undefined ? "as we are" : "as an ordinary user") +
    (landlock === undefined ? "" : `, Landlock ${landlock}`);
  const temporary = mkdtempSync(join(home, "tmp-"));
  const cache = mkdtempSync(join(home, "cache-")); // empty, so that everything is run
  const course = join(temporary, "..", `${name}-${user ?? "own"}-${landlock ?? "own"}`);
  cpSync(join(courses, name), course, { recursive: true });
  const kept = join(cache, "mjcourse/mesa_shader_cache/9f");
  for (const folder of [kept, victim]) mkdirSync(folder, { recursive: true });
  chmodSync(victim, 0o700);
  writeFileSync(join(kept, "shader"), "");
  const owned = user ?? process.getuid();
  spawnSync("chown", ["-R", `${owned}:${owned}`, temporary, cache, victim]);
  // One program at a time: the kernel counts an ordinary user's processes together, so that beside
  // a fork bomb its neighbours cannot fork either.
  const check = ["check", "--jobs", "1", "--course", course];
  const { status, stdout, stderr } = spawnSync(mjcourse, check, {
    encoding: "utf8",
    cwd: "/",
    env: {
      PATH: process.env.PATH,
      TMPDIR: temporary,
      XDG_CACHE_HOME: cache,
      ...(landlock === undefined ? {} : { MJCOURSE_LANDLOCK: String(landlock) }),
    },
    ...(user === undefined ? {} : { uid: user, gid: user }),
  });
  const level = /^sandbox: (.*)$/m.exec(stdout)?.[1] ?? "";
  console.log(`${name}, ${who}: ${level === "" ? "no program was run" : level}`);
  const said = stdout.replace(/\d+\.\d s$/m, "N.N s").replace(/^sandbox[:,] .*\n/gm, "");
  const file = landlock === 0 ? "expected-without-landlock.txt" : "expected.txt";
  const expected = readFileSync(join(courses, name, file), "utf8");
  const weak = /^sandbox, weaker than on the newest kernels: (.*)$/m.exec(stdout)?.[1];
  const weaknesses = {
    1: "seccomp alone keeps programs from the network; seccomp alone keeps signals from others",
    5: "seccomp alone keeps signals from others",
  };
  if (landlock !== undefined) {
    expect(weak === weaknesses[landlock], `${name}, ${who}: its weakness is ${weak}`);
  }
  expect(`${stderr}${said}exit ${status}\n` === expected, `${name}, ${who}:\n${stderr}${stdout}`);
  expect(processesIn(temporary).length === 0, `${name}, ${who}: processes were left`);
  expect(readdirSync(temporary).length === 0, `${name}, ${who}: files were left`);
  expect(!existsSync(outside), `${name}, ${who}: ${outside} was written`);
  const mode = statSync(victim).mode & 0o777;
  expect(mode === 0o700, `${name}, ${who}: ${victim} has the mode ${mode.toString(8)}`);
  expect(readdirSync(victim).length === 0, `${name}, ${who}: something was written into ${victim}`);
  rmSync(victim, { recursive: true });
}

// Can somebody else run the generator? Not where the repository lies in a closed folder.
function isOpen(user) {
  return spawnSync(mjcourse, ["--version"], { uid: user, gid: user, cwd: "/" }).error === undefined;
}

const home = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
try {
  spawnSync("chmod", ["755", home]);
  for (const former of [outside, victim]) rmSync(former, { force: true, recursive: true });
  const names = readdirSync(courses).filter((name) => `hostile/${name}` !== without);
  for (const name of names) run(name, undefined, home);
  const run_by_it = ["programs", "commands"];
  for (const landlock of [0, 1, 5]) {
    for (const name of run_by_it) run(name, undefined, home, landlock);
  }
  if (process.getuid() !== 0) console.log("not as another user: we are an ordinary one");
  else if (!isOpen(ordinary)) console.log("not as an ordinary user: nobody else can read this");
  else {
    for (const name of names) run(name, ordinary, home);
    for (const name of run_by_it) run(name, ordinary, home, 5);
  }
} finally {
  rmSync(home, { recursive: true });
}
for (const failure of failures) console.error(failure);
console.log(`${failures.length} problems`);
process.exitCode = failures.length > 0 ? 1 : 0;

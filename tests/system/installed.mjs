// What is installed, and the Debian package, serve a course that lies anywhere: moved to another
// place and without this repository's environment, they begin a course, check it strictly and build
// its site; also a course that has no helper header of its own.
//
//   node tests/system/installed.mjs BUILD

import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { globSync, mkdirSync, mkdtempSync, readFileSync, renameSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { after, test } from "node:test";

const build = resolve(process.argv[2] ?? "build/release");
const folder = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
after(() => rmSync(folder, { recursive: true }));
const env = { PATH: process.env.PATH, HOME: join(folder, "home") };
mkdirSync(env.HOME);

// stdout of a command that is to succeed without a word on stderr.
function run(command, ...words) {
  const ran = spawnSync(command, words, { cwd: folder, env, encoding: "utf8" });
  assert.equal(ran.stderr, "", `${command} ${words.join(" ")}`);
  assert.equal(ran.status, 0, ran.stdout);
  return ran.stdout;
}

test("an installed tree works where it was moved to", () => {
  run("cmake", "--install", build, "--prefix", join(folder, "first"));
  renameSync(join(folder, "first"), join(folder, "second"));
  const mjcourse = join(folder, "second/bin/mjcourse");
  assert.match(run(mjcourse, "--version"), /^mjcourse \d/);
  run(mjcourse, "init", "course");
  rmSync(join(folder, "course/examples/include"), { recursive: true });
  const checked = run(mjcourse, "check", "--strict", "--course", "course");
  assert.match(checked, /^ok {4}1\.1 {2}A pendulum: 1 program run, /);
  assert.match(checked, /\n1 lesson: .*; 0 errors, /);
  run(mjcourse, "new", "lesson", "1-first-steps", "Two", "--course", "course");
  assert.match(
    run(mjcourse, "build", "--course", "course", "--out", "site"),
    /\nsite: site\/index\.html\n$/,
  );
  const page = readFileSync(join(folder, "site/1-first-steps/1.1-a-pendulum.html"), "utf8");
  assert.match(page, /qpos after 1 s:/);
  // With an engine in the build there is one in the site, and the lab is live.
  const engines = (where) => globSync("**/engine-*.wasm", { cwd: where }).length;
  assert.equal(engines(join(folder, "site")), engines(join(build, "assets")));
});

test("nothing that is installed names the tree that it was built in", () => {
  const source = readFileSync(join(build, "CMakeCache.txt"), "utf8").match(
    /^mjcourse_SOURCE_DIR:STATIC=(.*)$/m,
  )[1];
  const tree = join(folder, "second");
  const found = spawnSync("grep", ["-rlF", source, tree], { encoding: "utf8" });
  assert.equal(found.stdout, "");
});

test("the Debian package has the same, and says what it needs", () => {
  execFileSync("cpack", ["-G", "DEB", "-B", join(folder, "package")], { cwd: build, env });
  const [deb] = globSync(join(folder, "package/mjcourse_*.deb"));
  const field = (name) => run("dpkg-deb", "--field", deb, name).trim();
  const needs = field("Depends").split(/, /);
  for (const wanted of [/^libmujoco2\.2\.2/, /^libjavascriptcoregtk/, /^libosmesa6/]) {
    assert.ok(
      needs.some((name) => wanted.test(name)),
      needs.join(),
    );
  }
  for (const wanted of [
    "clang-16 | clang-19 | clang-14 | clang | g++",
    "libmujoco-dev",
    "ffmpeg",
  ]) {
    assert.ok(needs.includes(wanted), needs.join());
  }
  run("dpkg-deb", "--extract", deb, "extracted");
  const files = (tree) => globSync("**/{*,.*}", { cwd: join(folder, tree) }).sort();
  assert.deepEqual(files("extracted/usr"), files("second"));
  const mjcourse = join(folder, "extracted/usr/bin/mjcourse");
  assert.match(run(mjcourse, "check", "--course", "course"), /; 0 errors, /);
});

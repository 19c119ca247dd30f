// The Containerfile makes an image, with which a course is begun, checked and built where there is no
// network, by users who are not root: its own, and one whom it does not know.
//
//   node tests/system/container.mjs BUILD
//
// No registry of images is asked: what the Containerfile begins from is made here of the release's
// packages, as small as Debian's own slim image. buildah's chroot isolation wants no more than a root
// who may mount. The image's name of a user and its entry point are read from it, as podman reads them.

import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { after, test } from "node:test";
import {
  copySettings,
  makePackage,
  mayMakeRoot,
  release,
  run,
  sources,
} from "./debian_package.mjs";

const build = process.argv[2];
const folder = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
const store = ["--root", join(folder, "images"), "--runroot", join(folder, "run")];
store.push("--storage-driver", "vfs");
const course = join(folder, "course");
after(() => rmSync(folder, { recursive: true }));

function whyNot() {
  for (const tool of ["buildah", "mmdebstrap"]) {
    if (spawnSync(tool, ["--version"]).error) return `${tool} is not installed`;
  }
  if (spawnSync("unshare", ["--net", "true"]).status !== 0) return "the network cannot be left";
  return mayMakeRoot(folder) ? undefined : "this user may not mount";
}

// What it answers; its warnings are for nobody.
function buildah(...words) {
  return execFileSync("buildah", [...store, ...words], { encoding: "utf8", stdio: "pipe" }).trim();
}

// A container whose files are Debian's smallest: without what is only there to be read.
function makeBase(name) {
  const left = ["doc", "info", "locale", "man"].map((part) => `path-exclude=/usr/share/${part}/*`);
  left.push("path-include=/usr/share/doc/*/copyright");
  const container = buildah("from", "scratch");
  const root = buildah("mount", container);
  run(
    "mmdebstrap",
    ...["--mode=root", "--variant=minbase", "--format=directory"],
    "--setup-hook=copy-in /etc/apt/apt.conf.d /etc/apt",
    ...left.map((option) => `--dpkgopt=${option}`),
    ...[release(), root],
    ...sources().map(({ mirror, suite }) => `deb ${mirror} ${suite} main`),
  );
  copySettings(root);
  buildah("commit", "--quiet", "--rm", container, name);
}

const reason = whyNot();
const skip = reason && `no image can be made here: ${reason}`;

test("the image serves a course without a network and without root", { skip }, (context) => {
  const deb = makePackage(build, join(folder, "package"));
  makeBase("localhost/base");
  const containerfile = new URL("../../Containerfile", import.meta.url).pathname;
  buildah(
    ...["build", "--quiet", "--isolation", "chroot", "--pull-never", "--from", "localhost/base"],
    ...["--file", containerfile, "--tag", "localhost/mjcourse", dirname(deb)],
  );
  const { OCIv1: image } = JSON.parse(buildah("inspect", "--type", "image", "localhost/mjcourse"));
  const { Entrypoint, User, WorkingDir, Labels } = image.config;
  assert.deepEqual(Entrypoint, ["mjcourse"]);
  assert.equal(WorkingDir, "/course");
  assert.equal(Labels["org.opencontainers.image.licenses"], "Apache-2.0");

  const files = buildah("mount", buildah("from", "--pull-never", "localhost/mjcourse"));
  const [, uid] = new RegExp(`^${User}:x:(\\d+):`, "m").exec(
    readFileSync(join(files, "etc/passwd"), "utf8"),
  );
  assert.notEqual(uid, "0");
  assert.deepEqual(readdirSync(join(files, "var/lib/apt/lists")), []);

  // As `podman run --rm --network none --user USER -v COURSE:/course mjcourse WORDS` does it.
  mkdirSync(course);
  const mjcourse = (user, ...words) => {
    run("chown", "-R", `${user}:${user}`, course);
    const container = buildah("from", "--pull-never", "localhost/mjcourse");
    const said = run(
      ...["unshare", "--net", "buildah", ...store, "run", "--isolation", "chroot"],
      ...["--user", `${user}:${user}`, "--volume", `${course}:/course`, container, "--"],
      ...[...Entrypoint, ...words],
    );
    buildah("rm", container);
    return said;
  };
  assert.match(mjcourse(uid, "doctor"), /\nall that courses need is here\n/);
  mjcourse(uid, "init", ".");
  assert.match(mjcourse(uid, "check", "--strict"), /; 0 errors, /);
  assert.match(mjcourse("4321", "build", "--out", "site"), /\nsite: site\/index\.html\n/);
  const page = readFileSync(join(course, "site/1-first-steps/1.1-a-pendulum.html"), "utf8");
  assert.match(page, /qpos after 1 s:/);

  const [kilobytes] = run("du", "-sk", files).split("\t");
  context.diagnostic(`the image has ${Math.round(kilobytes / 1024)} MB`);
});

// The Debian package on a machine that has nothing else: it is installed in a bare Debian root, with
// what it says it needs and no more, and begins, checks and builds a course there.
//
//   node tests/system/bare_root.mjs BUILD
//
// Packages come from where this machine has its own. Only a user who may mount and make devices can
// make such a root; for others there is no such test.

import assert from "node:assert/strict";
import { cpSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
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
const root = join(folder, "root");
after(() => rmSync(folder, { recursive: true }));

// What a shell's command inside the root says; what is mounted for it goes with it.
function inside(command) {
  const mounted = `
    mount --bind /proc "$1/proc" && mount --bind /dev "$1/dev" &&
    exec chroot "$1" env -i HOME=/root LANG=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin sh -c "$2"`;
  return run("unshare", "--mount", "sh", "-c", mounted, "sh", root, `cd /root && ${command}`);
}

test("the Debian package brings all that a course needs", { skip: !mayMakeRoot(folder) }, () => {
  const deb = makePackage(build, join(folder, "package"));
  run("debootstrap", "--variant=minbase", release(), root, sources()[0].mirror);
  copySettings(root);
  cpSync(deb, join(root, "root/mjcourse.deb"));
  inside("apt-get -q update");
  inside("apt-get -qy -o Acquire::Retries=3 install --no-install-recommends ./mjcourse.deb");

  assert.match(inside("mjcourse doctor"), /\nall that courses need is here\n$/);
  inside("mjcourse init course");
  assert.match(inside("mjcourse check --strict --course course"), /; 0 errors, /);
  assert.match(inside("mjcourse build --course course --out site"), /\nsite: site\/index\.html\n$/);
  const page = readFileSync(join(root, "root/site/1-first-steps/1.1-a-pendulum.html"), "utf8");
  assert.match(page, /qpos after 1 s:/);
});

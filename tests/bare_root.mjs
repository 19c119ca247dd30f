// The Debian package on a machine that has nothing else: it is installed in a bare Debian root, with
// what it says it needs and no more, and begins, checks and builds a course there.
//
//   node tests/bare_root.mjs BUILD
//
// Packages come from where this machine has its own. Only who may mount and make devices can make such
// a root; for others there is no such test.

import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import {
  cpSync,
  existsSync,
  globSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  rmSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";

const build = process.argv[2];
const folder = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
const root = join(folder, "root");
after(() => rmSync(folder, { recursive: true }));

function mayMakeRoot() {
  const place = join(folder, "trial");
  mkdirSync(join(place, "proc"), { recursive: true });
  const trial = 'cd "$1" && mknod null c 1 3 && : >null && mount --bind /proc proc';
  return spawnSync("unshare", ["--mount", "sh", "-c", trial, "sh", place]).status === 0;
}

// stdout and stderr of a command that is to succeed.
function run(command, ...words) {
  const ran = spawnSync(command, words, { encoding: "utf8" });
  const said = ran.stdout + ran.stderr;
  assert.equal(ran.status, 0, `${command} ${words.join(" ")}: ${said}`);
  return said;
}

// The same, of a shell's command inside the root; what is mounted for it goes with it.
function inside(command) {
  const mounted = `
    mount --bind /proc "$1/proc" && mount --bind /dev "$1/dev" &&
    exec chroot "$1" env -i HOME=/root LANG=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin sh -c "$2"`;
  return run("unshare", "--mount", "sh", "-c", mounted, "sh", root, `cd /root && ${command}`);
}

// Where this machine has its release from.
function mirrorOf(release) {
  const form = "--format=$(REPO_URI) $(CODENAME)";
  const targets = execFileSync("apt-get", ["indextargets", form, "Identifier: Packages"], {
    encoding: "utf8",
  });
  const [, mirror] = new RegExp(`^(\\S+) ${release}$`, "m").exec(targets);
  return mirror;
}

function makeRoot() {
  const [, release] = /^VERSION_CODENAME=(.*)$/m.exec(readFileSync("/etc/os-release", "utf8"));
  run("debootstrap", "--variant=minbase", release, root, mirrorOf(release));
  const settings = ["sources.list", "sources.list.d", "apt.conf.d", "trusted.gpg.d", "keyrings"];
  const files = settings.map((name) => `/etc/apt/${name}`);
  files.push("/usr/share/keyrings", "/etc/ssl/certs/ca-certificates.crt", "/etc/resolv.conf");
  files.push("/etc/hosts");
  for (const file of files.filter((name) => existsSync(name))) {
    cpSync(file, join(root, file), { recursive: true, dereference: true });
  }
}

test("the Debian package brings all that a course needs", { skip: !mayMakeRoot() }, () => {
  execFileSync("cpack", ["-G", "DEB", "-B", join(folder, "package")], { cwd: build });
  const [deb] = globSync(join(folder, "package/mjcourse_*.deb"));
  makeRoot();
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

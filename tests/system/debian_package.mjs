// What tests of the Debian package share: they make it, and a root that has nothing else, with which
// packages come from where this machine has its own.
//
//   import { makePackage, sources, copySettings } from "./debian_package.mjs";

import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { cpSync, existsSync, globSync, mkdirSync, readFileSync } from "node:fs";
import { join } from "node:path";

// stdout and stderr of a command that is to succeed.
export function run(command, ...words) {
  const ran = spawnSync(command, words, { encoding: "utf8", maxBuffer: 1 << 28 });
  assert.ifError(ran.error);
  const said = ran.stdout + ran.stderr;
  assert.equal(ran.status, 0, `${command} ${words.join(" ")}: ${said}`);
  return said;
}

// Only a user who may mount and make devices can make a root.
export function mayMakeRoot(folder) {
  const place = join(folder, "trial");
  mkdirSync(join(place, "proc"), { recursive: true });
  const trial = 'cd "$1" && mknod null c 1 3 && : >null && mount --bind /proc proc';
  return spawnSync("unshare", ["--mount", "sh", "-c", trial, "sh", place]).status === 0;
}

// The package of what BUILD has built, in a folder of its own.
export function makePackage(build, folder) {
  execFileSync("cpack", ["-G", "DEB", "-B", folder], { cwd: build });
  const [deb] = globSync(join(folder, "mjcourse_*.deb"));
  return deb;
}

export function release() {
  const [, name] = /^VERSION_CODENAME=(.*)$/m.exec(readFileSync("/etc/os-release", "utf8"));
  return name;
}

// Where this machine has its release and its updates from: the release itself comes first.
export function sources() {
  const form = "--format=$(ORIGIN) $(REPO_URI) $(CODENAME)";
  const targets = execFileSync("apt-get", ["indextargets", form, "Identifier: Packages"], {
    encoding: "utf8",
  });
  const found = targets.matchAll(new RegExp(`^Debian (\\S+) (${release()}\\S*)$`, "gm"));
  return [...found]
    .map(([, mirror, suite]) => ({ mirror, suite }))
    .sort((one, other) => one.suite.length - other.suite.length);
}

// How this machine reaches them.
export function copySettings(root) {
  const settings = ["sources.list", "sources.list.d", "apt.conf.d", "trusted.gpg.d", "keyrings"];
  const files = settings.map((name) => `/etc/apt/${name}`);
  files.push("/usr/share/keyrings", "/etc/ssl/certs/ca-certificates.crt", "/etc/resolv.conf");
  files.push("/etc/hosts");
  for (const file of files.filter((name) => existsSync(name))) {
    cpSync(file, join(root, file), { recursive: true, dereference: true });
  }
}

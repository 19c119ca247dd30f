// Places that cannot be written, and a disk that is full: what is said of them, before or behind the
// work, and that nothing comes to lie there by halves.
//
//   node tests/system/unwritable.mjs MJCOURSE

import { spawnSync } from "node:child_process";
import {
  chmodSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  rmSync,
  writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";

const mjcourse = resolve(process.argv[2]);
const isRoot = process.getuid() === 0;
const home = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
chmodSync(home, 0o755);
const course = join(home, "course");
const failures = [];

function write(path, text) {
  mkdirSync(dirname(join(home, path)), { recursive: true });
  writeFileSync(join(home, path), text);
}
write(
  "course/content/course.yaml",
  "title: T\nlevels:\n  - {folder: 1-a, title: A, lessons: [1.1-b]}\n",
);
write("course/content/1-a/1.1-b.md", "---\ntitle: B\n---\n\nText.\n");
write("file", "");
for (const folder of ["locked", "mine"]) mkdirSync(join(home, folder));
chmodSync(join(home, "locked"), 0o555);
const [file, locked, mine] = ["file", "locked", "mine"].map((name) => join(home, name));

// The mode of a folder stops root, too, without these capabilities. Another user could not read a checkout
// in a closed folder.
const heedsModes = ["setpriv", "--bounding-set=-dac_override,-dac_read_search"];

function run(words) {
  const command = [...(isRoot ? heedsModes : []), mjcourse, ...words, "--course", course];
  return spawnSync(command[0], command.slice(1), {
    encoding: "utf8",
    cwd: "/",
    env: { PATH: process.env.PATH, TMPDIR: mine, XDG_CACHE_HOME: mine },
  });
}

function expectRefused(words, said, status = 2) {
  const came = run(words);
  if (came.status === status && came.stderr === said && came.stdout === "") return;
  failures.push(
    `${words.join(" ")}: exit ${came.status}, and it said\n${came.stderr}${came.stdout}`,
  );
}

const options = [
  ["build", "--out", "DIR"],
  ["check", "--report", "DIR"],
  ["check", "--trace", "FILE"],
  ["check", "--store", "DIR"],
];
for (const [command, option, value] of options) {
  const place = join(locked, "a", "b");
  expectRefused(
    [command, option, place],
    `mjcourse: ${place} cannot be written: ${locked}: Permission denied\n` +
      `  cure: allow this user to write there, or name another place: \`${option} ${value}\`\n`,
  );
  const below = join(file, "a");
  expectRefused(
    [command, option, below],
    `mjcourse: ${below} cannot be written: ${file}: Not a directory\n` +
      `  cure: name another place: \`${option} ${value}\`\n`,
  );
  const what = value === "DIR" ? "a folder" : "a file";
  for (const words of [[option, ""], [`${option}=`]]) {
    expectRefused(
      [command, ...words],
      `mjcourse: ${option} needs ${what}, not ""\n\`mjcourse ${command} --help\` shows what it takes\n`,
    );
  }
}

// What lies in a site and cannot go along with the next one is told before the work.
{
  const site = join(mine, "site");
  const words = ["build", "--out", site];
  const built = run(words);
  if (built.status !== 0) failures.push(`no site was built: ${built.stderr}`);
  const refused = (folder) =>
    expectRefused(
      words,
      `mjcourse: ${folder} is in the way of a new site, and cannot be moved: Permission denied\n` +
        "  cure: allow this user to write to it, or name an empty or a new folder\n",
    );
  const closed = join(site, "closed");
  mkdirSync(closed);
  chmodSync(closed, 0);
  refused(closed);
  chmodSync(closed, 0o755);
  writeFileSync(join(site, "1-a", "notes.txt"), "");
  chmodSync(join(site, "1-a"), 0o555);
  refused(join(site, "1-a"));
  chmodSync(join(site, "1-a"), 0o755);
  const again = run(words);
  if (again.status !== 0) failures.push(`no site was built again: ${again.stderr}`);
}

// On a disk that is full. Only root can have one of his own.
function onFullDisk(words, expected) {
  const disk = join(home, "disk");
  mkdirSync(disk, { recursive: true });
  const script = 'mount -t tmpfs -o size=64k none "$0" && "$@"; code=$?; ls -A "$0"; exit $code';
  const came = spawnSync("unshare", ["--mount", "sh", "-c", script, disk, mjcourse, ...words], {
    encoding: "utf8",
    env: { PATH: process.env.PATH, TMPDIR: mine, XDG_CACHE_HOME: mine },
  });
  const left = came.stdout.split("\n").slice(-1 - expected.left.length, -1);
  const good =
    came.status === expected.status &&
    expected.said.test(came.stderr) &&
    left.join() === expected.left.join();
  if (!good) failures.push(`${words.join(" ")}: exit ${came.status}\n${came.stderr}${came.stdout}`);
}
if (isRoot && spawnSync("unshare", ["--mount", "true"]).status === 0) {
  const disk = join(home, "disk");
  const said = new RegExp(
    `^mjcourse: ${disk}/\\S+: No space left on device\\n` +
      "  cure: make room on that disk; what was there before is as it was\\n$",
    "u",
  );
  const full = { status: 3, said, left: [".site.lock"] };
  onFullDisk(["build", "--course", course, "--out", join(disk, "site")], full);
  onFullDisk(["check", "--course", course, "--report", join(disk, "site")], full);
}

if (existsSync(join(course, "build"))) failures.push("a site was written beside the named place");
if (readdirSync(locked).length > 0) failures.push("something was written in a locked folder");
rmSync(home, { recursive: true });
console.log(failures.join("\n\n") || "each place that cannot be written is told with its cure");
process.exit(failures.length === 0 ? 0 : 1);

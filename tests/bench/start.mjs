// How soon mjcourse is there, where there is nothing to do: `--version`, and `check` of courses of
// which nothing has changed, the one of this checkout and a thousand lessons of prose.
//
//   node tests/bench/start.mjs MJCOURSE [LESSONS]
//
// Beside them stand a program that does nothing, and `git status` of the checkout. GNU time counts
// hundredths of a second, so a shell runs each many times. The last line is JSON. The course of this
// checkout is worked out first where the user's store does not have it, which takes minutes.

import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";

import { has, measure } from "./measure.mjs";
import { writeCourse } from "./prose-course.mjs";

const mjcourse = resolve(process.argv[2]);
const lessons = Number(process.argv[3] ?? 1000);
const runs = 20;

if (!has("time")) {
  console.log("start: skipped; it measures with GNU time: apt-get install time");
  process.exit(0);
}
const home = mkdtempSync(join(tmpdir(), "mjcourse-bench-"));
process.on("exit", () => rmSync(home, { recursive: true }));
writeCourse(join(home, "course"), lessons);

const commands = {
  "a program that does nothing": ["true"],
  "mjcourse --version": [mjcourse, "--version"],
  "git status": ["git", "status", "--porcelain"],
  "mjcourse check": [mjcourse, "check", "--store-url", "none"],
  [`mjcourse check, ${lessons} lessons`]: [
    ...[mjcourse, "check", "--course", join(home, "course"), "--store", join(home, "store")],
    ...["--store-url", "none"],
  ],
};

const repeat = 'for i in $(seq "$0"); do "$@" >/dev/null 2>&1; done';
const found = {};
for (const [name, command] of Object.entries(commands)) {
  execFileSync(command[0], command.slice(1), { stdio: "ignore" });
  const { wall, cpu, memory } = measure("sh", ["-c", repeat, runs, ...command], {
    stdio: "ignore",
  });
  found[name] = { wall: (wall / runs) * 1000, cpu: (cpu / runs) * 1000, memory };
  const columns = [
    `${found[name].wall.toFixed(1)} ms wall`,
    `${found[name].cpu.toFixed(1)} ms CPU`,
  ];
  console.log(name.padEnd(32), ...columns.map((column) => column.padStart(14)), `  ${memory} MB`);
}
console.log(JSON.stringify({ name: "start", lessons, found }));

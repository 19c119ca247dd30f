// Runs a fuzzer over its seeds, and from there on for some seconds.
//
//   node tests/fuzz/run.mjs NAME PROGRAM [SECONDS]
//
// Without SECONDS it only reads the seeds: what the course and the tests' tiny courses have (see
// seeds.mjs), seeds/NAME and found/NAME. What a fuzzer finds lies beside PROGRAM, and so does what
// it learnt, from which it goes on the next time.

import { spawnSync } from "node:child_process";
import { existsSync, mkdirSync, rmSync } from "node:fs";
import { join, resolve } from "node:path";

import { writeSeeds } from "./seeds.mjs";

const [name, program, seconds] = process.argv.slice(2);
const here = import.meta.dirname;

const seeds = `${resolve(program)}.seeds`;
rmSync(seeds, { recursive: true, force: true });
mkdirSync(seeds);
const count = writeSeeds(name, seeds);
const folders = [seeds];
for (const kept of ["seeds", "found"]) {
  const folder = join(here, kept, name);
  if (existsSync(folder)) folders.push(folder);
}
if (count === 0 && folders.at(-1) === seeds) throw new Error(`no seeds for ${name}`);

const flags = [];
if (seconds) {
  const corpus = `${resolve(program)}.corpus`;
  mkdirSync(corpus, { recursive: true });
  folders.unshift(corpus);
  flags.push(`-max_total_time=${seconds}`, "-timeout=10", "-rss_limit_mb=2048", "-max_len=20000");
  flags.push(`-artifact_prefix=${resolve(program)}.`, `-dict=${join(here, "lesson.dict")}`);
  flags.push("-print_final_stats=1");
  // What a script engine has yet to collect looks like a leak after each input, which takes a second.
  if (name === "script_error") flags.push("-detect_leaks=0");
}
const leaks = `suppressions=${resolve(here, "../leaks.txt")}:print_suppressions=0`; // of libraries
const run = spawnSync(program, [...flags, ...folders], {
  stdio: "inherit",
  env: { ...process.env, LSAN_OPTIONS: leaks },
});
console.log(`${count} seeds`);
process.exitCode = run.status ?? 1;

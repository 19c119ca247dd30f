// A small course in a folder of its own, and checks of it that tell which tasks were worked out
// anew and which were kept.

import { spawnSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";

export const home = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
export const course = join(home, "course");
export const store = join(home, "store");

export function write(path, text) {
  mkdirSync(dirname(join(course, path)), { recursive: true });
  writeFileSync(join(course, path), text);
}

export function read(path) {
  return readFileSync(join(course, path), "utf8");
}

// Puts `after` where the file has `before`.
export function change(path, before, after) {
  const text = read(path);
  if (!text.includes(before)) throw new Error(`${path} does not hold ${before}`);
  write(path, text.replace(before, after));
}

export function run(mjcourse, words, environment = {}) {
  const { stdout, stderr, status } = spawnSync(mjcourse, words, {
    encoding: "utf8",
    env: { ...process.env, ...environment },
  });
  return { stdout, stderr, status };
}

// Checks the course, or does what `command` says with the course in `folder`; gives the names of the
// tasks that were worked out, sorted.
export function worked(mjcourse, environment = {}, folder = course, command = ["check"]) {
  const trace = join(home, "trace.json");
  const words = [...command, "--course", folder, "--store", store, "--trace", trace];
  const { stderr, status } = run(mjcourse, words, environment);
  if (status !== 0) throw new Error(`${command[0]} fails:\n${stderr}`);
  const { traceEvents } = JSON.parse(readFileSync(trace, "utf8"));
  const anew = traceEvents.filter((event) => event.cat === "worked").map((event) => event.name);
  return { anew: anew.sort(), notes: stderr };
}

export function cleanUp() {
  rmSync(home, { recursive: true, force: true });
}

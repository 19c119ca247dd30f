// What is too much to be read is refused, soon and in little memory: each course below once took
// gigabytes or minutes. The limits of memory and of CPU time are several times what is needed.
//
//   node tests/system/bounds.mjs MJCOURSE

import { spawn } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";

const mjcourse = resolve(process.argv[2]);
const kilobytes = 700_000; // of memory
const seconds = 30; // of CPU time

const failures = [];
const home = mkdtempSync(join(tmpdir(), "mjcourse-test-"));

const listed = "title: C\nlevels:\n  - {folder: 0-a, title: A, lessons: [0.1-x]}\n";
const lesson = (body) => ({ "content/0-a/0.1-x.md": `---\ntitle: T\n---\n${body}` });
const numbers = (count) => Array.from({ length: count }, (_, i) => i);

// Nine lists, each of nine times the one before: 9¹² words.
const laughs = numbers(12).map((i) =>
  i === 0
    ? "a0: &a0 [x, x, x, x, x, x, x, x, x]\n"
    : `a${i}: &a${i} [${`*a${i - 1}, `.repeat(9)}]\n`,
);

// The files of a course, and the ids of what must be said of it.
const courses = {
  "a lesson of 200 MB": [lesson("a b\n\n".repeat(40_000_000)), ["E-text-size"]],
  "a line of 50 MB": [lesson("a".repeat(50_000_000)), ["E-text-size"]],
  "a glossary of 10 MB": [
    { ...lesson(""), "content/glossary.md": `---\ntitle: G\n---\n${"## a\n\nb\n\n".repeat(1e6)}` },
    ["E-text-size"],
  ],
  "terms without an end": [lesson("[[a|".repeat(100_000)), ["E-mistakes", "E-term-unclosed"]],
  terms: [lesson("[[a|b]] ".repeat(100_000)), ["E-lesson-size", "E-mistakes", "E-term-unknown"]],
  formulas: [lesson("$x$ ".repeat(200_000)), ["E-lesson-size"]],
  "cells that nobody wrote": [
    lesson(`${"|a".repeat(10_000)}|\n${"|-".repeat(10_000)}|\n${"|b|\n".repeat(10_000)}`),
    ["E-table-size"],
  ],
  "a reference in many links": [
    lesson(`[a]: /b "${"c".repeat(500_000)}"\n\n${"[a]\n".repeat(100_000)}`),
    ["E-reference-size"],
  ],
  "a million laughs": [
    { ...lesson(""), "content/course.yaml": `${laughs.join("")}title: C\nlevels: *a11\n` },
    ["E-course-yaml"],
  ],
  "laughs in front": [
    { "content/0-a/0.1-x.md": `---\ntitle: T\n${laughs.join("")}prerequisites: *a11\n---\n` },
    ["E-front-matter"],
  ],
  "models in a thousand folders": [
    {
      ...lesson(""),
      ...Object.fromEntries(
        numbers(1000).map((i) => [`models/${"d/".repeat(i)}m.xml`, "<mujoco/>"]),
      ),
    },
    ["E-file-refused"],
  ],
  "100000 lessons": [
    {
      ...lesson(""),
      "content/course.yaml": listed.replace(
        "0.1-x",
        numbers(100_000)
          .map((i) => `0.${i}`)
          .join(),
      ),
    },
    ["E-course-size", "E-lesson-missing", "E-mistakes"],
  ],
};

// The most memory that the process took so far; 0 once it is gone.
function peak(pid) {
  try {
    return Number(/^VmHWM:\s+(\d+)/m.exec(readFileSync(`/proc/${pid}/status`, "utf8"))?.[1] ?? 0);
  } catch {
    return 0;
  }
}

// Under a limit of CPU time; how it ended, what it said, and its memory.
function check(course) {
  const limited = `ulimit -t ${seconds}; exec "$0" "$@"`;
  const words = [mjcourse, "check", "--store", join(home, "store"), "--course", course];
  return new Promise((resolved) => {
    const process = spawn("bash", ["-c", limited, ...words], {
      stdio: ["ignore", "ignore", "pipe"],
    });
    let memory = 0;
    let said = "";
    const watch = setInterval(() => {
      memory = Math.max(memory, peak(process.pid));
      if (memory > kilobytes) process.kill("SIGKILL");
    }, 10);
    process.stderr.on("data", (text) => (said += text));
    process.on("close", (code, signal) => {
      clearInterval(watch);
      resolved({ end: signal ?? code, said, memory });
    });
  });
}

for (const [name, [files, expected]] of Object.entries(courses)) {
  const course = join(home, name.replaceAll(" ", "-"));
  for (const [path, text] of Object.entries({ "content/course.yaml": listed, ...files })) {
    mkdirSync(dirname(join(course, path)), { recursive: true });
    writeFileSync(join(course, path), text);
  }
  const { end, said, memory } = await check(course);
  const ids = [...new Set([...said.matchAll(/ \[([EW]-[\w-]+)\]$/gm)].map(([, id]) => id))];
  if (end !== 1 || memory > kilobytes || ids.sort().join() !== expected.join()) {
    failures.push(`${name}: ${end}, ${memory} kB, ${ids.join()}\n${said.slice(0, 1000)}`);
  }
  rmSync(course, { recursive: true });
}
rmSync(home, { recursive: true });
for (const failure of failures) console.error(failure);
console.log(`${failures.length} problems`);
process.exitCode = failures.length > 0 ? 1 : 0;

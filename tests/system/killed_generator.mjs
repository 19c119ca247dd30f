// A generator takes the programs and the commands of the course along however it ends, and all that
// these have started; and the next one removes what they left in the folder for temporary files.
//
//   node tests/system/killed_generator.mjs MJCOURSE

import { spawn, spawnSync } from "node:child_process";
import {
  globSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  readlinkSync,
  rmSync,
  writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { setTimeout as sleep } from "node:timers/promises";

const mjcourse = process.argv[2];
const home = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
const temporary = join(home, "tmp");
const env = { ...process.env, TMPDIR: temporary };

function writeLesson(course, fence, examples) {
  const files = {
    "content/course.yaml": "title: T\nlevels:\n  - {folder: 1-a, title: A, lessons: [1.1-b]}\n",
    "content/1-a/1.1-b.md": `---\ntitle: B\n---\n\n${fence}`,
    ...examples,
  };
  for (const [path, text] of Object.entries(files)) {
    mkdirSync(dirname(join(home, course, path)), { recursive: true });
    writeFileSync(join(home, course, path), text);
  }
  return ["check", "--course", join(home, course)];
}

function writeCourse(course, program) {
  const fence = `\`\`\`cpp file=examples/x.cpp timeout=60\n${program}\`\`\`\n`;
  return writeLesson(course, fence, { "examples/x.cpp": program });
}

// Processes of a lesson's commands, which work in this test's folder.
function processesOfCommands() {
  return globSync("/proc/[0-9]*/cwd").filter((link) => {
    try {
      return readlinkSync(link).startsWith(temporary);
    } catch {
      return false; // it has just ended
    }
  });
}

// Whether a program that was compiled in this test's folder is running.
function programRuns() {
  return globSync("/proc/[0-9]*/cmdline").some((file) => {
    try {
      return readFileSync(file, "utf8").startsWith(temporary);
    } catch {
      return false; // it has just ended
    }
  });
}

// Waits until `holds`; false when it does not within ten seconds.
async function eventually(holds) {
  for (let tries = 0; tries < 200 && !holds(); ++tries) await sleep(50);
  return holds();
}

const failures = [];

// The kernel ends a child whose parent has ended, and no grandchild. (What traces its commands to a
// pipe ends when nobody reads that.)
async function endsWithItsCommands(signal) {
  const deaf = `(trap '' TERM HUP INT; while :; do sleep 1; done) & # ${home} ${signal}\n`;
  const fence = `\`\`\`sh run timeout=60\nexec >/dev/null 2>&1\n${deaf.repeat(3)}wait\n\`\`\`\n`;
  const generator = spawn(mjcourse, writeLesson(`commands-${signal}`, fence, {}), {
    env,
    stdio: ["ignore", "pipe", "ignore"],
  });
  const closed = new Promise((resolve) => generator.stdout.on("close", () => resolve(true)));
  generator.stdout.resume();
  // The shell, three that it starts, and what each of these does.
  if (!(await eventually(() => processesOfCommands().length >= 7))) {
    failures.push(`${signal}: the commands never ran`);
  }
  generator.kill(signal);
  if (!(await eventually(() => processesOfCommands().length === 0))) {
    failures.push(`${signal}: ${processesOfCommands().length} processes run on`);
    for (const left of processesOfCommands()) process.kill(Number(left.split("/")[2]), "SIGKILL");
  }
  // Nothing that is left holds what the generator prints to.
  if (!(await Promise.race([closed, sleep(2000, false)])))
    failures.push(`${signal}: stdout is open`);
}

try {
  mkdirSync(temporary);
  for (const signal of ["SIGKILL", "SIGTERM", "SIGINT", "SIGSEGV"])
    await endsWithItsCommands(signal);
  const endless = writeCourse(
    "endless",
    "int main() {\n  for (volatile int i = 0;; i = 1) {\n  }\n}\n",
  );
  const generator = spawn(mjcourse, endless, { env, stdio: "ignore" });
  if (!(await eventually(programRuns))) failures.push("the program never ran");
  generator.kill("SIGKILL");
  if (!(await eventually(() => !programRuns()))) failures.push("the program runs on");

  if (readdirSync(temporary).length === 0) failures.push("the test is no good: nothing was left");
  // No other run of this test has left a result for it.
  const short = writeCourse("short", `int main() {\n  // ${home}\n}\n`);
  // And by a launcher that does not care for its children's end, as some do.
  const careless = ["-c", `trap '' CHLD; exec "$0" "$@"`, mjcourse, ...short];
  const next = spawnSync("bash", careless, {
    env,
    stdio: ["ignore", "ignore", "inherit"],
  });
  if (next.status !== 0) failures.push("the next check fails");
  const litter = readdirSync(temporary);
  if (litter.length > 0) failures.push(`left behind: ${litter.join(", ")}`);
} finally {
  rmSync(home, { recursive: true });
}
for (const failure of failures) console.error(failure);
console.log(`${failures.length} problems`);
process.exitCode = failures.length > 0 ? 1 : 0;

// What an author's scripts and models are worked on in: a process that is confined, whose end costs
// one block, and that leaves with the generator.
//
//   node tests/system/worker.mjs MJCOURSE

import { spawn } from "node:child_process";
import { globSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { setTimeout as sleep } from "node:timers/promises";

const mjcourse = process.argv[2];
const home = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
const course = join(home, "course");
const failures = [];

function write(path, text) {
  mkdirSync(dirname(join(course, path)), { recursive: true });
  writeFileSync(join(course, path), text);
}

// A lab whose rehearsal takes some seconds, as its buttons count for long.
const slow = `\`\`\`lab simlab
{
  "title": "Slow",
  "model": "ball",
  "alt": "A ball",
  "controls": [
    {"type": "button", "label": "A", "run": "let x = 0; for (let i = 0; i < 6e7; i++) x += Math.sin(i); data.qvel[0] = 0 * x;"},
    {"type": "button", "label": "B", "run": "let x = 0; for (let i = 0; i < 6e7; i++) x += Math.sin(i); data.qvel[0] = 0 * x;"},
    {"type": "button", "label": "C", "run": "let x = 0; for (let i = 0; i < 6e7; i++) x += Math.sin(i); data.qvel[0] = 0 * x;"}
  ]
}
\`\`\`
`;

write(
  "content/course.yaml",
  "title: T\nlevels:\n  - {folder: 1-a, title: A, lessons: [1.1-b, 1.2-c]}\n",
);
write("content/1-a/1.1-b.md", `---\ntitle: B\n---\n\n${slow}`);
write("content/1-a/1.2-c.md", "---\ntitle: C\n---\n\nIt has `{ball} model.nv`.\n");
write(
  "models/ball.xml",
  '<mujoco><worldbody><body><freejoint/><geom size="0.1"/></body></worldbody></mujoco>\n',
);

// With nothing kept.
function begin() {
  const store = mkdtempSync(join(home, "store-"));
  const generator = spawn(
    mjcourse,
    ["check", "--course", course, "--jobs", "1", "--store", store],
    {
      env: { ...process.env, MJCOURSE_TEST_SECRET: "a token" },
    },
  );
  generator.said = "";
  for (const stream of [generator.stdout, generator.stderr]) {
    stream.on("data", (bytes) => (generator.said += bytes));
  }
  generator.ended = new Promise((done) => generator.on("close", done));
  return generator;
}

function read(file) {
  try {
    return readFileSync(file, "utf8");
  } catch {
    return ""; // it has just ended
  }
}

// The workers of this test's course, and what they have started.
function workers() {
  return globSync("/proc/[0-9]*/cmdline")
    .filter((file) => read(file).includes(`\0--work\0${course}\0`))
    .map((file) => Number(file.split("/")[2]));
}

function field(name, id) {
  return new RegExp(`^${name}:\\s+(.*)$`, "m").exec(read(`/proc/${id}/status`))?.[1];
}

async function eventually(holds) {
  for (let tries = 0; tries < 400 && !holds(); ++tries) await sleep(25);
  return holds();
}

function expect(holds, otherwise) {
  if (!holds) failures.push(otherwise);
}

// Until it works on the lab: it has begun, and does nothing but compute.
async function atWork(generator) {
  expect(await eventually(() => workers().length > 0), "no worker was begun");
  await sleep(1500);
  return workers().find((id) => field("PPid", id) === String(generator.pid));
}

try {
  const confined = begin();
  const worker = await atWork(confined);
  expect(field("NoNewPrivs", worker) === "1", "a worker may gain privileges");
  expect(field("Seccomp", worker) === "2", "a worker makes any system call");
  const isRoot = process.getuid() === 0;
  const users = field("Uid", worker);
  expect(!isRoot || !/\b0\b/.test(users), `a worker runs as ${users}`);
  // But for reading what is closed to others, as /root is.
  const rights = BigInt(`0x${field("CapEff", worker)}`) & ~4n;
  expect(rights === 0n, `a worker has the capabilities ${field("CapEff", worker)}`);
  const environment = read(`/proc/${worker}/environ`);
  expect(!isRoot || environment !== "", "a worker's environment cannot be read");
  expect(!environment.includes("MJCOURSE_TEST_SECRET"), "a worker has a secret");

  // The script engine takes a first SIGSEGV for one of its own.
  process.kill(worker, "SIGABRT");
  expect((await confined.ended) === 1, `with a worker that crashed, check ended otherwise`);
  const told = `content/1-a/1.1-b.md:5:1: error: the process that works on this ended with SIGABRT [E-work-crash]`;
  expect(confined.said.includes(told), `of a worker that crashed, check says:\n${confined.said}`);
  expect(
    confined.said.includes("ok    1.2"),
    `the other lesson was not checked:\n${confined.said}`,
  );

  for (const signal of ["SIGKILL", "SIGTERM", "SIGINT"]) {
    const ended = begin();
    await atWork(ended);
    ended.kill(signal);
    await ended.ended;
    expect(await eventually(() => workers().length === 0), `a worker outlives ${signal}`);
  }

  const whole = begin();
  expect((await whole.ended) === 0, `the course is not whole:\n${whole.said}`);
  expect(workers().length === 0, "a worker outlives its generator");
} catch (error) {
  failures.push(error.stack);
} finally {
  rmSync(home, { recursive: true, force: true });
}
for (const failure of failures) console.error(failure);
console.log(`${failures.length} problems`);
process.exitCode = failures.length === 0 ? 0 : 1;
